#include "command.hpp"

#include <csignal>
#include <exception>

#include <fmt/format.h>

namespace {

using namespace tightflip::tools;

int run(int argc, char** argv) {
    CLI::App app("Closed triangulated surfaces and the flips between them.", "tightflip");
    app.set_version_flag("--version", "tightflip " TIGHTFLIP_VERSION);
    app.require_subcommand(0, 1);  // that one is needed is said below, after unknown words
    app.fallthrough();
    app.footer(
        "Exit codes: 0 holds, 1 does not hold, 2 unusable input or usage, 3 stopped undecided.");
    app.failure_message([](const CLI::App* parsed, const CLI::Error& error) {
        return "tightflip: " + CLI::FailureMessage::simple(parsed, error);
    });
    Output output;
    app.add_flag("--json", output.as_json,
                 "One JSON object an input on standard output, messages on standard error");
    Action action;
    for (const auto add : {add_make, add_check, add_campaign, add_flip, add_replay, add_explore,
                           add_path, add_verify, add_canonical, add_isomorphic, add_convert,
                           add_measure, add_render, add_optimise, add_hull, add_info}) {
        add(app, output, action);
    }
    try {
        app.parse(argc, argv);
        if (!action) throw CLI::RequiredError("A verb");
    } catch (const CLI::ParseError& error) {
        const bool was_asked_for = app.exit(error) == 0;  // --help and --version
        return static_cast<int>(Output::finish(was_asked_for ? Exit::holds : Exit::unusable));
    }
    return static_cast<int>(Output::finish(action()));
}

}  // namespace

int main(int argc, char** argv) {
    for (const int signal : {SIGPIPE, SIGXFSZ}) {  // both are reported as failed writes
        static_cast<void>(std::signal(signal, SIG_IGN));
    }
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        Output::complain("not enough memory");
    } catch (const std::exception& error) {
        Output::complain(error.what());
    }
    return static_cast<int>(Exit::unusable);
}
