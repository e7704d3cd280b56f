#include "face_list.hpp"
#include "star_pairs.hpp"
#include <tightflip/geometry/surface_values.hpp>
#include <tightflip/geometry/value_names.hpp>
#include <tightflip/kernel/plain_writer.hpp>

#include <initializer_list>
#include <string_view>

namespace tightflip::geometry {
namespace {

using kernel::PlainWriter;

std::vector<Index> degrees(const SurfaceView& surface) {
    std::vector<Index> degree(surface.points.size(), 0);
    for (const kernel::HalfedgeRecord& record : surface.table) {
        ++degree[static_cast<std::size_t>(record.origin.id)];
    }
    return degree;
}

PlainWriter& put(PlainWriter& text, std::initializer_list<double> values, char separator) {
    for (const double value : values)
        text << value << separator;
    return text;
}

/// A point and its curvatures, each with a separator behind it.
void put_vertex(PlainWriter& text, const Point& p, const VertexCurvature& c, char separator) {
    put(text, {p.x(), p.y(), p.z()}, separator);
    put(text, {c.total_angle, c.deficit(), c.positive, c.negative, c.absolute()}, separator);
}

}  // namespace

std::vector<VertexCurvature> vertex_curvatures(const SurfaceView& surface) {
    std::vector<VertexCurvature> curvatures;
    curvatures.reserve(surface.points.size());
    StarMeter meter;
    for (const Halfedge h : halfedge_of_each_vertex(surface))
        curvatures.push_back(meter.measure(surface, h));
    return curvatures;
}

EdgeValues edge_values(const SurfaceView& surface, Edge e) {
    const Hinge hinge = Hinge::at(surface, e);
    const EdgeShape shape = edge_shape(hinge);
    return {.length = length(surface, e),
            .exterior_angle = exterior_angle(hinge, shape),
            .shape = shape,
            .quadrilateral = quadrilateral_type(surface, e)};
}

void write_vertices_csv(std::ostream& out, const SurfaceView& surface) {
    PlainWriter text(out);
    text << "vertex,degree,x,y,z,theta,omega,omega_positive,omega_negative,omega_absolute,type\n";
    const std::vector<Index> degree = degrees(surface);
    const std::vector<VertexCurvature> curvatures = vertex_curvatures(surface);
    for (std::size_t v = 0; v < curvatures.size(); ++v) {
        text << v << ',' << degree[v] << ',';
        put_vertex(text, surface.points[v], curvatures[v], ',');
        text << name(curvatures[v].type) << '\n';
    }
}

void write_edges_csv(std::ostream& out, const SurfaceView& surface) {
    PlainWriter text(out);
    text << "edge,origin,target,length,exterior_angle,mean_curvature,shape,quadrilateral\n";
    for (Index id = 0; id < surface.edge_count(); ++id) {
        const Halfedge h = halfedge_of(Edge{id});
        const EdgeValues values = edge_values(surface, Edge{id});
        text << id << ',' << at(surface.table, h).origin.id << ','
             << at(surface.table, twin(h)).origin.id << ',';
        put(text, {values.length, values.exterior_angle, values.mean_curvature()}, ',')
            << name(values.shape) << ',' << name(values.quadrilateral) << '\n';
    }
}

void write_ply_with_values(std::ostream& out, const SurfaceView& surface) {
    const std::vector<FaceCorners> faces = corners_of_faces(surface.table);
    PlainWriter text(out);
    text << "ply\nformat ascii 1.0\ncomment vertex_type: 0 convex, 1 saddle, 2 mixed, 3 flat\n"
         << "element vertex " << surface.points.size() << '\n';
    for (const std::string_view property :
         {"x", "y", "z", "theta", "omega", "omega_positive", "omega_negative", "omega_absolute"}) {
        text << "property double " << property << '\n';
    }
    text << "property uchar vertex_type\nelement face " << faces.size()
         << "\nproperty list uchar int vertex_indices\nproperty list uchar int glued_sides\n"
         << "end_header\n";
    const std::vector<VertexCurvature> curvatures = vertex_curvatures(surface);
    for (std::size_t v = 0; v < curvatures.size(); ++v) {
        put_vertex(text, surface.points[v], curvatures[v], ' ');
        text << static_cast<int>(curvatures[v].type) << '\n';
    }
    const std::vector<FaceCorners> glued = glued_sides_of_faces(surface.table);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        text << 3;
        for (const Index corner : faces[f])
            text << ' ' << corner;
        text << " 3";
        for (const Index side : glued[f])
            text << ' ' << side;
        text << '\n';
    }
}

}  // namespace tightflip::geometry
