#include "byte_order.hpp"
#include "directions.hpp"
#include "face_list.hpp"
#include <tightflip/geometry/mesh_writer.hpp>
#include <tightflip/kernel/plain_writer.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace tightflip::geometry {
namespace {

using kernel::PlainWriter;

PlainWriter& operator<<(PlainWriter& text, const Point& p) {
    return text << p.x() << ' ' << p.y() << ' ' << p.z();
}

/// Binary rows, handed to the stream in blocks.
class BinaryWriter {
public:
    explicit BinaryWriter(std::ostream& out) : out_(out) {}

    template <class T>
    BinaryWriter& operator<<(T number) {
        append_little_endian(bytes_, number);
        return *this;
    }
    void end_row() {
        if (bytes_.size() >= block_size) flush();
    }
    void flush() {
        out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
        bytes_.clear();
    }

private:
    static constexpr std::size_t block_size = 1 << 16;
    std::ostream& out_;
    std::string bytes_;
};

void write_obj(std::ostream& out, const SurfaceView& surface, const MeshWriteOptions&) {
    PlainWriter text(out);
    for (const Point& p : surface.points)
        text << "v " << p << '\n';
    for (const auto& [a, b, c] : corners_of_faces(surface.table))
        text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
}

void write_off(std::ostream& out, const SurfaceView& surface, const MeshWriteOptions&) {
    PlainWriter text(out);
    text << "OFF\n"
         << surface.points.size() << ' ' << surface.table.size() / 3 << ' '
         << surface.table.size() / 2 << '\n';
    for (const Point& p : surface.points)
        text << p << '\n';
    for (const auto& [a, b, c] : corners_of_faces(surface.table))
        text << "3 " << a << ' ' << b << ' ' << c << '\n';
}

/// The lists of a face: its corners and perhaps its glued sides.
using FaceLists = std::vector<std::vector<FaceCorners>>;

void write_text_rows(std::ostream& out, Points points, const FaceLists& lists) {
    PlainWriter text(out);
    for (const Point& p : points)
        text << p << '\n';
    for (std::size_t f = 0; f < lists.front().size(); ++f) {
        for (std::size_t i = 0; i < lists.size(); ++i) {
            const auto& [a, b, c] = lists[i][f];
            text << (i == 0 ? "3 " : " 3 ") << a << ' ' << b << ' ' << c;
        }
        text << '\n';
    }
}

void write_binary_rows(std::ostream& out, Points points, const FaceLists& lists) {
    BinaryWriter rows(out);
    for (const Point& p : points) {
        rows << p.x() << p.y() << p.z();
        rows.end_row();
    }
    for (std::size_t f = 0; f < lists.front().size(); ++f) {
        for (const auto& list : lists) {
            const auto& [a, b, c] = list[f];
            rows << std::uint8_t{3} << a << b << c;
        }
        rows.end_row();
    }
    rows.flush();
}

void write_ply(std::ostream& out, const SurfaceView& surface, const MeshWriteOptions& options) {
    const bool is_text = options.encoding == MeshEncoding::text;
    FaceLists lists{corners_of_faces(surface.table)};
    const bool is_glued = options.always_glued_sides || parallel_edges(surface.table);
    if (is_glued) lists.push_back(glued_sides_of_faces(surface.table));
    PlainWriter(out) << "ply\nformat " << (is_text ? "ascii" : "binary_little_endian")
                     << " 1.0\nelement vertex " << surface.points.size()
                     << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
                     << lists.front().size() << "\nproperty list uchar int vertex_indices\n"
                     << (is_glued ? "property list uchar int glued_sides\n" : "") << "end_header\n";
    (is_text ? write_text_rows : write_binary_rows)(out, surface.points, lists);
}

/// The unit normal; zero where the corners lie on one line.
Point unit_normal(const Point& a, const Point& b, const Point& c) {
    return direction(a, b).cross(direction(a, c)).stableNormalized();
}

void write_text_stl(std::ostream& out, const SurfaceView& surface) {
    PlainWriter text(out);
    const auto point = [&](Index v) -> const Point& { return surface.point({v}); };
    text << "solid tightflip\n";
    for (const auto& [a, b, c] : corners_of_faces(surface.table)) {
        text << "facet normal " << unit_normal(point(a), point(b), point(c)) << "\nouter loop\n";
        for (const Index v : {a, b, c})
            text << "vertex " << point(v) << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid tightflip\n";
}

void write_binary_stl(std::ostream& out, const SurfaceView& surface) {
    constexpr std::string_view header = "binary STL by tightflip";  // it must not begin with solid
    BinaryWriter rows(out);
    const auto write_point = [&](const Point& p) {
        for (const double coordinate : p)
            rows << static_cast<float>(coordinate);
    };
    for (std::size_t i = 0; i < 80; ++i)
        rows << (i < header.size() ? header[i] : ' ');
    rows << static_cast<std::uint32_t>(surface.table.size() / 3);
    for (const auto& [a, b, c] : corners_of_faces(surface.table)) {
        write_point(unit_normal(surface.point({a}), surface.point({b}), surface.point({c})));
        for (const Index v : {a, b, c})
            write_point(surface.point({v}));
        rows << std::uint16_t{0};
        rows.end_row();
    }
    rows.flush();
}

void write_stl(std::ostream& out, const SurfaceView& surface, const MeshWriteOptions& options) {
    (options.encoding == MeshEncoding::text ? write_text_stl : write_binary_stl)(out, surface);
}

constexpr std::string_view lossless = "write PLY or tightflip-surface";

/// Two vertices that no coordinate tells apart where these are rounded to T.
template <class T>
std::optional<std::pair<Index, Index>> coincident(Points points) {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index v) {
        const Point& p = points[static_cast<std::size_t>(v)];
        return std::tuple(static_cast<T>(p.x()), static_cast<T>(p.y()), static_cast<T>(p.z()));
    };
    std::ranges::sort(order, {}, key);
    const auto found = std::ranges::adjacent_find(order, {}, key);
    if (found == order.end()) return std::nullopt;
    return std::minmax(found[0], found[1]);
}

/// What stands in the way of STL, where a vertex is what stands at one point.
std::optional<std::string> obstacle_in_points(Points points, MeshEncoding encoding) {
    const bool is_rounded = encoding == MeshEncoding::binary;
    for (std::size_t v = 0; is_rounded && v < points.size(); ++v) {
        if (points[v].cwiseAbs().maxCoeff() > double{std::numeric_limits<float>::max()}) {
            return "a coordinate of vertex " + std::to_string(v) +
                   " is beyond the range of the floats in binary STL; write STL as text, PLY or "
                   "tightflip-surface";
        }
    }
    if (const auto pair = is_rounded ? coincident<float>(points) : coincident<double>(points)) {
        return "vertices " + std::to_string(pair->first) + " and " + std::to_string(pair->second) +
               " stand at one point" + (is_rounded ? " when rounded to float" : "") +
               ", and STL would make them one vertex; " + std::string(lossless);
    }
    return std::nullopt;
}

struct Writer {
    MeshFormat format;
    std::string_view name;
    void (*write)(std::ostream& out, const SurfaceView& surface, const MeshWriteOptions& options);
};
constexpr std::array<Writer, 4> writers{{{MeshFormat::obj, "OBJ", write_obj},
                                         {MeshFormat::off, "OFF", write_off},
                                         {MeshFormat::ply, "PLY", write_ply},
                                         {MeshFormat::stl, "STL", write_stl}}};

const Writer& writer_of(MeshFormat format) {
    return *std::ranges::find(writers, format, &Writer::format);
}

}  // namespace

std::optional<std::string> obstacle_to_writing(const SurfaceView& surface, MeshFormat format,
                                               MeshEncoding encoding) {
    if (format == MeshFormat::ply) return std::nullopt;
    if (const auto ends = parallel_edges(surface.table)) {
        return "several edges join vertices " + std::to_string(ends->first.id) + " and " +
               std::to_string(ends->second.id) + ", and " + std::string(writer_of(format).name) +
               ", which lists corners alone, does not say which sides are glued; " +
               std::string(lossless);
    }
    if (format == MeshFormat::stl) return obstacle_in_points(surface.points, encoding);
    return std::nullopt;
}

void write_mesh(std::ostream& out, const SurfaceView& surface, MeshFormat format,
                const MeshWriteOptions& options) {
    if (const auto obstacle = obstacle_to_writing(surface, format, options.encoding)) {
        throw std::invalid_argument(*obstacle);
    }
    writer_of(format).write(out, surface, options);
}

}  // namespace tightflip::geometry
