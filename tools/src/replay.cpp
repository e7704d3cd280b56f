#include "command.hpp"
#include "report.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/properties/claims.hpp>

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::FlipLog;

struct Options {
    std::vector<std::string> logs;
    std::size_t audit_every = 0;
    std::string output_file;
};

/// Why a log does not hold; empty where it does.
std::string objection(const FlipLog& log, const kernel::Replay& result,
                      const std::optional<properties::Finding>& finding) {
    if (finding) return properties::describe(*finding);
    if (result.is_complete()) return {};
    return fmt::format("flip {} of {}: {}", result.done + 1, log.flips.size(), result.reason);
}

Exit replay_one(const Output& output, const Options& options, const std::string& file) {
    const FlipLog log = kernel::parse_flip_log(kernel::read_file(file), file);
    const auto finding =
        properties::topology_is_preserved(log.start, log.flips, options.audit_every);
    const kernel::Replay result = replay(log);
    const std::string objected = objection(log, result, finding);
    Json json{{"file", file},
              {"verdict", objected.empty() ? "holds" : "violated"},
              {"vertices", log.start.vertex_count()},
              {"genus", log.start.genus()},
              {"flips", log.flips.size()},
              {"flips_done", result.done},
              {"violations", Json::array()}};
    if (finding) {
        json["violations"].push_back(
            to_json(finding->violation, [](const kernel::Violation& v) { return where(v); }));
        json["step"] = finding->step;
    }
    if (!objected.empty()) json["reason"] = objected;
    if (objected.empty() && !options.output_file.empty()) {
        kernel::write_file(options.output_file,
                           [&](std::ostream& out) { write_text(out, result.surface); });
        json["output"] = options.output_file;
    }
    output.say(objected.empty() ? fmt::format("{}: holds: {} flips on {} vertices, each checked",
                                              file, log.flips.size(), log.start.vertex_count())
                                : fmt::format("{}: does not hold: {}", file, objected));
    output.object(json);
    return objected.empty() ? Exit::holds : Exit::does_not_hold;
}

}  // namespace

void add_replay(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb =
        app.add_subcommand("replay", "Follow a flip log, checking every flip and auditing its end");
    verb->add_option("LOG", options->logs, "Flip logs, text or binary")->required();
    verb->add_option("--audit-every", options->audit_every,
                     "Full audits in between, every so many flips (only at the end)")
        ->check(whole_number(1));
    verb->add_option("-o,--output", options->output_file, "Write the last surface here");
    verb->callback([&output, &action, options] {
        if (options->logs.size() > 1 && !options->output_file.empty()) {
            throw CLI::ValidationError("--output", "takes one log at a time");
        }
        action = [&output, options] {
            return for_each_input(output, options->logs, [&](const std::string& log) {
                return replay_one(output, *options, log);
            });
        };
    });
}

}  // namespace tightflip::tools
