/// \file
/// A flip path between any two labelled triangulations of the sphere: Theorem 4.3, constructively.
///
/// \code
///     if (ConnectResult found = connect(a, b)) write_binary(out, found.value());
/// \endcode
#pragma once

#include <tightflip/kernel/flip_log.hpp>

#include <optional>
#include <string_view>

namespace tightflip::kernel {

/// Why no path is looked for. Values are stable.
enum class ConnectRefusal : std::uint8_t {
    none = 0,
    different_vertex_counts = 1,  ///< flips keep V
    different_genus = 2,          ///< flips keep the genus
    not_a_sphere = 3,             ///< the construction is for genus 0
};

/// A refusal in one line of plain words; empty for `none`.
[[nodiscard]] std::string_view describe(ConnectRefusal refusal) noexcept;

/// A path, or why there is none.
struct ConnectResult {
    std::optional<FlipLog> path;
    ConnectRefusal refusal = ConnectRefusal::none;

    [[nodiscard]] explicit operator bool() const noexcept { return path.has_value(); }
    /// The path; throws std::invalid_argument with the refusal where there is none.
    [[nodiscard]] const FlipLog& value() const&;
    [[nodiscard]] FlipLog&& value() &&;
};

/// The most flips a path between two spheres with V vertices takes:
/// 2 (V - 2) ceil(log2(V - 2)) + 8 V - 24. (Sleator, Tarjan and Thurston, SIAM J. Discrete Math. 5
/// (1992): labelled triangulations are up to a constant times V log V flips apart.)
[[nodiscard]] std::int64_t connect_bound(Index vertices) noexcept;

/// A path from the table of `from` to `to`: its replay ends in a surface that is the same labelled
/// surface as `to` (vertices keep their labels; numbers of halfedges may differ). Empty where the
/// two already are; never longer than `connect_bound`. Every flip is made and its verdict looked
/// at. O(V log V) time; memory for both tables and the path, 4 bytes a flip.
///
/// Both surfaces are gathered at one hub (gather.hpp), which leaves a plane tree beside the hub's
/// spokes. The tree of `to` is drawn out into a path in the order of a walk; that of `from` is
/// spread into a book, whose pages are merged into the path of the same order. Then the two are one
/// surface, and the flips of `to` lead from there to it backwards: taking a flip back gives the
/// same surface as flipping the edge again, but for the names of its two halves, so the numbers of
/// edges are all there is to translate.
[[nodiscard]] ConnectResult connect(const Triangulation& from, const Triangulation& to);

}  // namespace tightflip::kernel
