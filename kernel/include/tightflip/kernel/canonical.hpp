/// \file
/// Canonical codes of surfaces: two surfaces are equal exactly when their codes are.
///
/// \code
///     const Equality unlabelled{.labels = Labels::ignored, .mirror = Mirror::identified};
///     if (canonical_code(a, unlabelled) == canonical_code(b, unlabelled)) ...
///     if (const auto map = isomorphism(a, b, unlabelled)) map->vertices ...
/// \endcode
///
/// How a word is spelled is in rooted_code.hpp, which word is canonical in canonical_search.hpp;
/// time is linear for nearly all surfaces, and for the most symmetric ones a logarithm more.
#pragma once

#include <tightflip/kernel/canonical_search.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <compare>
#include <optional>
#include <string>
#include <vector>

namespace tightflip::kernel {

/// A surface up to isomorphism, as a value. Codes made for different meanings of equality differ.
class CanonicalCode {
public:
    CanonicalCode() = default;  ///< the code of no surface

    [[nodiscard]] Index vertex_count() const noexcept { return vertex_count_; }
    [[nodiscard]] Equality equality() const noexcept { return equality_; }
    /// The word: one symbol an edge and, with labels, one more for each corner of the first face
    /// and each later face.
    [[nodiscard]] std::span<const Index> symbols() const noexcept { return symbols_; }

    friend bool operator==(const CanonicalCode&, const CanonicalCode&) = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the ordering's 0 for a pointer
    friend std::strong_ordering operator<=>(const CanonicalCode&, const CanonicalCode&) = default;

private:
    friend struct CanonicalForm;

    Index vertex_count_ = 0;
    Equality equality_;
    std::vector<Index> symbols_;
};

/// 64 bits that stand for a code: equal for equal codes on every machine.
[[nodiscard]] std::uint64_t digest(const CanonicalCode& code) noexcept;
/// The symbols as numbers with a blank between.
[[nodiscard]] std::string to_string(const CanonicalCode& code);

/// A code together with all roots of one surface that spell it: one orbit of the surface's
/// automorphisms, so as many as there are automorphisms.
struct CanonicalForm {
    CanonicalForm(const Triangulation& surface, Equality equality);

    CanonicalCode code;
    std::vector<Root> roots;
};

[[nodiscard]] CanonicalCode canonical_code(const Triangulation& surface, Equality equality);

/// The order of the automorphism group: the ways in which the surface is equal to itself.
[[nodiscard]] std::size_t automorphism_count(const Triangulation& surface, Equality equality);

/// A map between surfaces that keeps what the equality it was asked for demands. It keeps ends,
/// origin(halfedges[h]) = vertices[origin(h)], and opposite directions. Where orientation is kept
/// it keeps `next`; where it is mirrored the face left of h goes to the face right of the image.
struct Isomorphism {
    std::vector<Halfedge> halfedges;  ///< image of each halfedge
    std::vector<Vertex> vertices;     ///< image of each vertex
    Handedness handedness = Handedness::kept;
};

/// A map from `a` to `b`, where there is one; among several, one that depends on the numbering.
[[nodiscard]] std::optional<Isomorphism> isomorphism(const Triangulation& a, const Triangulation& b,
                                                     Equality equality);

/// The word of the walk from one root; linear time. Throws std::out_of_range where the halfedge
/// does not exist.
[[nodiscard]] std::vector<Index> rooted_code(const Triangulation& surface, Root root,
                                             Labels labels);

/// The surface that a rooted code describes, root at halfedge 0 (see `decode` for the numbers of
/// edges). Vertices carry the labels of the code and without labels are numbered in the order in
/// which the walk meets them. Linear time. Throws std::invalid_argument where no walk over a
/// surface of the allowed class spells the word.
[[nodiscard]] Triangulation surface_of(std::span<const Index> symbols, Labels labels);
[[nodiscard]] Triangulation surface_of(const CanonicalCode& code);

}  // namespace tightflip::kernel

template <>
struct std::hash<tightflip::kernel::CanonicalCode> {
    std::size_t operator()(const tightflip::kernel::CanonicalCode& code) const noexcept {
        return static_cast<std::size_t>(digest(code));
    }
};
