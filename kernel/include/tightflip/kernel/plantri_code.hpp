/// \file
/// plantri's binary formats `planar_code` and `edge_code`, read and written one graph at a time.
///
/// Both list, vertex by vertex, what lies around it in clockwise order: neighbours counted from 1
/// (planar_code), or incident edges counted from 0 (edge_code). That is a rotation system, so every
/// genus is covered. Clockwise is seen from outside, where the faces of a Triangulation run
/// counter-clockwise. Formats: Brinkmann and McKay, the guide to plantri, appendices.
///
/// What is lossless: a surface read back after writing is the same labelled surface (vertex v is
/// the v-th list). With edge_code every edge keeps its number too; which of its two halfedges is
/// the even one is not kept. planar_code numbers the edges in the order in which the file first
/// names them, and it cannot tell parallel edges apart: graphs that have them are refused.
#pragma once

#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::kernel {

enum class PlantriFormat : std::uint8_t { planar_code, edge_code };

/// Reads a stream of graphs. Every graph must be a triangulation of the allowed class; anything
/// else, and any damage, throws FileError with the byte and, in the reason, the number of the graph
/// (from 1). After that the reader is of no further use. Memory grows only with the bytes that were
/// really read for one graph.
class PlantriReader {
public:
    /// `name` stands for the stream in messages; the stream must outlive the reader. A header says
    /// which format follows; `headerless` is for streams without one.
    PlantriReader(std::istream& in, std::string name,
                  PlantriFormat headerless = PlantriFormat::planar_code);

    /// The next graph; empty at the end of the stream. Headers inside the stream (of files that
    /// were joined) are obeyed. Two-byte entries are big-endian unless the header says `le`.
    [[nodiscard]] std::optional<Triangulation> next();

private:
    [[nodiscard]] bool read_headers();
    void obey_header();
    [[nodiscard]] Triangulation read_planar_record();
    [[nodiscard]] Triangulation read_edge_record();
    [[nodiscard]] std::uint32_t read_entry(int width);
    [[nodiscard]] Triangulation glue(const std::vector<std::size_t>& first_dart,
                                     const std::vector<Index>& edge_of_dart,
                                     std::uint64_t record_start) const;

    [[nodiscard]] bool has_ahead(std::size_t count);
    [[nodiscard]] std::uint8_t take();
    [[noreturn]] void refuse(std::uint64_t position, const std::string& reason) const;

    std::istream& in_;
    std::string name_;
    PlantriFormat format_;
    bool little_endian_ = false;
    std::uint64_t position_ = 0;  // of the first byte in `ahead_`
    std::string ahead_;           // at most a few bytes, looked at but not yet taken
    std::uint64_t graph_ = 0;     // number of the graph at hand
};

/// Writes a stream of graphs behind one header.
class PlantriWriter {
public:
    /// `name` stands for the stream in messages; the stream must outlive the writer.
    PlantriWriter(std::ostream& out, std::string name, PlantriFormat format);

    /// Appends one graph. Throws FileError, and writes nothing of it, where the format cannot carry
    /// the surface: planar_code refuses parallel edges (the reason names two vertices they join)
    /// and more than 65535 vertices; edge_code carries everything. Throws FileError too where the
    /// stream fails. A planar_code stream begins with the header `>>planar_code<<` where its first
    /// graph has at most 255 vertices, else with `>>planar_code be<<`; two-byte entries are
    /// big-endian in either case.
    void write(const Triangulation& surface);

    /// Writes the header where no graph did, and flushes; throws FileError where the stream fails.
    void finish();

private:
    void write_header(std::string_view header);
    void put(const std::string& bytes);

    std::ostream& out_;
    std::string name_;
    PlantriFormat format_;
    bool header_written_ = false;
    std::uint64_t graph_ = 0;
};

}  // namespace tightflip::kernel
