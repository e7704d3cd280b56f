// The two written forms of a flip log: "tightflip-flip-log 1" as text, and the same content in
// binary. Both end in a checksum of the content, which is the same for both.

#include "plain_writer.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <charconv>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace tightflip::kernel {
namespace {

constexpr std::string_view text_header = "tightflip-flip-log";
constexpr std::string_view binary_magic = "\x89TFLIPS\n";
constexpr int version = 1;

/// FNV-1a, 64 bits, over the content as a sequence of 32-bit words.
class Checksum {
public:
    void add(Index word) noexcept {
        for (int shift = 0; shift < 32; shift += 8) {
            hash_ ^= (static_cast<std::uint32_t>(word) >> shift) & 0xffU;
            hash_ *= 0x100000001b3ULL;
        }
    }
    [[nodiscard]] std::uint64_t value() const noexcept { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::uint64_t checksum(Index vertex_count, HalfedgeTable table, std::span<const Edge> flips) {
    Checksum sum;
    sum.add(vertex_count);
    sum.add(static_cast<Index>(table.size()));
    for (const auto& [next, origin] : table) {
        sum.add(next.id);
        sum.add(origin.id);
    }
    for (const Edge e : flips)
        sum.add(e.id);
    return sum.value();
}

std::uint64_t checksum(const FlipLog& log) {
    return checksum(log.start.vertex_count(), log.start.table(), log.flips);
}

void require_writable(const FlipLog& log) {
    if (log.flips.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
        throw std::length_error("a flip log holds at most 2^31 - 1 flips; cut it into several");
    }
}

std::string hexadecimal(std::uint64_t value) {
    std::string digits(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4)
        digits[i] = "0123456789abcdef"[value & 0xfU];
    return digits;
}

/// What both readers end with: the content is what was written, and its start is a surface.
template <class Fail>
FlipLog concluded(RawTable table, std::vector<Edge> flips, std::uint64_t expected, Fail&& fail) {
    if (checksum(table.vertex_count, table.records, flips) != expected) {
        fail("the checksum does not fit the content: the log is damaged or was edited");
    }
    BuildResult start = build(std::move(table.records), table.vertex_count);
    if (!start) {
        const Violation& first = start.report.violations.front();
        fail("the log's start is no valid surface: " + where(first) + ": " + message(first));
    }
    return {std::move(start).value(), std::move(flips)};
}

FlipLog parse_text(std::string_view text, const std::string& source) {
    TextCursor cursor(text, source);
    cursor.require_line("the format's name and version");
    cursor.require_word(text_header);
    cursor.integer("the format's version, which must be one this program knows,", version, version);
    cursor.require_end_of_line("the format's version");
    RawTable table = parse_table(cursor);
    const Index count = cursor.announced_lines("flips", 2);
    const auto edges = static_cast<Index>(table.records.size() / 2);
    std::vector<Edge> flips;
    flips.reserve(static_cast<std::size_t>(count));
    for (Index k = 0; k < count; ++k) {
        cursor.require_line("flip " + std::to_string(k));
        flips.push_back({cursor.index("an edge", 0, edges - 1)});
        cursor.require_end_of_line("the edge");
    }
    cursor.require_line("'check SUM'");
    cursor.require_word("check");
    const std::string_view digits = cursor.word();
    std::uint64_t sum = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), sum, 16);
    if (digits.size() != 16 || error != std::errc{} || end != digits.data() + digits.size()) {
        cursor.fail("the checksum should be 16 hexadecimal digits");
    }
    cursor.require_end_of_line("the checksum");
    if (cursor.next_line()) cursor.fail("nothing should follow the checksum");
    return concluded(std::move(table), std::move(flips), sum,
                     [&](const std::string& reason) { cursor.fail(reason); });
}

// ---- binary: little-endian words, flips as variable-length integers of 7 bits a byte ----

void put_word(std::ostream& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        out.put(static_cast<char>((value >> (8 * i)) & 0xffU));
}

void put_index(std::ostream& out, Index value) {
    put_word(out, static_cast<std::uint32_t>(value), 4);
}

class ByteCursor {
public:
    ByteCursor(std::string_view bytes, std::string source)
        : bytes_(bytes), source_(std::move(source)) {}

    std::uint64_t word(int count) {
        if (left() < static_cast<std::size_t>(count)) fail("the log ends here; it is truncated");
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i)
            value |= std::uint64_t{byte()} << (8 * i);
        return value;
    }
    Index index() { return static_cast<Index>(static_cast<std::uint32_t>(word(4))); }
    Index variable_length() {
        std::uint32_t value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            const auto part = static_cast<std::uint32_t>(word(1));
            if (shift == 28 && part > 0xfU) break;  // more than 32 bits
            value |= (part & 0x7fU) << shift;
            if (part < 0x80U) return static_cast<Index>(value);
        }
        fail("a number is too large for an edge");
    }
    Index count(const char* what, std::size_t least_bytes) {
        const Index value = index();
        if (value < 0 || static_cast<std::size_t>(value) > left() / least_bytes) {
            fail(std::to_string(value) + " " + what +
                 " are announced, more than the rest of the file can hold; it is truncated or "
                 "damaged");
        }
        return value;
    }
    [[nodiscard]] std::size_t left() const noexcept { return bytes_.size() - position_; }
    [[noreturn]] void fail(const std::string& reason) const {
        throw FileError(source_, FileError::Unit::byte, position_, reason);
    }

private:
    std::uint8_t byte() { return static_cast<std::uint8_t>(bytes_[position_++]); }

    std::string_view bytes_;
    std::string source_;
    std::size_t position_ = 0;
};

FlipLog parse_binary(std::string_view bytes, const std::string& source) {
    ByteCursor cursor(bytes, source);
    cursor.word(static_cast<int>(binary_magic.size()));
    const Index found = cursor.index();
    if (found != version) {
        cursor.fail("the log is in version " + std::to_string(found) + " of the format, this " +
                    "program knows version " + std::to_string(version));
    }
    RawTable table;
    table.vertex_count = cursor.index();
    const Index halfedges = cursor.count("halfedges", 8);
    table.records.resize(static_cast<std::size_t>(halfedges));
    for (auto& [next, origin] : table.records) {
        next = {cursor.index()};
        origin = {cursor.index()};
    }
    const Index count = cursor.count("flips", 1);
    std::vector<Edge> flips(static_cast<std::size_t>(count));
    for (Edge& e : flips) {
        e = {cursor.variable_length()};
        if (e.id < 0 || e.id >= halfedges / 2) {
            cursor.fail("edge " + std::to_string(e.id) + " does not exist: the start has " +
                        std::to_string(halfedges / 2) + " edges");
        }
    }
    const std::uint64_t sum = cursor.word(8);
    if (cursor.left() != 0) cursor.fail("nothing should follow the checksum");
    return concluded(std::move(table), std::move(flips), sum,
                     [&](const std::string& reason) { cursor.fail(reason); });
}

}  // namespace

void write_text(std::ostream& out, const FlipLog& log) {
    require_writable(log);
    PlainWriter text(out);
    text << text_header << ' ' << version << '\n';
    write_table(out, log.start.table(), log.start.vertex_count());
    text << "flips " << log.flips.size() << '\n';
    for (const Edge e : log.flips)
        text << e.id << '\n';
    text << "check " << hexadecimal(checksum(log)) << '\n';
}

void write_binary(std::ostream& out, const FlipLog& log) {
    require_writable(log);
    PlainWriter(out) << binary_magic;
    put_index(out, version);
    put_index(out, log.start.vertex_count());
    put_index(out, log.start.halfedge_count());
    for (const auto& [next, origin] : log.start.table()) {
        put_index(out, next.id);
        put_index(out, origin.id);
    }
    put_index(out, static_cast<Index>(log.flips.size()));
    for (const Edge e : log.flips) {
        auto rest = static_cast<std::uint32_t>(e.id);
        for (; rest >= 0x80U; rest >>= 7)
            out.put(static_cast<char>((rest & 0x7fU) | 0x80U));
        out.put(static_cast<char>(rest));
    }
    put_word(out, checksum(log), 8);
}

bool is_flip_log(std::string_view bytes) noexcept {
    return bytes.starts_with(binary_magic) || bytes.starts_with(text_header);
}

FlipLog parse_flip_log(std::string_view bytes, const std::string& source) {
    if (bytes.starts_with(binary_magic)) return parse_binary(bytes, source);
    if (bytes.starts_with(text_header)) return parse_text(bytes, source);
    throw FileError(source, FileError::Unit::byte, 0,
                    "this is no flip log: it begins neither with '" + std::string(text_header) +
                        "' nor with the mark of the binary form");
}

}  // namespace tightflip::kernel
