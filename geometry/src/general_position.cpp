#include "surface_face.hpp"
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/general_position.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tightflip::geometry {
namespace {

template <std::size_t size>
using Labels = std::array<Vertex, size>;

bool are_collinear_triple(Points points, const Labels<3>& t) {
    const auto point = [&](std::size_t i) -> const Point& {
        return points[static_cast<std::size_t>(t.at(i).id)];
    };
    return point(0) != point(1) && point(1) != point(2) && point(2) != point(0) &&
           are_collinear(point(0), point(1), point(2));
}

bool are_coplanar_quadruple(Points points, const Labels<4>& q) {
    const auto point = [&](std::size_t i) -> const Point& {
        return points[static_cast<std::size_t>(q.at(i).id)];
    };
    if (orientation(point(0), point(1), point(2), point(3)) != Sign::zero) return false;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        if (are_collinear(point(left_out == 0 ? 1 : 0), point(left_out <= 1 ? 2 : 1),
                          point(left_out <= 2 ? 3 : 2))) {
            return false;
        }
    }
    return true;
}

/// Adds a set to those counted and, as long as there is room, listed; sets come in ascending order.
template <std::size_t size>
void add(OffendingSets<size>& sets, const Labels<size>& labels, std::size_t kept) {
    ++sets.count;
    if (sets.first.size() < kept) sets.first.push_back(labels);
}

/// All pairs of equal points, with the points sorted so that equal ones are neighbours.
OffendingSets<2> coincident_pairs(Points points, std::size_t kept) {
    std::vector<Vertex> order(points.size());
    for (std::size_t v = 0; v < order.size(); ++v)
        order[v] = {static_cast<Index>(v)};
    const auto point = [&](Vertex v) -> const Point& {
        return points[static_cast<std::size_t>(v.id)];
    };
    std::ranges::sort(order, [&](Vertex u, Vertex v) {
        const Point& p = point(u);
        const Point& q = point(v);
        return std::tie(p.x(), p.y(), p.z(), u) < std::tie(q.x(), q.y(), q.z(), v);
    });
    OffendingSets<2> pairs;
    for (auto begin = order.begin(); begin != order.end();) {
        const auto end =
            std::find_if(begin, order.end(), [&](Vertex v) { return point(v) != point(*begin); });
        const auto size = static_cast<std::int64_t>(end - begin);
        pairs.count += size * (size - 1) / 2;
        // Of the pairs of one class the first `kept` are enough: so many first ones at most are
        // listed.
        std::size_t room = kept;
        for (auto u = begin; u != end && room > 0; ++u) {
            for (auto v = u + 1; v != end && room > 0; ++v, --room)
                pairs.first.push_back({*u, *v});
        }
        begin = end;
    }
    std::ranges::sort(pairs.first);
    if (pairs.first.size() > kept) pairs.first.resize(kept);
    return pairs;
}

/// The offenders among sets that come in any order and more than once.
template <std::size_t size, class IsOffence>
OffendingSets<size> offenders(std::vector<Labels<size>> sets, std::size_t kept,
                              const IsOffence& is_offence) {
    for (Labels<size>& labels : sets)
        std::ranges::sort(labels);
    std::ranges::sort(sets);
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    OffendingSets<size> result;
    for (const Labels<size>& labels : sets) {
        if (is_offence(labels)) add(result, labels, kept);
    }
    return result;
}

GeneralPosition position_in_flips(const SurfaceView& surface, std::size_t kept) {
    std::vector<Labels<3>> triples;
    std::vector<Labels<4>> quadruples;
    const auto edges = static_cast<std::size_t>(surface.edge_count());
    triples.reserve(4 * edges);
    quadruples.reserve(edges);
    for (Index id = 0; id < surface.edge_count(); ++id) {
        const Halfedge h = halfedge_of(Edge{id});
        const auto [a, b, c] = SurfaceFace::at(surface, h).corners;
        const Vertex d = SurfaceFace::at(surface, twin(h)).corners[2];
        triples.insert(triples.end(), {{a, b, c}, {a, b, d}});
        if (c == d) continue;
        triples.insert(triples.end(), {{a, c, d}, {b, c, d}});
        quadruples.push_back({a, b, c, d});
    }
    GeneralPosition result;
    result.scope = PositionScope::flips;
    result.coincident = coincident_pairs(surface.points, kept);
    result.collinear = offenders(std::move(triples), kept, [&](const Labels<3>& labels) {
        return are_collinear_triple(surface.points, labels);
    });
    result.coplanar = offenders(std::move(quadruples), kept, [&](const Labels<4>& labels) {
        return are_coplanar_quadruple(surface.points, labels);
    });
    return result;
}

}  // namespace

GeneralPosition general_position(Points points, std::size_t kept) {
    GeneralPosition result;
    result.coincident = coincident_pairs(points, kept);
    const auto n = static_cast<Index>(points.size());
    for (Index a = 0; a < n; ++a) {
        for (Index b = a + 1; b < n; ++b) {
            for (Index c = b + 1; c < n; ++c) {
                const Labels<3> triple{{{a}, {b}, {c}}};
                if (are_collinear_triple(points, triple)) add(result.collinear, triple, kept);
                for (Index d = c + 1; d < n; ++d) {
                    const Labels<4> quadruple{{{a}, {b}, {c}, {d}}};
                    if (are_coplanar_quadruple(points, quadruple)) {
                        add(result.coplanar, quadruple, kept);
                    }
                }
            }
        }
    }
    return result;
}

GeneralPosition general_position(const SurfaceView& surface,
                                 const GeneralPositionOptions& options) {
    return surface.points.size() <= options.all_up_to
               ? general_position(surface.points, options.kept)
               : position_in_flips(surface, options.kept);
}

}  // namespace tightflip::geometry
