#include <tightflip/kernel/gluing_enumeration.hpp>
#include <tightflip/kernel/rooted_decode.hpp>

#include <array>
#include <stdexcept>
#include <vector>

namespace tightflip::kernel {
namespace {

using Side = std::uint8_t;
using Corner = std::uint8_t;
using Corners = std::uint64_t;  // a set of corners

constexpr Index most_faces = 62;  // three corners are new with the first face, one with each other
constexpr Side no_side = 255;

/// A connected surface with boundary, glued of triangles. A plain value of some 1.6 kB: the search
/// copies it to try a gluing, and has nothing to take back.
class PartialSurface {
public:
    PartialSurface() {
        for (const Side side : {Side{0}, Side{1}, Side{2}}) {
            follow(side, static_cast<Side>((side + 1) % 3));
            corner_[side] = add_corner(Corners{0b111} & ~bit(side));
        }
        sides_ = open_ = 3;
        odd_boundaries_ = 1;
    }

    [[nodiscard]] int sides() const noexcept { return sides_; }
    [[nodiscard]] int open_sides() const noexcept { return open_; }
    [[nodiscard]] int handles() const noexcept { return handles_; }
    /// Vertices that no boundary passes any more.
    [[nodiscard]] int complete_vertices() const noexcept { return complete_vertices_; }
    [[nodiscard]] int odd_boundaries() const noexcept { return odd_boundaries_; }
    [[nodiscard]] bool is_open(Side side) const noexcept { return next_[side] != no_side; }
    /// The open side that follows along the boundary.
    [[nodiscard]] Side next(Side side) const noexcept { return next_[side]; }
    [[nodiscard]] int boundary_length(Side side) const noexcept {
        int length = 1;
        for (Side s = next(side); s != side; s = next(s))
            ++length;
        return length;
    }

    /// Glues a new face, sides numbered from the one glued, to an open side.
    void add_face(Side side) {
        odd_boundaries_ += boundary_length(side) % 2 == 0 ? 1 : -1;
        const auto first = static_cast<Side>(sides_);
        const auto second = static_cast<Side>(sides_ + 1);
        const auto third = static_cast<Side>(sides_ + 2);
        const Corner from = corner_[side];
        const Corner to = end_of(side);
        corner_[first] = to;
        corner_[second] = from;
        corner_[third] = add_corner(members_[vertex_[from]] | members_[vertex_[to]]);
        neighbours_[vertex_[from]] |= bit(corner_[third]);
        neighbours_[vertex_[to]] |= bit(corner_[third]);
        follow(previous_[side], second);
        follow(third, next_[side]);
        follow(second, third);
        next_[first] = next_[side] = no_side;
        sides_ += 3;
        open_ += 1;
    }

    /// Whether gluing two open sides makes no edge a loop. (Of the two pairs of ends that become
    /// one, both ends of one pair are never those of the other: that would be a loop before.)
    [[nodiscard]] bool keeps_ends_distinct(Side s, Side t) const noexcept {
        return may_be_one(corner_[s], end_of(t)) && may_be_one(end_of(s), corner_[t]);
    }

    /// Glues two open sides of one boundary, which falls into two, or of two, which become one.
    /// `between` is the number of sides from s to t along a common boundary.
    void glue_on_one_boundary(Side s, Side t, int length, int between) {
        const int rest = length - 2 - between;
        odd_boundaries_ += between % 2 + rest % 2 - length % 2;
        glue(s, t);
    }
    void glue_two_boundaries(Side s, Side t) {
        const int odd = boundary_length(s) % 2 + boundary_length(t) % 2;
        odd_boundaries_ += odd % 2 - odd;
        ++handles_;
        glue(s, t);
    }

private:
    static constexpr std::size_t most_sides = 3 * std::size_t{most_faces};
    static constexpr std::size_t most_corners = std::size_t{most_faces} + 2;

    static constexpr Corners bit(Corner corner) noexcept { return Corners{1} << corner; }

    [[nodiscard]] Corner end_of(Side side) const noexcept {
        return corner_[side % 3 == 2 ? side - 2 : side + 1];
    }

    Corner add_corner(Corners neighbours) {
        const Corner corner = corners_++;
        vertex_[corner] = corner;
        members_[corner] = bit(corner);
        neighbours_[corner] = neighbours;
        return corner;
    }

    [[nodiscard]] bool may_be_one(Corner a, Corner b) const noexcept {
        return (neighbours_[vertex_[a]] & members_[vertex_[b]]) == 0;
    }

    void make_one(Corner a, Corner b) {
        const Corner kept = vertex_[a];
        const Corner merged = vertex_[b];
        if (kept == merged) {
            ++complete_vertices_;
            return;
        }
        members_[kept] |= members_[merged];
        neighbours_[kept] |= neighbours_[merged];
        for (Corner corner = 0; corner < corners_; ++corner) {
            if (vertex_[corner] == merged) vertex_[corner] = kept;
        }
    }

    void glue(Side s, Side t) {
        make_one(corner_[s], end_of(t));
        make_one(end_of(s), corner_[t]);
        const Side before_s = previous_[s];
        const Side after_s = next_[s];
        follow(before_s, next_[t]);
        follow(previous_[t], after_s);
        next_[s] = next_[t] = no_side;
        open_ -= 2;
    }

    void follow(Side side, Side follower) noexcept {
        next_[side] = follower;
        previous_[follower] = side;
    }

    std::array<Side, most_sides> next_{};      // along the boundary; no_side where glued
    std::array<Side, most_sides> previous_{};  // of open sides
    std::array<Corner, most_sides> corner_{};  // where a side starts
    // Corners that were glued together are one vertex, which has the number of one of them.
    std::array<Corner, most_corners> vertex_{};
    std::array<Corners, most_corners> members_{};     // of a vertex
    std::array<Corners, most_corners> neighbours_{};  // of a vertex, across edges
    Corner corners_ = 0;
    int sides_ = 0;
    int open_ = 0;
    int handles_ = 0;
    int complete_vertices_ = 0;
    int odd_boundaries_ = 0;
};

class Enumeration {
public:
    Enumeration(Index vertices, Index genus, const GluingVisitor& visit)
        : vertices_(vertices),
          genus_(genus),
          faces_(2 * (vertices - 2 + 2 * genus)),
          visit_(visit) {}

    std::uint64_t run() {
        extend(PartialSurface{}, 0);
        return visited_;
    }

private:
    /// Glues the first open side, not before `side`, in all ways; false where the visitor has seen
    /// enough.
    bool extend(const PartialSurface& surface, Side side) {
        if (surface.open_sides() == 0) return conclude();
        while (!surface.is_open(side))
            ++side;
        return add_face(surface, side) && glue_on_one_boundary(surface, side) &&
               glue_two_boundaries(surface, side);
    }

    bool add_face(const PartialSurface& surface, Side side) {
        if (faces_left(surface) == 0) return true;
        PartialSurface larger = surface;
        larger.add_face(side);
        return go_on(larger, side, 0);
    }

    bool glue_on_one_boundary(const PartialSurface& surface, Side side) {
        const int length = surface.boundary_length(side);
        int between = 0;
        for (Side other = surface.next(side); other != side; other = surface.next(other)) {
            if (surface.keeps_ends_distinct(side, other)) {
                PartialSurface glued = surface;
                glued.glue_on_one_boundary(side, other, length, between);
                if (!go_on(glued, side, other)) return false;
            }
            ++between;
        }
        return true;
    }

    bool glue_two_boundaries(const PartialSurface& surface, Side side) {
        if (surface.handles() == genus_) return true;
        std::array<bool, 256> is_near{};
        Side near = side;
        do {
            is_near[near] = true;
            near = surface.next(near);
        } while (near != side);
        for (int number = side + 1; number < surface.sides(); ++number) {
            const auto other = static_cast<Side>(number);
            if (!surface.is_open(other) || is_near[other]) continue;
            if (!surface.keeps_ends_distinct(side, other)) continue;
            PartialSurface glued = surface;
            glued.glue_two_boundaries(side, other);
            if (!go_on(glued, side, other)) return false;
        }
        return true;
    }

    /// Where `side` said `symbol`.
    bool go_on(const PartialSurface& surface, Side side, Index symbol) {
        if (is_hopeless(surface)) return true;
        code_.push_back(symbol);
        const bool goes_on = extend(surface, side);
        code_.pop_back();
        return goes_on;
    }

    [[nodiscard]] bool is_hopeless(const PartialSurface& surface) const {
        // A boundary of odd length needs another face, or joining with a second one.
        const int remedies = faces_left(surface) + 2 * (genus_ - surface.handles());
        if (surface.odd_boundaries() > remedies) return true;
        if (surface.open_sides() == 0) return remedies > 0;
        // The last gluing of all completes two vertices.
        return surface.complete_vertices() > vertices_ - 2;
    }

    [[nodiscard]] int faces_left(const PartialSurface& surface) const {
        return faces_ - surface.sides() / 3;
    }

    bool conclude() {
        ++visited_;
        decode(std::span<const Index>(code_), records_);
        return visit_(records_);
    }

    Index vertices_;
    Index genus_;
    Index faces_;
    const GluingVisitor& visit_;
    std::uint64_t visited_ = 0;
    std::vector<Index> code_;
    std::vector<HalfedgeRecord> records_;
};

}  // namespace

std::uint64_t enumerate_gluings(Index vertices, Index genus, const GluingVisitor& visit) {
    if (vertices < 3 || genus < 0) {
        throw std::invalid_argument(
            "a triangulation without loops has at least 3 vertices and a genus of at least 0");
    }
    if (vertices - 2 > most_faces / 2 || genus > most_faces / 4 ||
        vertices - 2 + 2 * genus > most_faces / 2) {
        throw std::invalid_argument("the enumeration of gluings is made for at most 62 faces");
    }
    return Enumeration(vertices, genus, visit).run();
}

Index largest_quick_enumeration(Index genus) noexcept {
    constexpr std::array<Index, 4> vertices{11, 8, 6, 4};
    return genus >= 0 && genus < static_cast<Index>(vertices.size())
               ? vertices[static_cast<std::size_t>(genus)]
               : 0;
}

}  // namespace tightflip::kernel
