#include "command.hpp"
#include "equality_options.hpp"
#include "surface_input.hpp"
#include <tightflip/kernel/canonical.hpp>

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::Equality;
using kernel::Isomorphism;
using kernel::Labels;
using kernel::Mirror;
using kernel::Triangulation;

struct Options {
    std::string from;
    std::string to;
    EqualityOptions same;
    InputOptions input;
};

/// Why two surfaces are not the same: a stable name (docs/formats.md) and words.
struct Difference {
    std::string name;
    std::string reason;
};

std::vector<kernel::Index> sorted_degrees(const Triangulation& surface) {
    std::vector<kernel::Index> degrees(static_cast<std::size_t>(surface.vertex_count()), 0);
    for (const auto& record : surface.table())
        ++degrees[static_cast<std::size_t>(record.origin.id)];
    std::ranges::sort(degrees);
    return degrees;
}

/// The coarsest difference between two surfaces that are not the same in this sense.
Difference difference(const Triangulation& a, const Triangulation& b, Equality equality) {
    if (a.vertex_count() != b.vertex_count()) {
        return {"vertices", fmt::format("one has {} vertices, the other {}", a.vertex_count(),
                                        b.vertex_count())};
    }
    if (a.genus() != b.genus()) {
        return {"genus", fmt::format("one has genus {}, the other {}", a.genus(), b.genus())};
    }
    const auto degrees_a = sorted_degrees(a);
    const auto degrees_b = sorted_degrees(b);
    if (degrees_a != degrees_b) {
        const auto [in_a, in_b] = std::ranges::mismatch(degrees_a, degrees_b);
        return {"degrees", fmt::format("their degrees differ: in ascending order, number {} is {} "
                                       "in one and {} in the other",
                                       in_a - degrees_a.begin(), *in_a, *in_b)};
    }
    struct Weaker {
        Equality equality;
        Difference difference;
    };
    const std::array<Weaker, 3> weaker{
        {{{equality.labels, Mirror::identified},
          {"orientation", "each is the mirror image of the other (--mirror makes these the same)"}},
         {{Labels::ignored, equality.mirror}, {"labels", "they differ in their labels alone"}},
         {{Labels::ignored, Mirror::identified},
          {"labels_and_orientation", "each is, but for labels, the mirror image of the other"}}}};
    for (const auto& [weak, difference] : weaker) {
        if (kernel::isomorphism(a, b, weak)) return difference;
    }
    return {"gluing", "their degrees agree, but their faces are glued together differently"};
}

std::vector<kernel::Index> vertex_map(const Isomorphism& map) {
    std::vector<kernel::Index> images;
    for (const kernel::Vertex v : map.vertices)
        images.push_back(v.id);
    return images;
}

std::string map_in_words(const std::vector<kernel::Index>& images) {
    constexpr std::size_t most = 100;
    if (images.size() > most) return "  (--json shows where each vertex goes)";
    std::string text = "  vertices go";
    for (std::size_t v = 0; v < images.size(); ++v)
        text += fmt::format(" {}>{}", v, images[v]);
    return text;
}

Exit compare(const Output& output, const Options& options, const Triangulation& a,
             const Triangulation& b) {
    const Equality equality = options.same.equality();
    const std::optional<Isomorphism> map = kernel::isomorphism(a, b, equality);
    Json json{{"from", options.from},
              {"to", options.to},
              {"labelled", options.same.labelled},
              {"mirror", options.same.mirror},
              {"isomorphic", map.has_value()}};
    if (map) {
        const bool mirrored = map->handedness == kernel::Handedness::mirrored;
        const std::vector<kernel::Index> images = vertex_map(*map);
        output.say(fmt::format("{} and {} are isomorphic{}\n{}", options.from, options.to,
                               mirrored ? ", one as the mirror image of the other" : "",
                               map_in_words(images)));
        json["mirrored"] = mirrored;
        json["vertex_map"] = images;
    } else {
        const auto [name, reason] = difference(a, b, equality);
        output.say(
            fmt::format("{} and {} are not isomorphic: {}", options.from, options.to, reason));
        json["difference"] = name;
        json["reason"] = reason;
    }
    output.object(json);
    return map ? Exit::holds : Exit::does_not_hold;
}

Exit read_and_compare(const Output& output, const Options& options) {
    std::vector<Triangulation> surfaces;
    const Exit read =
        for_each_input(output, {options.from, options.to}, [&](const std::string& file) {
            surfaces.push_back(SurfaceInput(file, options.input).triangulation());
            return Exit::holds;
        });
    if (read != Exit::holds) return read;
    return compare(output, options, surfaces[0], surfaces[1]);
}

}  // namespace

void add_isomorphic(CLI::App& app, const Output& output, Action& action) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand(
        "isomorphic", "Whether two surfaces are the same, and by which map of their vertices");
    verb->add_option("A", options->from, "Surface or mesh")->required();
    verb->add_option("B", options->to, "Surface or mesh")->required();
    options->same.add(*verb);
    options->input.add_triangulate(*verb);
    options->input.add_reorient(*verb);
    verb->callback([&output, &action, options] {
        action = [&output, options] { return read_and_compare(output, *options); };
    });
}

}  // namespace tightflip::tools
