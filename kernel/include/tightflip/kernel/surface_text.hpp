/// \file
/// The kernel's own text formats, lossless and versioned; docs/formats.md specifies them.
///
/// `tightflip-triangulation 1` keeps a halfedge table, so that edge and halfedge numbers survive;
/// `tightflip-gluing 1` keeps faces and the gluing of their sides, and can say anything a Gluing
/// can, valid or not.
#pragma once

#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/text_cursor.hpp>

#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tightflip::kernel {

/// A halfedge table as a file gives it; nothing is known about it but that its numbers are numbers.
struct RawTable {
    Index vertex_count = 0;
    std::vector<HalfedgeRecord> records;

    friend bool operator==(const RawTable&, const RawTable&) = default;
};

/// A halfedge table in anybody's memory, with the number of its vertices, for those who only read.
struct TableView {
    Index vertex_count = 0;
    HalfedgeTable records;

    TableView(const RawTable& table) noexcept  // NOLINT(google-explicit-constructor)
        : vertex_count(table.vertex_count), records(table.records) {}
    TableView(const Triangulation& surface) noexcept  // NOLINT(google-explicit-constructor)
        : vertex_count(surface.vertex_count()), records(surface.table()) {}
};

using RawSurface = std::variant<RawTable, Gluing>;

/// Whether a text begins like one of the two formats.
[[nodiscard]] bool is_surface_text(std::string_view text) noexcept;

/// Reads either format. Throws FileError naming `source`, the line and the reason where the text is
/// not in the format; says nothing about whether the surface is valid. Memory and time are linear
/// in the text.
[[nodiscard]] RawSurface parse_surface(std::string_view text, const std::string& source);

[[nodiscard]] AuditReport audit(const RawSurface& surface, const AuditOptions& options = {});
[[nodiscard]] BuildResult build(const RawSurface& surface);

void write_text(std::ostream& out, const Triangulation& surface);
void write_text(std::ostream& out, const Gluing& gluing);

/// The lines of a table without header; other formats embed them.
void write_table(std::ostream& out, HalfedgeTable table, Index vertex_count);
[[nodiscard]] RawTable parse_table(TextCursor& cursor);

}  // namespace tightflip::kernel
