/// \file
/// Starts and scripts by description: what the command's `make`, the property tests and the fuzz
/// targets generate from.
#pragma once

#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/finding.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tightflip::properties {

/// What to generate; a kind uses what it needs.
struct StartRequest {
    Index vertices = 4;
    Index genus = 0;
    std::uint64_t seed = 0;
};

/// A named kind of start.
struct StartKind {
    std::string_view name;
    std::string_view description;
    /// Of the request, what the kind needs: the least size it takes for a genus, and whether the
    /// genus can be chosen.
    Index (*least_vertices)(Index genus);
    bool any_genus;
    /// The surface; throws std::invalid_argument naming the range for sizes it cannot have. Linear
    /// time; but `simple` walks round a vertex at each of its 20 attempts an edge, which takes 6 to
    /// 20 times as long as `random` does for 3,000 to 48,000 vertices, and longer at large genus.
    Triangulation (*make)(const StartRequest& request);
};

/// All kinds, in a fixed order (byte strings of the fuzz targets refer to it; only append).
[[nodiscard]] std::span<const StartKind> start_kinds() noexcept;
/// The kind of that name, or nullptr.
[[nodiscard]] const StartKind* find_start_kind(std::string_view name) noexcept;

/// The largest size not above `request.vertices` that the kind can have, or its smallest. Costs
/// what making it costs, and an exception of some microseconds for every size on the way down: at
/// most two for most kinds, thousands for `tetrahedron`, `octasphere` and `icosphere` of thousands
/// of vertices.
[[nodiscard]] Triangulation make_nearest(const StartKind& kind, StartRequest request);

/// `length` edges drawn uniformly from the edges of a surface: refused flips among them. Linear
/// time in the length.
[[nodiscard]] FlipScript random_script(const Triangulation& start, std::size_t length,
                                       kernel::RandomStream& random);

/// The flips of a script that are done, without those that are refused: each is defined when its
/// turn comes. Linear time in the script, beside a copy of the start.
[[nodiscard]] FlipScript without_refused(Triangulation start, std::span<const Edge> script);

}  // namespace tightflip::properties
