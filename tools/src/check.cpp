#include "command.hpp"
#include "report.hpp"
#include "surface_input.hpp"

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

struct Options {
    std::vector<std::string> files;
    InputOptions input;
};

Exit check(const Output& output, const Options& options, const std::string& file) {
    const SurfaceInput input(file, options.input);
    const kernel::AuditReport report = input.audit();
    const PlaceInWords where = [&](const kernel::Violation& v) { return input.where(v); };
    output.say(fmt::format("{}: {}", file, report_in_words(report, where)));
    input.say_repairs(output);
    Json json{{"file", file}, {"format", input.format()}};
    json.update(to_json(report, where));
    input.add_repairs(json);
    output.object(json);
    return report.is_valid() ? Exit::holds : Exit::does_not_hold;
}

}  // namespace

void add_check(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "check", "Audit surfaces: are they closed, connected, orientable manifolds?");
    verb->add_option("FILE", options->files, "Surfaces or meshes (OBJ, OFF, PLY, STL)")->required();
    options->input.add_triangulate(*verb);
    options->input.add_repair(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            return for_each_input(output, options->files, [&](const std::string& file) {
                return check(output, *options, file);
            });
        };
    });
}

}  // namespace tightflip::tools
