#include "command.hpp"
#include "equality_options.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/canonical.hpp>

#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

struct Options {
    std::vector<std::string> files;
    EqualityOptions same;
    InputOptions input;
};

Exit canonical(const Output& output, const Options& options, const std::string& file) {
    const kernel::Triangulation surface = SurfaceInput(file, options.input).triangulation();
    const kernel::CanonicalForm form(surface, options.same.equality());
    const std::string digits = fmt::format("{:016x}", digest(form.code));
    output.say(fmt::format("{}: {} ({} vertices, genus {}, {} automorphism{})", file, digits,
                           surface.vertex_count(), surface.genus(), form.roots.size(),
                           form.roots.size() == 1 ? "" : "s"));
    if (!output.as_json) return Exit::holds;
    output.object({{"file", file},
                   {"vertices", surface.vertex_count()},
                   {"genus", surface.genus()},
                   {"labelled", options.same.labelled},
                   {"mirror", options.same.mirror},
                   {"automorphisms", form.roots.size()},
                   {"digest", digits},
                   {"code", form.code.symbols()}});
    return Exit::holds;
}

}  // namespace

void add_canonical(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "canonical",
        "Canonical codes and symmetries: surfaces are the same exactly when their "
        "codes are");
    verb->add_option("FILE", options->files, "Surfaces or meshes")->required();
    options->same.add(*verb);
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] {
            return for_each_input(output, options->files, [&](const std::string& file) {
                return canonical(output, *options, file);
            });
        };
    });
}

}  // namespace tightflip::tools
