#include "mesh_samples.hpp"

#include "reading.hpp"
#include "seed_surfaces.hpp"
#include <tightflip/geometry/mesh_writer.hpp>
#include <tightflip/kernel/families.hpp>

#include <array>
#include <ostream>

namespace tightflip::fuzz {
namespace {

using geometry::MeshEncoding;
using geometry::MeshFormat;
using geometry::Point;

struct Sample {
    const char* name;
    const char* format;
    const char* text;
};

/// What no writer writes. (Text; the binary ones are made below.)
constexpr std::array samples{
    Sample{"obj_all_sorts", "obj",
           "# c\nmtllib m\nv 0 0 0 1\nv 1 0 0 1 .5 .5 .5\nv 0 1 +0\nv 0 0 1.\nvt 0 0\nvn 0 0 1\n"
           "o x\ng a b\ns off\nusemtl m\nf 1/1/1 3//1 2/1\nf -4 -3 -1\nl 1 2\np 1\n"
           "f 2 3 \\\n 4\nf 3 1 4\n"},
    Sample{"obj_polygon", "obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\n"},
    Sample{"obj_front_and_back", "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"},
    Sample{"obj_corner_zero", "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"},
    Sample{"obj_corner_missing", "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
    Sample{"obj_corner_before_the_first", "obj", "v 0 0 0\nf -1 -2 -3\n"},
    Sample{"obj_corner_huge", "obj", "v 0 0 0\nf 1 2 99999999999999999999\n"},
    Sample{"obj_corner_with_a_slash_too_many", "obj", "v 0 0 0\nf 1/2/3/4 1 1\n"},
    Sample{"obj_face_of_two", "obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"},
    Sample{"obj_repeated_corner", "obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n"},
    Sample{"obj_not_finite", "obj", "v nan 0 0\n"},
    Sample{"obj_curve", "obj", "v 0 0 0\ncurv 0 1 1 1\n"},
    Sample{"obj_call", "obj", "call other.obj\n"},
    Sample{"obj_coordinate_missing", "obj", "v 0 0\n"},
    Sample{"obj_coordinate_too_many", "obj", "v 1 0 0 1 1 1 1 1\n"},
    Sample{"obj_backslash_at_the_end", "obj", "v 0 0 0\\"},
    Sample{"off_on_one_line", "off", "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"},
    Sample{"off_glued_keyword", "off", "OFF3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"},
    Sample{"off_without_keyword", "off", "3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"},
    Sample{"off_comments", "off",
           "# c\nOFF # c\n\n3 2 0 # c\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 0\n3 2 1 0\n"},
    Sample{"off_colours", "off",
           "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n"},
    Sample{"off_all_letters", "off",
           "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 0 0\n"
           "0 1 0 0 0 1 1 1 1 1 0 0\n3 0 1 2\n"},
    Sample{"off_polygon", "off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 9 9 9\n"},
    Sample{"off_four_dimensions", "off", "4OFF\n1 0 0\n0 0 0 0\n"},
    Sample{"off_n_dimensions", "off", "nOFF 3\n1 0 0\n0 0 0\n"},
    Sample{"off_binary", "off", "OFF BINARY\n\1\2\3"},
    Sample{"off_no_faces", "off", "OFF\n1 0 0\n0 0 0\n"},
    Sample{"off_more_vertices_than_bytes", "off", "OFF\n4000000000 1 0\n0 0 0\n"},
    Sample{"off_more_faces_than_bytes", "off", "OFF\n1 2000000000 0\n0 0 0\n"},
    Sample{"off_counts_beyond_numbers", "off", "OFF\n9223372036854775807 9223372036854775807 0\n"},
    Sample{"off_negative_count", "off", "OFF\n-4 4 6\n"},
    Sample{"off_corner_missing", "off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
    Sample{"off_face_of_two", "off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"},
    Sample{"off_face_huge", "off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1\n"},
    Sample{"off_cut", "off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
    Sample{"off_more_at_the_end", "off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"},
    Sample{"ply_extra_elements", "ply",
           "ply\nformat ascii 1.0\ncomment x\nobj_info y\nelement material 1\nproperty list uchar "
           "int numbers\nelement vertex 3\nproperty double z\nproperty uchar red\nproperty double "
           "x\nproperty double y\nelement face 2\nproperty uchar flags\nproperty list uchar uint "
           "vertex_index\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
           "2 7 8\n0 255 0 0\n0 0 1 0\n0 0 0 1\n1 3 0 1 2\n1 3 2 1 0\n0 1\n"},
    Sample{"ply_glued_sides", "ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar "
           "int glued_sides\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 3 5 4 3\n3 0 2 1 3 2 1 0\n"},
    Sample{"ply_glued_to_nothing", "ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar "
           "int glued_sides\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 3 -1 -1 9\n"},
    Sample{"ply_glued_list_too_short", "ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar "
           "int glued_sides\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 2 -1 -1\n"},
    Sample{"ply_no_header_end", "ply", "ply\nformat ascii 1.0\n"},
    Sample{"ply_unknown_format", "ply", "ply\nformat ebcdic 1.0\nend_header\n"},
    Sample{"ply_unknown_version", "ply", "ply\nformat ascii 2.0\nend_header\n"},
    Sample{"ply_unknown_type", "ply",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n0\n"},
    Sample{"ply_property_without_element", "ply",
           "ply\nformat ascii 1.0\nproperty float x\nend_header\n"},
    Sample{"ply_property_twice", "ply",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
           "x\nend_header\n0 0\n"},
    Sample{"ply_coordinate_missing", "ply",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
           "y\nend_header\n0 0\n"},
    Sample{"ply_coordinate_as_a_list", "ply",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float x\nproperty float "
           "y\nproperty float z\nend_header\n1 0 0 0\n"},
    Sample{"ply_more_vertices_than_bytes", "ply",
           "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float "
           "x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
           "vertex_indices\nend_header\n"},
    Sample{"ply_elements_of_no_size", "ply",
           "ply\nformat binary_little_endian 1.0\nelement nothing 4000000000\nelement vertex "
           "0\nproperty float x\nproperty float y\nproperty float z\nend_header\n"},
    Sample{"ply_list_longer_than_the_file", "ply",
           "ply\nformat binary_big_endian 1.0\nelement vertex 0\nproperty float x\nproperty float "
           "y\nproperty float z\nelement face 1\nproperty list uint int vertex_indices\n"
           "end_header\n\xff\xff\xff\xff"},
    Sample{"ply_strips", "ply",
           "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
           "float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 "
           "0\n3 0 0 0\n"},
    Sample{
        "ply_index_as_a_float", "ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar float vertex_indices\nend_header\n0 0 0\n1 "
        "0 0\n0 1 0\n3 0 1 2\n"},
    Sample{"stl_two_solids", "stl",
           "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
           "0\nendloop\nendfacet\nendsolid a\nsolid b\nfacet normal 0 0 0\nouter loop\nvertex 0 1 "
           "0\nvertex 1 0 0\nvertex 0 0 -0\nendloop\nendfacet\nendsolid\n"},
    Sample{
        "stl_polygon", "stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex "
        "0 1 0\nendloop\nendfacet\nendsolid\n"},
    Sample{"stl_cut", "stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"},
    Sample{"stl_wrong_word", "stl", "solid x\nfacette\n"},
    Sample{"stl_without_facets", "stl", "solid x\nendsolid x\n"},
};

/// The faces of a triangle and its back, as binary STL; `announced` faces in its header.
std::string binary_stl(std::uint32_t announced) {
    std::string bytes(80, ' ');
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<char>(announced >> shift & 0xffU));
    const std::string origin(12, '\0');
    const std::string one("\0\0\x80\x3f", 4);
    const std::array corners{origin, std::string(origin).replace(0, 4, one),
                             std::string(origin).replace(4, 4, one)};
    for (const std::array<std::size_t, 3> face : {std::array<std::size_t, 3>{0, 1, 2}, {2, 1, 0}}) {
        bytes += origin;  // for the normal
        for (const std::size_t corner : face)
            bytes += corners.at(corner);
        bytes += std::string(2, '\0');
    }
    return bytes;
}

struct Written {
    const char* name;
    MeshFormat format;
    geometry::MeshWriteOptions options;
};
constexpr std::array ways_to_write{
    Written{"obj", MeshFormat::obj, {}},
    Written{"off", MeshFormat::off, {}},
    Written{"ply_text", MeshFormat::ply, {MeshEncoding::text, false}},
    Written{"ply_text_glued", MeshFormat::ply, {MeshEncoding::text, true}},
    Written{"ply_binary", MeshFormat::ply, {MeshEncoding::binary, false}},
    Written{"ply_binary_glued", MeshFormat::ply, {MeshEncoding::binary, true}},
    Written{"stl_text", MeshFormat::stl, {MeshEncoding::text, false}},
    Written{"stl_binary", MeshFormat::stl, {MeshEncoding::binary, false}},
};

/// Surfaces with points no two of which are the same.
std::vector<std::pair<std::string, geometry::Surface>> surfaces() {
    namespace families = kernel::families;
    std::vector<std::pair<std::string, geometry::Surface>> result;
    for (const auto& [name, triangulation] :
         {std::pair("tetrahedron", families::tetrahedron()),
          std::pair("octahedron", families::octasphere(0)),
          std::pair("torus", families::torus_grid(3, 3)), std::pair("book", families::book(4)),
          std::pair("two_faces", families::book(3))}) {
        std::vector<Point> points(static_cast<std::size_t>(triangulation.vertex_count()));
        for (int v = 0; Point & point : points) {
            point = {1.0 * v * v, 0.1 * v, v % 3 == 0 ? -0.0 : 1.0 / v};
            ++v;
        }
        result.emplace_back(name, geometry::Surface(triangulation, points));
    }
    return result;
}

}  // namespace

std::vector<MeshSample> mesh_samples() {
    std::vector<MeshSample> all;
    all.reserve(samples.size());
    for (const auto& [name, format, text] : samples)
        all.push_back({name, format, text});
    for (const auto& [name, surface] : surfaces()) {
        for (const auto& [way, format, options] : ways_to_write) {
            if (obstacle_to_writing(surface.view(), format, options.encoding)) continue;
            const std::string bytes =
                written([&, &view = surface, &how = options, what = format](std::ostream& out) {
                    write_mesh(out, view.view(), what, how);
                });
            all.push_back(
                {std::string(way) + "_" + name, std::string(geometry::name(format)), bytes});
        }
    }
    all.push_back({"stl_binary_front_and_back", "stl", binary_stl(2)});
    all.push_back({"stl_binary_cut", "stl", binary_stl(3)});
    all.push_back({"stl_binary_too_long", "stl", binary_stl(1)});
    all.push_back({"stl_binary_huge", "stl", binary_stl(0xffffffffU)});
    std::string not_finite = binary_stl(2);
    not_finite.replace(96, 4, std::string("\0\0\xc0\x7f", 4));
    all.push_back({"stl_binary_not_finite", "stl", not_finite});
    return all;
}

}  // namespace tightflip::fuzz
