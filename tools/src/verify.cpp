#include "command.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <array>
#include <chrono>
#include <future>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::CertificateVerdict;
using kernel::RawFlipLog;
using kernel::RawTable;

struct Options {
    std::string from;
    std::string to;
    std::string log;
    InputOptions input;
};

/// The three inputs, read side by side.
class Inputs {
public:
    explicit Inputs(const Options& options)
        : from_(read_table(options.from, options.input)),
          to_(read_table(options.to, options.input)),
          log_(std::async(std::launch::async, [&options] {
              return kernel::parse_flip_log_as_written(kernel::read_file(options.log), options.log);
          })) {}

    /// Whether all could be used; says of each why not.
    Exit wait(const Output& output, const Options& options) {
        const std::array<std::function<void()>, 3> waits{[this] { from = from_.get(); },
                                                         [this] { to = to_.get(); },
                                                         [this] { log = log_.get(); }};
        auto next = waits.begin();
        return for_each_input(output, {options.from, options.to, options.log},
                              [&](const std::string&) {
                                  const auto& wait_for = *next++;
                                  wait_for();
                                  return Exit::holds;
                              });
    }

    RawTable from;
    RawTable to;
    RawFlipLog log;

private:
    static std::future<RawTable> read_table(const std::string& path, const InputOptions& options) {
        return std::async(std::launch::async,
                          [&path, &options] { return SurfaceInput(path, options).table(); });
    }

    std::future<RawTable> from_;
    std::future<RawTable> to_;
    std::future<RawFlipLog> log_;
};

Exit verify_files(const Output& output, const Options& options) {
    const auto started = std::chrono::steady_clock::now();
    Inputs inputs(options);
    if (const Exit exit = inputs.wait(output, options); exit != Exit::holds) return exit;
    const CertificateVerdict verdict = kernel::verify(inputs.from, inputs.to, inputs.log);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;

    Json json{{"from", options.from},
              {"to", options.to},
              {"log", options.log},
              {"verdict", verdict ? "holds" : "refused"},
              {"vertices", inputs.from.vertex_count},
              {"flips", inputs.log.flips.size()},
              {"flips_done", verdict.flips_done},
              {"seconds", elapsed.count()}};
    if (!verdict) {
        json["fault"] = name(verdict.fault);
        json["reason"] = verdict.reason;
        Output::complain(fmt::format("{} does not lead from {} to {}: {}", options.log,
                                     options.from, options.to, verdict.reason));
    } else {
        output.say(fmt::format("{}: holds: {} flips lead from {} to {} ({:.1f} s)", options.log,
                               verdict.flips_done, options.from, options.to, elapsed.count()));
    }
    output.object(json);
    return verdict ? Exit::holds : Exit::unusable;
}

}  // namespace

void add_verify(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "verify", "Whether a flip log leads from one labelled surface to another");
    verb->add_option("A", options->from, "The surface it should start from")->required();
    verb->add_option("B", options->to, "The surface it should lead to")->required();
    verb->add_option("LOG", options->log, "The flip log, exactly as it was written")->required();
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] { return verify_files(output, *options); };
    });
}

}  // namespace tightflip::tools
