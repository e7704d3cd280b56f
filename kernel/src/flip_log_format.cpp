// The two written forms of a flip log: "tightflip-flip-log 1" as text, and the same content in
// binary. Both end in a checksum of the content, which is the same for both.

#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/plain_writer.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <algorithm>
#include <charconv>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <streambuf>

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

std::uint64_t checksum(const FlipLogView& log) {
    Checksum sum;
    sum.add(log.start.vertex_count);
    sum.add(static_cast<Index>(log.start.records.size()));
    for (const auto& [next, origin] : log.start.records) {
        sum.add(next.id);
        sum.add(origin.id);
    }
    for (const Edge e : log.flips)
        sum.add(e.id);
    return sum.value();
}

void require_writable(const FlipLogView& log) {
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

/// What both readers end with: the content is what was written.
template <class Cursor>
RawFlipLog concluded(RawFlipLog log, std::uint64_t expected, const Cursor& cursor) {
    if (checksum(log) != expected) {
        cursor.fail("the checksum does not fit the content: the log is damaged or was edited");
    }
    return log;
}

RawFlipLog parse_text(std::string_view text, const std::string& source) {
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
    return concluded({std::move(table), std::move(flips)}, sum, cursor);
}

// ---- binary: little-endian words, flips as variable-length integers of 7 bits a byte ----

/// Writes in blocks: a stream takes its time over single bytes.
class ByteWriter {
public:
    explicit ByteWriter(std::ostream& out) : out_(out) { block_.reserve(block_size); }

    void word(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            byte(value >> (8 * i));
    }
    void index(Index value) { word(static_cast<std::uint32_t>(value), 4); }
    void variable_length(Index value) {
        auto rest = static_cast<std::uint32_t>(value);
        for (; rest >= 0x80U; rest >>= 7)
            byte((rest & 0x7fU) | 0x80U);
        byte(rest);
    }
    /// Must come last.
    void flush() {
        out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
        block_.clear();
    }

private:
    static constexpr std::size_t block_size = std::size_t{1} << 16;

    void byte(std::uint64_t value) {
        if (block_.size() == block_size) flush();
        block_ += static_cast<char>(value & 0xffU);
    }

    std::ostream& out_;
    std::string block_;
};

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

RawFlipLog parse_binary(std::string_view bytes, const std::string& source) {
    ByteCursor cursor(bytes, source);
    cursor.word(static_cast<int>(binary_magic.size()));
    const Index found = cursor.index();
    if (found != version) {
        cursor.fail("the log is in version " + std::to_string(found) + " of the format, this " +
                    "program knows version " + std::to_string(version));
    }
    RawTable table;
    table.vertex_count = cursor.index();
    if (table.vertex_count < 0) {
        cursor.fail("the number of vertices is negative: " + std::to_string(table.vertex_count));
    }
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
    return concluded({std::move(table), std::move(flips)}, sum, cursor);
}

RawFlipLog parse(std::string_view bytes, const std::string& source) {
    if (bytes.starts_with(binary_magic)) return parse_binary(bytes, source);
    if (bytes.starts_with(text_header)) return parse_text(bytes, source);
    throw FileError(source, FileError::Unit::byte, 0,
                    "this is no flip log: it begins neither with '" + std::string(text_header) +
                        "' nor with the mark of the binary form");
}

/// Refuses a log at a byte, or at its line.
[[noreturn]] void fail_at(std::string_view bytes, std::size_t position, const std::string& source,
                          const std::string& reason) {
    if (bytes.starts_with(binary_magic)) {
        throw FileError(source, FileError::Unit::byte, position, reason);
    }
    const auto before = std::ranges::count(bytes.substr(0, position), '\n');
    throw FileError(source, FileError::Unit::line, static_cast<std::uint64_t>(before) + 1, reason);
}

// ---- the spelling ----

/// A stream that keeps nothing but how far what is written to it is what stands in a text.
class ComparingBuffer : public std::streambuf {
public:
    explicit ComparingBuffer(std::string_view expected) : expected_(expected) {}

    /// Bytes before the first that differs.
    [[nodiscard]] std::size_t matched() const noexcept { return matched_; }

protected:
    int_type overflow(int_type c) override {
        const char byte = traits_type::to_char_type(c);
        return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
    }
    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
        const std::string_view written(bytes, static_cast<std::size_t>(count));
        const std::string_view ahead = expected_.substr(matched_, written.size());
        const auto equal = std::ranges::mismatch(written, ahead).in1 - written.begin();
        matched_ += static_cast<std::size_t>(equal);
        return equal;
    }

private:
    std::string_view expected_;
    std::size_t matched_ = 0;
};

}  // namespace

void write_text(std::ostream& out, const FlipLogView& log) {
    require_writable(log);
    PlainWriter text(out);
    text << text_header << ' ' << version << '\n';
    write_table(out, log.start.records, log.start.vertex_count);
    text << "flips " << log.flips.size() << '\n';
    for (const Edge e : log.flips)
        text << e.id << '\n';
    text << "check " << hexadecimal(checksum(log)) << '\n';
}

void write_binary(std::ostream& out, const FlipLogView& log) {
    require_writable(log);
    PlainWriter(out) << binary_magic;
    ByteWriter bytes(out);
    bytes.index(version);
    bytes.index(log.start.vertex_count);
    bytes.index(static_cast<Index>(log.start.records.size()));
    for (const auto& [next, origin] : log.start.records) {
        bytes.index(next.id);
        bytes.index(origin.id);
    }
    bytes.index(static_cast<Index>(log.flips.size()));
    for (const Edge e : log.flips)
        bytes.variable_length(e.id);
    bytes.word(checksum(log), 8);
    bytes.flush();
}

bool is_flip_log(std::string_view bytes) noexcept {
    return bytes.starts_with(binary_magic) || bytes.starts_with(text_header);
}

FlipLog parse_flip_log(std::string_view bytes, const std::string& source) {
    RawFlipLog log = parse(bytes, source);
    BuildResult start = build(std::move(log.start.records), log.start.vertex_count);
    if (!start) {
        const Violation& first = start.report.violations.front();
        fail_at(bytes, bytes.size() - 1, source,
                "the log's start is no valid surface: " + where(first) + ": " + message(first));
    }
    return {std::move(start).value(), std::move(log.flips)};
}

RawFlipLog parse_flip_log_as_written(std::string_view bytes, const std::string& source) {
    RawFlipLog log = parse(bytes, source);
    ComparingBuffer buffer(bytes);
    std::ostream out(&buffer);  // the first byte that differs makes it fail, and it takes no more
    if (bytes.starts_with(binary_magic)) {
        write_binary(out, log);
    } else {
        write_text(out, log);
    }
    if (!out || buffer.matched() != bytes.size()) {
        fail_at(bytes, buffer.matched(), source,
                "the log is sound, but from here on not spelled as this program writes it; as a "
                "certificate every byte counts");
    }
    return log;
}

}  // namespace tightflip::kernel
