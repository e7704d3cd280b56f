#include "flip_log.hpp"

#include "reading.hpp"
#include "seed_surfaces.hpp"
#include "targets.hpp"
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/shorten.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace tightflip::fuzz {
namespace {

using kernel::Edge;
using kernel::FlipLog;
using kernel::Index;
using kernel::RawFlipLog;
using kernel::Triangulation;

const std::string source = "the log";
constexpr std::string_view binary_mark = "\x89TFLIPS\n";
constexpr std::size_t words_before_records = 3;  // version, vertices, halfedges
constexpr std::size_t checksum_size = 8;

// ---- the checksum, once more ----

/// FNV-1a over little-endian words.
class Fnv {
public:
    void add(std::uint32_t word) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            hash_ ^= word >> shift & 0xffU;
            hash_ *= 0x100000001b3ULL;
        }
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::uint32_t word_at(std::string_view bytes, std::size_t place) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i)
        word |= std::uint32_t{static_cast<std::uint8_t>(bytes[place + i])} << 8 * i;
    return word;
}

std::string with_right_binary_checksum(std::string_view bytes) {
    constexpr std::size_t head = binary_mark.size() + 4 * words_before_records;
    if (bytes.size() < head + 4 + checksum_size) return std::string(bytes);
    const std::uint32_t halfedges = word_at(bytes, head - 4);
    const std::size_t records_end = head + std::size_t{8} * halfedges;
    if (records_end + 4 + checksum_size > bytes.size()) return std::string(bytes);
    Fnv sum;
    for (std::size_t place = binary_mark.size() + 4; place < records_end; place += 4)
        sum.add(word_at(bytes, place));
    std::uint32_t edge = 0;
    unsigned shift = 0;
    for (std::size_t place = records_end + 4; place < bytes.size() - checksum_size; ++place) {
        const auto part = static_cast<std::uint8_t>(bytes[place]);
        if (shift < 32) edge |= std::uint32_t{part & 0x7fU} << shift;
        shift += 7;
        if (part >= 0x80U) continue;
        sum.add(edge);
        edge = shift = 0;
    }
    std::string mended(bytes);
    for (unsigned i = 0; i < checksum_size; ++i)
        mended[bytes.size() - checksum_size + i] = static_cast<char>(sum.value() >> 8 * i & 0xffU);
    return mended;
}

/// The numbers of the lines before "check", comments left out; the words between do not matter.
std::vector<std::uint32_t> numbers_in(std::string_view text) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t place = 0; place < text.size();) {
        if (text[place] == '#') {
            place = std::min(text.find('\n', place), text.size());
            continue;
        }
        std::int64_t number = 0;
        const char* const begin = text.data() + place;
        const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
        if (error == std::errc{}) numbers.push_back(static_cast<std::uint32_t>(number));
        place += end == begin ? 1 : static_cast<std::size_t>(end - begin);
    }
    return numbers;
}

std::string with_right_text_checksum(std::string_view text) {
    const std::size_t check = text.rfind("check ");
    if (check == std::string_view::npos || text.size() < check + 22) return std::string(text);
    const std::vector<std::uint32_t> numbers = numbers_in(text.substr(0, check));
    if (numbers.size() < words_before_records) return std::string(text);
    Fnv sum;
    const std::uint64_t flips = words_before_records + 2 * std::uint64_t{numbers[2]};
    for (std::size_t i = 1; i < numbers.size(); ++i) {  // neither the version nor how many flips
        if (i != flips) sum.add(numbers[i]);
    }
    std::string mended(text);
    for (unsigned i = 0; i < 16; ++i)
        mended[check + 6 + i] = "0123456789abcdef"[sum.value() >> (60 - 4 * i) & 0xfU];
    return mended;
}

// ---- claims ----

std::string binary(const kernel::FlipLogView& log) {
    return written([&](std::ostream& out) { write_binary(out, log); });
}
std::string text(const kernel::FlipLogView& log) {
    return written([&](std::ostream& out) { write_text(out, log); });
}

bool are_same(const RawFlipLog& a, const RawFlipLog& b) {
    return a.start == b.start && a.flips == b.flips;
}

/// Recording the flips again, and taking them all back.
std::string recording_agrees(const FlipLog& log, const kernel::Replay& followed) {
    kernel::RecordedSurface recorded(log.start);
    std::size_t done = 0;
    while (done < log.flips.size() && recorded.flip(log.flips[done]))
        ++done;
    if (done != followed.done || !(recorded.surface() == followed.surface)) {
        return "recording_agrees_with_replay: " + std::to_string(done) + " flips, " +
               std::to_string(followed.done) + " in the replay";
    }
    try {
        const kernel::RecordedSurface again(log);
        if (!followed.is_complete()) return "logs_that_do_not_replay_are_refused: it was not";
        if (!(again.log() == log)) return "logs_go_on_where_they_ended: they do not";
    } catch (const std::invalid_argument& error) {
        if (followed.is_complete())
            return std::string("logs_go_on_where_they_ended: ") + error.what();
    }
    while (recorded.undo()) {
    }
    return recorded.surface() == log.start && recorded.log().flips.empty()
               ? std::string()
               : "undoing_leads_to_the_start: it does not";
}

std::string following_agrees(const FlipLog& log) {
    const kernel::Replay followed = replay(log);
    if (auto objection = recording_agrees(log, followed); !objection.empty()) return objection;
    const kernel::CertificateVerdict verdict = verify(log.start, followed.surface, log);
    if (static_cast<bool>(verdict) != followed.is_complete() ||
        verdict.flips_done != followed.done) {
        return "certificates_agree_with_replay: " + verdict.reason + "; replay: " + followed.reason;
    }
    if (!followed.is_complete()) return {};
    const FlipLog shorter = kernel::shorten(log);
    const kernel::Replay short_cut = replay(shorter);
    const bool holds = shorter.start == log.start && shorter.flips.size() <= log.flips.size() &&
                       short_cut.is_complete() &&
                       same_labelled_surface(short_cut.surface, followed.surface);
    return holds ? std::string() : "shortening_keeps_the_ends: it does not";
}

std::string objection_to_log(std::string_view bytes) {
    const auto read = attempt(bytes, [&] { return kernel::parse_flip_log(bytes, source); });
    const auto strict =
        attempt(bytes, [&] { return kernel::parse_flip_log_as_written(bytes, source); });
    for (const std::string& objection : {read.objection, strict.objection}) {
        if (!objection.empty()) return objection;
    }
    if ((read.value || strict.value) && !kernel::is_flip_log(bytes)) {
        return "logs_are_recognised: this one is not";
    }
    if (strict.value) {
        const std::string again =
            bytes.starts_with(binary_mark) ? binary(*strict.value) : text(*strict.value);
        if (again != bytes) return "strict_reading_takes_every_byte: it does not";
        for (const std::string& form : {binary(*strict.value), text(*strict.value)}) {
            if (!are_same(kernel::parse_flip_log_as_written(form, source), *strict.value)) {
                return "logs_written_read_the_same: they do not";
            }
        }
        const bool is_valid =
            audit(strict.value->start.records, strict.value->start.vertex_count).is_valid();
        if (is_valid != read.value.has_value()) {
            return "logs_of_valid_starts_are_read: " + read.refusal;
        }
    }
    if (!read.value) return {};
    for (const std::string& form : {binary(*read.value), text(*read.value)}) {
        if (!(kernel::parse_flip_log(form, source) == *read.value)) {
            return "logs_written_read_the_same: they do not";
        }
        static_cast<void>(kernel::parse_flip_log_as_written(form, source));
    }
    return following_agrees(*read.value);
}

// ---- seeds ----

FlipLog random_log(const Triangulation& start, std::size_t flips, bool refused_too) {
    FlipLog log{start, {}};
    Triangulation surface = start;
    kernel::RandomStream random(flips);
    for (std::size_t k = 0; k < flips; ++k) {
        const Edge e{
            static_cast<Index>(random.below(static_cast<std::uint32_t>(surface.edge_count())))};
        if (surface.flip(e) || refused_too) log.flips.push_back(e);
    }
    return log;
}

struct Edit {
    const char* name;
    std::string_view what;
    std::string_view by;
};
constexpr std::array edits{
    Edit{"comment", "check", "# a comment\ncheck"},
    Edit{"line_ends_of_windows", "\ncheck", "\r\ncheck"},
    Edit{"leading_zero", "vertices 4", "vertices 04"},
    Edit{"blank_line", "flips", "\nflips"},
    Edit{"version_of_the_future", " 1\n", " 2\n"},
    Edit{"flips_huge", "flips 5", "flips 2147483647"},
    Edit{"flips_too_few", "flips 5", "flips 4"},
    Edit{"no_such_edge", "flips 5\n", "flips 6\n6\n"},
    Edit{"start_is_no_surface", "vertices 4", "vertices 5"},
    Edit{"start_is_empty", "halfedges 12", "halfedges 0"},
    Edit{"no_checksum", "check ", "chekc "},
    Edit{"checksum_too_short", "check ", "check"},
    Edit{"checksum_of_other_letters", "check ", "check g"},
};

std::vector<Seed> seeds() {
    std::vector<Seed> seeds{{"empty", {}}};
    const auto add = [&](const std::string& name, const std::string& bytes) {
        seeds.push_back({name, as_bytes(bytes)});
    };
    constexpr std::size_t flips = 5;
    FlipLog log = random_log(kernel::families::tetrahedron(), 2 * flips, false);
    log.flips.resize(flips, log.flips.front());
    const std::string as_text = text(log);
    const std::string as_binary = binary(log);
    for (const auto& [name, what, by] : edits) {
        const std::size_t place = as_text.find(what);
        const std::string edited = std::string(as_text).replace(place, what.size(), by);
        add(std::string("text_") + name, edited);
        add(std::string("mended_") + name, with_right_checksum(edited));
    }
    std::string capitals = as_text;
    for (std::size_t i = capitals.rfind(' '); i < capitals.size(); ++i)
        capitals[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(capitals[i])));
    add("text_capitals", capitals);
    add("text_more_after_the_checksum", as_text + "more\n");
    add("text_without_the_last_line_end", as_text.substr(0, as_text.size() - 1));
    add("binary_mark_alone", std::string(binary_mark));
    add("binary_truncated", as_binary.substr(0, as_binary.size() - 9));
    add("binary_more_after_the_checksum", as_binary + '\0');
    add("binary_version_of_the_future", std::string(as_binary).replace(8, 1, "\2"));
    add("binary_halfedges_huge", std::string(as_binary).replace(16, 4, "\xff\xff\xff\x7f"));
    add("binary_edge_of_six_bytes", std::string(as_binary).replace(as_binary.size() - 8 - flips,
                                                                   flips, "\xff\xff\xff\xff\xff"));
    add("binary_edge_out_of_range",
        std::string(as_binary).replace(as_binary.size() - 9, 1, "\x7f"));
    std::string long_winded = as_binary;
    long_winded[long_winded.size() - 9] |= '\x80';
    add("binary_edge_in_a_byte_too_many", long_winded.insert(long_winded.size() - 8, 1, '\0'));
    add("binary_negative_vertices",
        with_right_checksum(std::string(as_binary).replace(12, 4, "\xff\xff\xff\xff")));
    add("binary_wrong_checksum", std::string(as_binary).replace(as_binary.size() - 1, 1, "?"));
    for (const SeedSurface& seed : seed_surfaces()) {
        add("text_" + seed.name, text(random_log(seed.surface, 12, false)));
        add("binary_" + seed.name, binary(random_log(seed.surface, 30, false)));
    }
    add("text_refused_flip", text(random_log(kernel::families::book(4), 12, true)));
    add("binary_refused_flip", binary(random_log(kernel::families::book(3), 3, true)));
    return seeds;
}

}  // namespace

std::string with_right_checksum(std::string_view bytes) {
    return bytes.starts_with(binary_mark) ? with_right_binary_checksum(bytes)
                                          : with_right_text_checksum(bytes);
}

std::string flip_log_objection(std::string_view bytes) {
    std::string objection = objection_to_log(bytes);
    return objection.empty() ? objection_to_log(with_right_checksum(bytes)) : objection;
}

const Target flip_log_target{
    .name = "flip_log",
    .description =
        "bytes as a flip log, also with the right checksum: read or refused with the "
        "place, written, read again the same, followed, recorded, shortened",
    .layout = {},
    .objection = [](Input input) { return flip_log_objection(as_text(input)); },
    .show = show_bytes,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
