#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/plantri_code.hpp>

#include <algorithm>
#include <array>
#include <istream>
#include <ostream>
#include <tuple>
#include <utility>

namespace tightflip::kernel {
namespace {

constexpr std::string_view planar_header = ">>planar_code<<";
constexpr std::string_view planar_header_be = ">>planar_code be<<";
constexpr std::string_view edge_header = ">>edge_code<<";

struct Header {
    std::string_view text;
    PlantriFormat format;
    bool little_endian;
};
constexpr std::array headers{Header{planar_header, PlantriFormat::planar_code, false},
                             Header{planar_header_be, PlantriFormat::planar_code, false},
                             Header{">>planar_code le<<", PlantriFormat::planar_code, true},
                             Header{edge_header, PlantriFormat::edge_code, false}};
constexpr std::size_t longest_header = planar_header_be.size();

constexpr std::uint8_t separator = 255;
constexpr Index most_vertices_in_planar_code = 65535;
constexpr auto most_darts = 3 * static_cast<std::size_t>(max_faces);

/// The list (from 0) in which an entry stands.
std::size_t list_of(const std::vector<std::size_t>& first_dart, std::size_t dart) {
    const auto after = std::upper_bound(first_dart.begin(), first_dart.end(), dart);
    return static_cast<std::size_t>(after - first_dart.begin()) - 1;
}

/// "list 3", counted from 1 as the vertices of planar_code are.
std::string in_list(std::size_t list) {
    return "list " + std::to_string(list + 1);
}

/// The halfedges that leave a vertex, clockwise seen from outside.
std::vector<Halfedge> clockwise(const Triangulation& surface, Halfedge first) {
    const Star star = surface.star(first);
    std::vector<Halfedge> spokes(star.begin(), star.end());
    std::reverse(spokes.begin() + 1, spokes.end());
    return spokes;
}

void append_big_endian(std::string& bytes, std::uint64_t value, int width) {
    for (int shift = 8 * (width - 1); shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<char>(value >> shift & 0xff));
    }
}

/// The fewest bytes for `value`; with `below_separator` the first of them must not be 255.
int width_of(std::uint64_t value, bool below_separator) {
    int width = 1;
    while (value >> 8 * width != 0)
        ++width;
    const bool collides = below_separator && value >> 8 * (width - 1) == separator;
    return collides ? width + 1 : width;
}

}  // namespace

// ---- reading ----

PlantriReader::PlantriReader(std::istream& in, std::string name, PlantriFormat headerless)
    : in_(in), name_(std::move(name)), format_(headerless) {}

std::optional<Triangulation> PlantriReader::next() {
    if (!read_headers()) return std::nullopt;
    ++graph_;
    return format_ == PlantriFormat::planar_code ? read_planar_record() : read_edge_record();
}

// Two bytes '>' can begin a graph of 62 vertices in planar_code, or a body of 62 bytes in
// edge_code, but no letter can be its third byte: both count to 62 at most.
bool PlantriReader::read_headers() {
    while (has_ahead(3) && ahead_.starts_with(">>") && static_cast<std::uint8_t>(ahead_[2]) > '>') {
        obey_header();
    }
    return has_ahead(1);
}

void PlantriReader::obey_header() {
    const std::uint64_t start = position_;
    std::string text;
    while (!text.ends_with("<<") && text.size() < longest_header && has_ahead(1)) {
        text.push_back(static_cast<char>(take()));
    }
    const auto* const known = std::ranges::find(headers, text, &Header::text);
    if (known == headers.end()) {
        throw FileError(name_, FileError::Unit::byte, start,
                        "the header is none of >>planar_code<<, >>planar_code be<<, "
                        ">>planar_code le<< and >>edge_code<<");
    }
    format_ = known->format;
    little_endian_ = known->little_endian;
}

Triangulation PlantriReader::read_planar_record() {
    const std::uint64_t start = position_;
    int width = 1;
    std::uint32_t vertices = read_entry(width);
    if (vertices == 0) vertices = read_entry(width = 2);
    if (vertices == 0) refuse(start, "it has no vertices");

    const std::uint64_t body = position_;
    std::vector<std::size_t> first_dart;
    std::vector<std::size_t> neighbour;  // of a dart, from 0
    for (std::uint32_t v = 0; v < vertices; ++v) {
        first_dart.push_back(neighbour.size());
        while (const std::uint32_t entry = read_entry(width)) {
            const std::uint64_t place = position_ - static_cast<std::uint64_t>(width);
            if (entry > vertices) {
                refuse(place, in_list(v) + " names vertex " + std::to_string(entry) +
                                  ", but there are only " + std::to_string(vertices));
            }
            if (entry == v + 1) refuse(place, in_list(v) + " names its own vertex: a loop");
            if (neighbour.size() == most_darts) refuse(place, "it has too many edges");
            neighbour.push_back(entry - 1);
        }
    }

    // The two ends of an edge are the two darts that join the same pair, once in each direction.
    struct Join {
        std::size_t low, high, origin, dart;
    };
    std::vector<Join> joins;
    joins.reserve(neighbour.size());
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::size_t end = v + 1 < vertices ? first_dart[v + 1] : neighbour.size();
        for (std::size_t dart = first_dart[v]; dart < end; ++dart) {
            const auto [low, high] = std::minmax(v, neighbour[dart]);
            joins.push_back({low, high, v, dart});
        }
    }
    std::ranges::sort(joins, [](const Join& a, const Join& b) {
        return std::tie(a.low, a.high, a.origin, a.dart) <
               std::tie(b.low, b.high, b.origin, b.dart);
    });
    const auto complain = [&](const Join& join, const std::string& how) {
        refuse(body + (join.dart + join.origin) * static_cast<std::uint64_t>(width),
               in_list(join.origin) + " names vertex " + std::to_string(neighbour[join.dart] + 1) +
                   how);
    };
    std::vector<std::size_t> other_end(neighbour.size());
    for (std::size_t i = 0; i < joins.size(); i += 2) {
        const auto same_pair = [&](std::size_t k) {
            return k < joins.size() && joins[k].low == joins[i].low &&
                   joins[k].high == joins[i].high;
        };
        const auto repeats = [&](std::size_t k) {
            return same_pair(k) && joins[k].origin == joins[k - 1].origin;
        };
        for (const std::size_t k : {i + 1, i + 2}) {
            if (repeats(k)) complain(joins[k], " again: planar_code cannot tell parallel edges");
        }
        if (!same_pair(i + 1)) complain(joins[i], ", whose list does not name it");
        other_end[joins[i].dart] = joins[i + 1].dart;
        other_end[joins[i + 1].dart] = joins[i].dart;
    }

    std::vector<Index> edge_of_dart(neighbour.size());
    Index edges = 0;
    for (std::size_t dart = 0; dart < neighbour.size(); ++dart) {
        edge_of_dart[dart] = other_end[dart] > dart ? edges++ : edge_of_dart[other_end[dart]];
    }
    return glue(first_dart, edge_of_dart, start);
}

Triangulation PlantriReader::read_edge_record() {
    const std::uint64_t start = position_;
    std::uint64_t length = take();
    std::uint64_t width = 1;
    if (length == 0) {
        const std::uint8_t sizes = take();
        width = sizes & 0x0f;
        if (width == 0) refuse(position_ - 1, "it gives edge numbers no bytes");
        for (int i = 0; i < sizes >> 4; ++i) {
            if (length >> 48 != 0) refuse(start, "its length is beyond all files");
            length = length << 8 | take();
        }
    }
    if (length == 0) refuse(start, "it is empty");

    const std::uint64_t body = position_;
    const std::uint64_t end = body + length;
    std::vector<std::size_t> first_dart{0};
    std::vector<Index> edge_of_dart;
    while (position_ < end) {
        const std::uint64_t place = position_;
        std::uint64_t edge = take();
        if (edge == separator) {
            if (first_dart.size() == most_darts) refuse(place, "it has too many vertices");
            first_dart.push_back(edge_of_dart.size());
            continue;
        }
        if (place + width > end) refuse(place, "an edge number reaches beyond its end");
        while (position_ < place + width) {
            edge = edge << 8 | take();
            if (edge >= most_darts) refuse(place, "an edge number is too large for any surface");
        }
        if (edge_of_dart.size() == most_darts) refuse(place, "it has too many edges");
        edge_of_dart.push_back(static_cast<Index>(edge));
    }

    const std::size_t edges = (edge_of_dart.size() + 1) / 2;
    std::vector<Index> first_list(edges, -1);  // in which an edge was met; -2 after its second time
    for (std::size_t dart = 0; dart < edge_of_dart.size(); ++dart) {
        const auto edge = static_cast<std::size_t>(edge_of_dart[dart]);
        const std::size_t list = list_of(first_dart, dart);
        const auto complain = [&](const std::string& how) {
            refuse(body + dart * width + list,
                   in_list(list) + " names edge " + std::to_string(edge) + how);
        };
        if (edge >= edges) {
            complain(", but " + std::to_string(edge_of_dart.size()) +
                     " ends leave only edges 0 to " + std::to_string(edges - 1));
        }
        if (first_list[edge] == -2) complain(", which was named twice already");
        if (first_list[edge] == static_cast<Index>(list)) complain(" twice: a loop");
        first_list[edge] = first_list[edge] == -1 ? static_cast<Index>(list) : -2;
    }
    // No edge was named three times, so only an odd number of ends can leave one unpaired.
    const auto unpaired = std::ranges::find_if(first_list, [](Index list) { return list != -2; });
    if (unpaired != first_list.end()) {
        refuse(start,
               "edge " + std::to_string(unpaired - first_list.begin()) + " is named only once");
    }
    return glue(first_dart, edge_of_dart, start);
}

std::uint32_t PlantriReader::read_entry(int width) {
    if (width == 1) return take();
    const std::uint32_t first = take();
    const std::uint32_t second = take();
    return little_endian_ ? second << 8 | first : first << 8 | second;
}

// A dart is an entry of the lists; the one that follows it clockwise is, in the surface, the next
// side after its twin. Precondition: every edge 0 .. darts / 2 - 1 is named twice.
Triangulation PlantriReader::glue(const std::vector<std::size_t>& first_dart,
                                  const std::vector<Index>& edge_of_dart,
                                  std::uint64_t record_start) const {
    const std::size_t darts = edge_of_dart.size();
    if (first_dart.size() > darts) refuse(record_start, "it has more vertices than ends of edges");
    std::vector<bool> named(darts / 2, false);
    std::vector<Halfedge> halfedge(darts);
    for (std::size_t dart = 0; dart < darts; ++dart) {
        const auto edge = static_cast<std::size_t>(edge_of_dart[dart]);
        halfedge[dart] = halfedge_of(Edge{edge_of_dart[dart]});
        if (named[edge]) halfedge[dart] = twin(halfedge[dart]);
        named[edge] = true;
    }
    std::vector<HalfedgeRecord> records(darts);
    const MutableHalfedgeTable table(records);
    for (std::size_t v = 0; v < first_dart.size(); ++v) {
        const std::size_t end = v + 1 < first_dart.size() ? first_dart[v + 1] : darts;
        for (std::size_t dart = first_dart[v]; dart < end; ++dart) {
            at(table, halfedge[dart]).origin = {static_cast<Index>(v)};
            at(table, twin(halfedge[dart])).next =
                halfedge[dart + 1 < end ? dart + 1 : first_dart[v]];
        }
    }
    BuildResult built = build(std::move(records), static_cast<Index>(first_dart.size()));
    if (!built) {
        const Violation& first = built.report.violations.front();
        refuse(record_start,
               "it is no triangulated surface: " + where(first) + ": " + message(first));
    }
    return std::move(built).value();
}

bool PlantriReader::has_ahead(std::size_t count) {
    while (ahead_.size() < count) {
        const auto byte = in_.get();
        if (in_.good()) {
            ahead_.push_back(static_cast<char>(byte));
            continue;
        }
        if (in_.eof() && !in_.bad()) return false;
        throw FileError(name_, FileError::Unit::byte, position_ + ahead_.size(), "reading failed");
    }
    return true;
}

std::uint8_t PlantriReader::take() {
    if (!has_ahead(1)) refuse(position_, "the file ends inside it");
    const auto byte = static_cast<std::uint8_t>(ahead_.front());
    ahead_.erase(0, 1);
    ++position_;
    return byte;
}

void PlantriReader::refuse(std::uint64_t position, const std::string& reason) const {
    throw FileError(name_, FileError::Unit::byte, position,
                    "graph " + std::to_string(graph_) + ": " + reason);
}

// ---- writing ----

namespace {

/// Two vertices that more than one edge joins, if there are any.
std::optional<std::pair<Index, Index>> joined_twice(const Triangulation& surface) {
    std::vector<Vertex> near;
    for (const Halfedge first : surface.outgoing()) {
        const Neighbours around = surface.neighbours(first);
        near.assign(around.begin(), around.end());
        std::ranges::sort(near);
        const auto twice = std::ranges::adjacent_find(near);
        if (twice != near.end()) return std::pair(surface.origin(first).id, twice->id);
    }
    return std::nullopt;
}

/// Why planar_code cannot carry the surface; empty where it can.
std::string planar_code_refusal(const Triangulation& surface) {
    if (surface.vertex_count() > most_vertices_in_planar_code) {
        return "it has " + std::to_string(surface.vertex_count()) +
               " vertices, planar_code carries " + std::to_string(most_vertices_in_planar_code) +
               " at most; edge_code carries all";
    }
    if (const auto pair = joined_twice(surface)) {
        return "more than one edge joins the vertices " + std::to_string(pair->first) + " and " +
               std::to_string(pair->second) +
               ", and planar_code cannot tell parallel edges; edge_code can";
    }
    return {};
}

std::string planar_record(const Triangulation& surface) {
    const int width = surface.vertex_count() > 255 ? 2 : 1;
    std::string bytes(width == 2 ? 1 : 0, '\0');
    append_big_endian(bytes, static_cast<std::uint64_t>(surface.vertex_count()), width);
    for (const Halfedge first : surface.outgoing()) {
        for (const Halfedge h : clockwise(surface, first)) {
            append_big_endian(bytes, static_cast<std::uint64_t>(surface.target(h).id) + 1, width);
        }
        append_big_endian(bytes, 0, width);
    }
    return bytes;
}

std::string edge_record(const Triangulation& surface) {
    const int width = width_of(static_cast<std::uint64_t>(surface.edge_count() - 1), true);
    std::string body;
    for (const Halfedge first : surface.outgoing()) {
        if (!body.empty()) body.push_back(static_cast<char>(separator));
        for (const Halfedge h : clockwise(surface, first)) {
            append_big_endian(body, static_cast<std::uint64_t>(edge_of(h).id), width);
        }
    }
    std::string bytes;
    if (width == 1 && body.size() <= 255) {
        append_big_endian(bytes, body.size(), 1);
    } else {
        const int length_width = width_of(body.size(), false);
        bytes.push_back('\0');
        bytes.push_back(static_cast<char>(length_width << 4 | width));
        append_big_endian(bytes, body.size(), length_width);
    }
    return bytes + body;
}

}  // namespace

PlantriWriter::PlantriWriter(std::ostream& out, std::string name, PlantriFormat format)
    : out_(out), name_(std::move(name)), format_(format) {}

void PlantriWriter::write(const Triangulation& surface) {
    ++graph_;
    if (format_ == PlantriFormat::edge_code) {
        write_header(edge_header);
        return put(edge_record(surface));
    }
    if (const std::string why = planar_code_refusal(surface); !why.empty()) {
        throw FileError(name_, "graph " + std::to_string(graph_) + ": " + why);
    }
    write_header(surface.vertex_count() > 255 ? planar_header_be : planar_header);
    put(planar_record(surface));
}

void PlantriWriter::finish() {
    write_header(format_ == PlantriFormat::edge_code ? edge_header : planar_header);
    out_.flush();
    put({});
}

void PlantriWriter::write_header(std::string_view header) {
    if (!std::exchange(header_written_, true)) put(std::string(header));
}

void PlantriWriter::put(const std::string& bytes) {
    if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        throw FileError(name_, "writing failed");
    }
}

}  // namespace tightflip::kernel
