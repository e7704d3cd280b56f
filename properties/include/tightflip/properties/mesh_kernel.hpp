/// \file
/// What a mesh kernel must answer to be tested: the concept that the conformance suite stands on.
///
/// \code
///     struct MyKernel {                                            // the adaptor of a mesh
///         static constexpr std::string_view name = "my mesh";
///         static constexpr KernelClass allowed = KernelClass::simple;
///         using Side = MyMesh::Halfedge;
///         MyKernel(Index vertices, std::span<const std::array<Index, 3>> faces);
///         std::array<Index, 3> counts() const;                     // vertices, edges, faces
///         std::vector<Side> sides() const;
///         Side next(Side s) const;
///         Side across(Side s) const;
///         Index origin(Side s) const;
///         bool can_flip(Side s) const;
///         void flip(Side s);
///         bool is_valid() const;
///     };
/// \endcode
#pragma once

#include <tightflip/kernel/gluing.hpp>

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <vector>

namespace tightflip::properties {

using kernel::Gluing;
using kernel::Index;

/// What a kernel promises to hold, and is judged by. All are closed, connected and oriented.
enum class KernelClass : std::uint8_t {
    simple,         ///< the graph is simple: neither loops nor parallel edges
    loopless,       ///< Definition 4.1: parallel edges and vertices of degree 2 are allowed
    delta_complex,  ///< loops are allowed too
};

/// "simple", "loopless", "delta-complex".
[[nodiscard]] std::string_view name(KernelClass kernel_class) noexcept;

/// A kernel with half-edges, or with faces and their neighbours. A `Side` is one side of one face:
/// a half-edge, or a face and a number; any type with copies and an order `<`. The kernel is made
/// from the corners of its faces, counter-clockwise, and numbers its vertices as they do.
///
/// * `sides()`: the three sides of every face, in any order; after any flips the same ones, of
/// which
///   `next` and `across` name no others;
/// * `next(s)`: the following side of the same face, counter-clockwise;
/// * `across(s)`: the other side of the same edge;
/// * `origin(s)`: the vertex where the side begins;
/// * `can_flip(s)`: whether the kernel says that the edge of `s` may be flipped;
/// * `flip(s)`: flips it; only called after a yes;
/// * `is_valid()`: the kernel's own validator.
template <class K>
concept MeshKernel = std::copyable<typename K::Side> &&
    std::constructible_from<K, Index, std::span<const std::array<Index, 3>>> &&
    requires(K mesh, const K& view, const typename K::Side& side, const typename K::Side& other) {
    { side < other } -> std::convertible_to<bool>;
    { K::name } -> std::convertible_to<std::string_view>;
    { K::allowed } -> std::convertible_to<KernelClass>;
    { view.counts() } -> std::convertible_to<std::array<Index, 3>>;
    { view.sides() } -> std::convertible_to<std::vector<typename K::Side>>;
    { view.next(side) } -> std::convertible_to<typename K::Side>;
    { view.across(side) } -> std::convertible_to<typename K::Side>;
    { view.origin(side) } -> std::convertible_to<Index>;
    { view.can_flip(side) } -> std::convertible_to<bool>;
    mesh.flip(side);
    { view.is_valid() } -> std::convertible_to<bool>;
};

/// A kernel that can be made from a gluing, and so start where a face list is ambiguous. It may
/// throw where the gluing is beyond its class.
template <class K>
concept StartsFromGluings = std::constructible_from<K, const Gluing&>;

/// A kernel that lets a test damage it, so that its validator has something to find. Any of the
/// three may be missing: origins and one of the others are enough to make forbidden edges.
template <class K>
concept TakesWrongOrigins = requires(K mesh, typename K::Side side) {
    mesh.set_origin(side, Index{});
};
template <class K>
concept TakesWrongNexts = requires(K mesh, typename K::Side side) {
    mesh.set_next(side, side);
};
template <class K>
concept TakesWrongNeighbours = requires(K mesh, typename K::Side side) {
    mesh.set_across(side, side);
};

/// Whether the kernel promises that sides of other edges keep their meaning through a flip. Assumed
/// unless the adaptor says `static constexpr bool keeps_sides = false;`, as kernels do whose sides
/// are places in a face.
template <class K>
[[nodiscard]] constexpr bool keeps_sides() noexcept {
    if constexpr (requires { K::keeps_sides; }) {
        return K::keeps_sides;
    } else {
        return true;
    }
}

}  // namespace tightflip::properties
