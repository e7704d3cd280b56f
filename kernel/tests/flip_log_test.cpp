#include "hostile_stream.hpp"
#include "refusals.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using testing::expect_refused_in_line;
using ::testing::HasSubstr;
using testing::refusal_of;

// ---- the two forms, written by hand ----

/// What a log says, whether it may or not.
struct Content {
    Index vertex_count = 0;
    std::vector<HalfedgeRecord> records;
    std::vector<std::uint64_t> flips;
};

Content content_of(const FlipLog& log) {
    const auto table = log.start.table();
    Content content{log.start.vertex_count(), {table.begin(), table.end()}, {}};
    for (const Edge e : log.flips)
        content.flips.push_back(static_cast<std::uint64_t>(e.id));
    return content;
}

std::string little_endian(std::uint64_t value, int bytes) {
    std::string text;
    for (; bytes > 0; --bytes, value >>= 8)
        text += static_cast<char>(value & 255U);
    return text;
}

/// All numbers of the content as 32-bit words, without the number of flips.
std::string words_of(const Content& content) {
    std::string words = little_endian(static_cast<std::uint32_t>(content.vertex_count), 4) +
                        little_endian(content.records.size(), 4);
    for (const auto& [next, origin] : content.records) {
        words += little_endian(static_cast<std::uint32_t>(next.id), 4);
        words += little_endian(static_cast<std::uint32_t>(origin.id), 4);
    }
    return words;
}

/// FNV-1a of 64 bits (Fowler, Noll, Vo).
std::uint64_t checksum_of(const Content& content) {
    std::string words = words_of(content);
    for (const std::uint64_t flip : content.flips)
        words += little_endian(flip, 4);
    std::uint64_t hash = 14695981039346656037U;
    for (const char byte : words) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    }
    return hash;
}

std::string binary_by_hand(const Content& content) {
    std::string bytes = "\x89TFLIPS\n" + little_endian(1, 4) + words_of(content) +
                        little_endian(content.flips.size(), 4);
    for (std::uint64_t flip : content.flips) {
        for (; flip > 127; flip /= 128)
            bytes += static_cast<char>(128 + flip % 128);
        bytes += static_cast<char>(flip);
    }
    return bytes + little_endian(checksum_of(content), 8);
}

std::string text_by_hand(const Content& content) {
    std::ostringstream out;
    out << "tightflip-flip-log 1\nvertices " << content.vertex_count << "\nhalfedges "
        << content.records.size() << '\n';
    for (const auto& [next, origin] : content.records)
        out << next.id << ' ' << origin.id << '\n';
    out << "flips " << content.flips.size() << '\n';
    for (const std::uint64_t flip : content.flips)
        out << flip << '\n';
    std::ostringstream sum;
    sum << std::hex << checksum_of(content);
    out << "check " << std::string(16 - sum.str().size(), '0') << sum.str() << '\n';
    return out.str();
}

// ---- the two forms, written by the code under test ----

std::string text_of(const FlipLog& log) {
    std::ostringstream out;
    write_text(out, log);
    return out.str();
}

std::string binary_of(const FlipLog& log) {
    std::ostringstream out;
    write_binary(out, log);
    return out.str();
}

FlipLog parse(std::string_view bytes) {
    return parse_flip_log(bytes, "run.log");
}

std::optional<FileError> refusal_of_bytes(const std::string& bytes) {
    return refusal_of([&] { return parse(bytes); });
}

/// Where a refusal points lies in what was read.
void expect_place_within(const FileError& refusal, const std::string& bytes) {
    EXPECT_EQ(refusal.source(), "run.log");
    if (refusal.unit() == FileError::Unit::byte) {
        EXPECT_LE(refusal.position(), bytes.size()) << refusal.what();
    } else {
        EXPECT_EQ(refusal.unit(), FileError::Unit::line) << refusal.what();
        EXPECT_LE(refusal.position(),
                  static_cast<std::uint64_t>(std::ranges::count(bytes, '\n')) + 1)
            << refusal.what();
    }
}

// ---- logs ----

/// Tries edges at random and keeps the flips that were done.
FlipLog random_log(const Triangulation& start, int attempts, std::uint64_t seed) {
    RandomStream random(seed);
    RecordedSurface recorded(start);
    for (; attempts > 0; --attempts) {
        const auto edges = static_cast<std::uint32_t>(start.edge_count());
        static_cast<void>(recorded.flip({static_cast<Index>(random.below(edges))}));
    }
    return recorded.log();
}

FlipLog small_log() {
    return {families::tetrahedron(), {{0}, {5}, {0}, {3}}};
}

std::vector<FlipLog> logs() {
    std::vector<FlipLog> logs{small_log(),
                              {families::tetrahedron(), {}},
                              {families::book(3), {}},
                              random_log(families::book(30), 500, 1),
                              random_log(families::torus_grid(3, 5), 500, 2),
                              random_log(families::surface_of_genus(3, 4, 1), 500, 3)};
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        logs.push_back(random_log(families::random(6, 0, seed), 40, seed));
    }
    return logs;
}

TEST(FlipLog, BothFormsAreWhatTheFormatSays) {
    for (const FlipLog& log : logs()) {
        const Content content = content_of(log);
        EXPECT_EQ(binary_of(log), binary_by_hand(content));
        EXPECT_EQ(parse(text_by_hand(content)), log);
        std::string text = text_of(log);  // comments are free
        for (auto at = text.find('#'); at != std::string::npos; at = text.find('#')) {
            text.erase(at, text.find('\n', at) + 1 - at);
        }
        EXPECT_EQ(text, text_by_hand(content));
    }
}

TEST(FlipLog, AFileOfVersionOneStaysReadable) {
    EXPECT_EQ(parse("tightflip-flip-log 1\n"
                    "vertices 4\n"
                    "halfedges 12\n"
                    "2 0\n6 1\n4 1\n9 2\n0 2\n11 0\n8 0\n5 3\n1 3\n10 1\n3 3\n7 2\n"
                    "flips 4\n"
                    "0\n5\n0\n3\n"
                    "check 4bfd76135284386b\n"),
              small_log());
}

TEST(FlipLog, RoundTripInBothForms) {
    for (const FlipLog& log : logs()) {
        EXPECT_EQ(parse(text_of(log)), log);
        EXPECT_EQ(parse(binary_of(log)), log);
    }
}

TEST(FlipLog, IsWrittenTheSameWhateverTheStreamsLocaleAndFlags) {
    const FlipLog log = random_log(families::book(300), 500, 1);
    const std::string text =
        testing::written_to_hostile_stream([&](auto& out) { write_text(out, log); });
    EXPECT_EQ(text, text_of(log));
    EXPECT_EQ(parse(text), log);
    EXPECT_EQ(testing::written_to_hostile_stream([&](auto& out) { write_binary(out, log); }),
              binary_of(log));
}

TEST(FlipLog, TheBinaryFormKeepsEdgesOfEveryLength) {
    const Triangulation start = families::book(6000);
    FlipLog log{start, {}};
    for (const Index e : {0, 1, 127, 128, 129, 255, 256, 16383, 16384, 16385, 17993}) {
        log.flips.push_back({e});
    }
    ASSERT_EQ(start.edge_count(), 17994);
    EXPECT_EQ(parse(binary_of(log)), log);
    EXPECT_EQ(parse(text_of(log)), log);
    const FlipLog none{start, {}};
    EXPECT_EQ(binary_of(log).size() - binary_of(none).size(), 3 * 1U + 5 * 2U + 3 * 3U);
}

TEST(FlipLog, TheTextTakesCommentsBlankLinesAndCrLf) {
    const FlipLog log = small_log();
    std::string text;
    for (const char c : text_of(log))
        text += c == '\n' ? std::string(" # why\r\n\r\n") : std::string(1, c);
    EXPECT_EQ(parse(text), log);
}

TEST(FlipLog, IsRecognisedByItsBeginning) {
    EXPECT_TRUE(is_flip_log(text_of(small_log())));
    EXPECT_TRUE(is_flip_log(binary_of(small_log())));
    for (const std::string bytes : {"", "tightflip-flip", "tightflip-triangulation 1\n", "TFLIPS\n",
                                    "\x89PNG\r\n\x1a\n", "OFF\n"}) {
        EXPECT_FALSE(is_flip_log(bytes)) << bytes;
    }
}

// ---- replay, record, undo ----

TEST(FlipLogReplay, IsTheDirectRun) {
    for (const Triangulation& start :
         {families::icosphere(1), families::book(40), families::random(9, 2, 5)}) {
        RandomStream random(11);
        Triangulation direct = start;
        FlipLog log{start, {}};
        for (int k = 0; k < 1000; ++k) {
            const Edge e{
                static_cast<Index>(random.below(static_cast<std::uint32_t>(start.edge_count())))};
            if (direct.flip(e)) log.flips.push_back(e);
        }
        const Replay replayed = replay(log);
        EXPECT_TRUE(replayed.is_complete());
        EXPECT_EQ(replayed.reason, "");
        EXPECT_EQ(replayed.done, log.flips.size());
        EXPECT_EQ(replayed.surface, direct);
        EXPECT_EQ(replay(parse(binary_of(log))).surface, direct);
        EXPECT_EQ(replay(parse(text_of(log))).surface, direct);
    }
}

TEST(FlipLogReplay, OfNoFlipsIsTheStart) {
    const Replay replayed = replay({families::book(3), {}});
    EXPECT_TRUE(replayed.is_complete());
    EXPECT_EQ(replayed.done, 0U);
    EXPECT_EQ(replayed.surface, families::book(3));
}

/// An edge that cannot be flipped.
Edge refused_edge(const Triangulation& surface) {
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (!surface.can_flip({e})) return {e};
    }
    throw std::logic_error("every edge can be flipped");
}

Edge flippable_edge(const Triangulation& surface) {
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (surface.can_flip({e})) return {e};
    }
    throw std::logic_error("no edge can be flipped");
}

TEST(FlipLogReplay, StopsAtARefusedFlip) {
    const Triangulation start = families::book(6);
    const Edge good = flippable_edge(start);
    Triangulation after = start;
    ASSERT_TRUE(after.flip(good));
    const Edge bad = refused_edge(after);
    const Replay replayed = replay({start, {good, bad, good}});
    EXPECT_FALSE(replayed.is_complete());
    EXPECT_EQ(replayed.done, 1U);
    EXPECT_EQ(replayed.surface, after);
    EXPECT_THAT(replayed.reason, HasSubstr("edge " + std::to_string(bad.id)));
    EXPECT_THAT(replayed.reason, HasSubstr("loop"));
}

TEST(FlipLogReplay, StopsAtAnEdgeThatDoesNotExist) {
    const Triangulation start = families::octasphere(0);
    using Limits = std::numeric_limits<Index>;
    for (const Index e : {-1, start.edge_count(), Limits::min(), Limits::max()}) {
        const Replay replayed = replay({start, {{0}, {0}, {e}, {0}}});
        EXPECT_FALSE(replayed.is_complete());
        EXPECT_EQ(replayed.done, 2U);
        EXPECT_THAT(replayed.reason, HasSubstr("edge " + std::to_string(e)));
        EXPECT_THAT(replayed.reason, HasSubstr("not exist"));
        EXPECT_EQ(replayed.surface, replay({start, {{0}, {0}}}).surface);
    }
}

TEST(RecordedSurface, RecordsWhatWasDoneAndNothingElse) {
    const Triangulation start = families::book(5);
    RecordedSurface recorded(start);
    EXPECT_EQ(recorded.surface(), start);
    EXPECT_EQ(recorded.log(), (FlipLog{start, {}}));

    const FlipVerdict refused = recorded.flip(refused_edge(start));
    EXPECT_EQ(refused.refusal(), FlipRefusal::opposite_corners_coincide);
    EXPECT_THROW(static_cast<void>(recorded.flip({start.edge_count()})), std::out_of_range);
    EXPECT_THROW(static_cast<void>(recorded.flip({-1})), std::out_of_range);
    EXPECT_EQ(recorded.surface(), start);
    EXPECT_EQ(recorded.log(), (FlipLog{start, {}}));

    const Edge e = flippable_edge(start);
    Triangulation direct = start;
    EXPECT_TRUE(direct.flip(e));
    EXPECT_TRUE(recorded.flip(e));
    EXPECT_EQ(recorded.surface(), direct);
    EXPECT_EQ(recorded.log(), (FlipLog{start, {e}}));
}

TEST(RecordedSurface, UndoGoesBackBitForBit) {
    for (const Triangulation& start :
         {families::icosphere(0), families::book(8), families::random(5, 2, 3)}) {
        RandomStream random(5);
        RecordedSurface recorded(start);
        std::vector<Triangulation> history{start};
        while (history.size() < 200) {
            const Edge e{
                static_cast<Index>(random.below(static_cast<std::uint32_t>(start.edge_count())))};
            if (recorded.flip(e)) history.push_back(recorded.surface());
        }
        for (; history.size() > 1; history.pop_back()) {
            ASSERT_EQ(recorded.surface(), history.back());
            ASSERT_EQ(recorded.log().flips.size(), history.size() - 1);
            ASSERT_TRUE(recorded.undo());
        }
        EXPECT_EQ(recorded.surface(), start);
        EXPECT_EQ(recorded.log(), (FlipLog{start, {}}));
        EXPECT_FALSE(recorded.undo());
        EXPECT_EQ(recorded.surface(), start);
    }
}

TEST(RecordedSurface, ContinuesALog) {
    const FlipLog whole = random_log(families::random(10, 1, 1), 100, 8);
    FlipLog half = whole;
    half.flips.resize(whole.flips.size() / 2);
    RecordedSurface recorded(half);
    EXPECT_EQ(recorded.surface(), replay(half).surface);
    EXPECT_EQ(recorded.log(), half);
    for (std::size_t k = half.flips.size(); k < whole.flips.size(); ++k) {
        ASSERT_TRUE(recorded.flip(whole.flips[k]));
    }
    EXPECT_EQ(recorded.log(), whole);
    EXPECT_EQ(recorded.surface(), replay(whole).surface);
    while (recorded.undo())
        continue;
    EXPECT_EQ(recorded.surface(), whole.start);
}

TEST(RecordedSurface, RefusesALogThatDoesNotReplay) {
    const Triangulation start = families::book(6);
    const Edge good = flippable_edge(start);
    for (const Edge bad : {refused_edge(start), Edge{start.edge_count()}, Edge{-1}}) {
        try {
            const RecordedSurface recorded(FlipLog{start, {good, good, good, good, bad}});
            FAIL() << "edge " << bad.id;
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), HasSubstr("flip 4"));
            EXPECT_THAT(error.what(), HasSubstr("edge " + std::to_string(bad.id)));
        }
    }
}

// ---- damage ----

TEST(FlipLogDamage, EveryTruncationIsRefused) {
    for (const FlipLog& log : {small_log(), random_log(families::random(5, 1, 2), 30, 9)}) {
        const std::string binary = binary_of(log);
        for (std::size_t size = 0; size < binary.size(); ++size) {
            const std::string cut = binary.substr(0, size);
            const auto refusal = refusal_of_bytes(cut);
            ASSERT_TRUE(refusal) << "the first " << size << " bytes";
            EXPECT_EQ(refusal->unit(), FileError::Unit::byte);
            expect_place_within(*refusal, cut);
        }
        const std::string text = text_of(log);
        for (std::size_t size = 0; size + 1 < text.size(); ++size) {
            const std::string cut = text.substr(0, size);
            const auto refusal = refusal_of_bytes(cut);
            ASSERT_TRUE(refusal) << "the first " << size << " bytes";
            expect_place_within(*refusal, cut);
        }
        EXPECT_EQ(parse(text.substr(0, text.size() - 1)), log) << "the last newline may lack";
    }
}

TEST(FlipLogDamage, NoChangedByteGoesUnnoticed) {
    const FlipLog log = small_log();
    for (const std::string& bytes : {binary_of(log), text_of(log)}) {
        std::size_t harmless = 0;
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (int byte = 0; byte < 256; ++byte) {
                std::string damaged = bytes;
                damaged[at] = static_cast<char>(byte);
                if (damaged == bytes) continue;
                std::optional<FlipLog> read;
                if (const auto refusal = refusal_of([&] { read = parse(damaged); })) {
                    expect_place_within(*refusal, damaged);
                    continue;
                }
                ++harmless;
                ASSERT_EQ(*read, log) << "byte " << at << " became " << byte;
            }
        }
        if (bytes.front() == '\x89') {
            EXPECT_EQ(harmless, 0U);
        }
    }
}

TEST(FlipLogDamage, NoChangedDigitGoesUnnoticed) {
    const std::string text = text_of(small_log());
    bool comment = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        comment = text[at] == '#' || (comment && text[at] != '\n');
        if (comment || text[at] < '0' || text[at] > '9') continue;
        for (const char digit : std::string_view("0123456789")) {
            std::string damaged = text;
            damaged[at] = digit;
            if (damaged != text) {
                EXPECT_TRUE(refusal_of_bytes(damaged)) << at << ' ' << digit;
            }
        }
    }
}

TEST(FlipLogDamage, NoLostOrDoubledByteGoesUnnoticed) {
    const std::string bytes = binary_of(small_log());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const std::string lost = bytes.substr(0, at) + bytes.substr(at + 1);
        EXPECT_TRUE(refusal_of_bytes(lost)) << at;
        const std::string doubled = bytes.substr(0, at + 1) + bytes.substr(at);
        EXPECT_TRUE(refusal_of_bytes(doubled)) << at;
    }
    EXPECT_TRUE(refusal_of_bytes(bytes + '\0'));
    EXPECT_TRUE(refusal_of_bytes(bytes + bytes));
}

TEST(FlipLogDamage, SwappedFlipsAreRefused) {
    FlipLog log = small_log();
    const Content content = content_of(log);
    std::swap(log.flips[0], log.flips[1]);
    std::string text = text_of(log);
    const std::string original = text_by_hand(content);
    text.replace(text.find("check"), std::string::npos, original.substr(original.find("check")));
    const auto refusal = refusal_of_bytes(text);
    ASSERT_TRUE(refusal);
    EXPECT_THAT(refusal->reason(), HasSubstr("checksum"));
}

TEST(FlipLogDamage, SeededDamageDoesNothingButThrow) {
    const FlipLog log = random_log(families::random(6, 1, 2), 60, 4);
    RandomStream random(77);
    for (const std::string& bytes : {binary_of(log), text_of(log)}) {
        for (int run = 0; run < 5000; ++run) {
            std::string damaged = bytes;
            for (auto k = 1 + random.below(4); k > 0; --k) {
                const auto at = random.below(static_cast<std::uint32_t>(damaged.size()));
                damaged[at] = static_cast<char>(random.below(256));
            }
            std::optional<FlipLog> read;
            if (const auto refusal = refusal_of([&] { read = parse(damaged); })) continue;
            ASSERT_EQ(*read, log) << "run " << run;
        }
    }
}

TEST(FlipLogDamage, ForeignFilesAreRefused) {
    for (const std::string bytes :
         {"", "\n", "x", "tightflip-triangulation 1\nvertices 0\nhalfedges 0\nend\n",
          "OFF\n3 1 0\n", "\x89PNG\r\n\x1a\n", "\x89TFLIP", " tightflip-flip-log 1\n"}) {
        const auto refusal = refusal_of_bytes(bytes);
        ASSERT_TRUE(refusal) << bytes;
        EXPECT_EQ(refusal->position(), 0U);
        EXPECT_THAT(refusal->reason(), HasSubstr("no flip log"));
    }
    EXPECT_TRUE(refusal_of_bytes("tightflip-flip-logs 1\n"));
}

TEST(FlipLogDamage, OtherVersionsAreRefused) {
    for (const char version : {'0', '2', '9'}) {
        std::string text = text_of(small_log());
        text[text.find(" 1\n") + 1] = version;
        expect_refused_in_line(refusal_of_bytes(text), 1, "version");

        std::string binary = binary_of(small_log());
        binary[8] = static_cast<char>(version - '0');
        const auto refusal = refusal_of_bytes(binary);
        ASSERT_TRUE(refusal);
        EXPECT_THAT(refusal->reason(), HasSubstr(std::string("version ") + version));
        EXPECT_GE(refusal->position(), 8U);
        EXPECT_LE(refusal->position(), 12U);
    }
}

TEST(FlipLogDamage, TextOutOfPlaceIsRefusedInItsLine) {
    const std::string text = text_by_hand(content_of(small_log()));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        return changed.replace(changed.find(from), from.size(), to);
    };
    const auto check = text.find("check ");
    expect_refused_in_line(refusal_of_bytes(with("vertices", "faces")), 2, "vertices");
    expect_refused_in_line(refusal_of_bytes(with("flips 4", "flips -4")), 16, "-4");
    expect_refused_in_line(refusal_of_bytes(with("flips 4", "flips 2000000000")), 16, "announced");
    expect_refused_in_line(refusal_of_bytes(with("flips 4", "flips 5")), 21, "edge");
    expect_refused_in_line(refusal_of_bytes(with("flips 4", "flips 3")), 20, "check");
    expect_refused_in_line(refusal_of_bytes(text.substr(0, check)), 20, "check");
    expect_refused_in_line(refusal_of_bytes(text.substr(0, check + 6)), 21, "16 hexadecimal");
    expect_refused_in_line(refusal_of_bytes(text.substr(0, text.size() - 2)), 21, "16 hexadecimal");
    expect_refused_in_line(refusal_of_bytes(with("check ", "check 0")), 21, "16 hexadecimal");
    expect_refused_in_line(refusal_of_bytes(text.substr(0, check) + "check 0x00000000000000\n"), 21,
                           "16 hexadecimal");
    expect_refused_in_line(refusal_of_bytes(text + "end\n"), 22, "nothing should follow");
}

TEST(FlipLogDamage, HugeCountsAreRefusedWhereTheyStand) {
    const std::string bytes = binary_of(small_log());
    const std::size_t halfedges = 16;
    const std::size_t flips = 20 + 12 * 8;
    for (const std::size_t at : {halfedges, flips}) {
        for (const std::uint64_t count : {0x7fffffffULL, 0x80000000ULL, 0xffffffffULL, 1000ULL}) {
            std::string damaged = bytes;
            damaged.replace(at, 4, little_endian(count, 4));
            const auto refusal = refusal_of_bytes(damaged);
            ASSERT_TRUE(refusal);
            EXPECT_THAT(refusal->reason(), HasSubstr("announced"));
            EXPECT_GE(refusal->position(), at);
            EXPECT_LE(refusal->position(), at + 4);
        }
    }
}

TEST(FlipLogDamage, NeitherFormTakesANegativeNumberOfVertices) {
    Content content = content_of(small_log());
    content.vertex_count = -218103804;
    const std::string bytes = binary_by_hand(content);
    for (const auto& refusal : {refusal_of_bytes(bytes), refusal_of([&] {
                                    return parse_flip_log_as_written(bytes, "run.log");
                                })}) {
        ASSERT_TRUE(refusal);
        EXPECT_EQ(refusal->position(), 16U);
        EXPECT_THAT(refusal->reason(), HasSubstr("-218103804"));
    }
    expect_refused_in_line(refusal_of_bytes(text_by_hand(content)), 2, "vertices");
}

// ---- well written, but wrong ----

TEST(FlipLogDamage, AStartThatIsNoSurfaceIsRefused) {
    const Content good = content_of(small_log());
    struct Case {
        const char* word;
        std::function<void(Content&)> damage;
    };
    for (const auto& [word, damage] :
         {Case{"no face", [](Content& c) { c = {}; }},
          Case{"odd number", [](Content& c) { c.records.pop_back(); }},
          Case{"next", [](Content& c) { c.records[3].next = {99}; }},
          Case{"next", [](Content& c) { c.records[3].next = {-1}; }},
          Case{"origin", [](Content& c) { c.records[3].origin = {4}; }},
          Case{"next", [](Content& c) { std::swap(c.records[0].next, c.records[1].next); }},
          Case{"corners",
               [](Content& c) {
                   for (HalfedgeRecord& r : c.records) {
                       if (r.origin.id == 3) r.origin = {0};
                   }
                   c.vertex_count = 3;
               }},
          Case{"no face uses it", [](Content& c) { c.vertex_count = 5; }},
          Case{"parts", [](Content& c) {
                   const std::vector<HalfedgeRecord> once = c.records;
                   for (const auto& [next, origin] : once) {
                       c.records.push_back({{next.id + 12}, {origin.id + 4}});
                   }
                   c.vertex_count = 8;
               }}}) {
        Content content = good;
        content.flips = {};
        damage(content);
        const auto binary = refusal_of_bytes(binary_by_hand(content));
        ASSERT_TRUE(binary) << word;
        EXPECT_THAT(binary->reason(), HasSubstr("no valid surface"));
        EXPECT_THAT(binary->reason(), HasSubstr(word));
        const auto text = refusal_of_bytes(text_by_hand(content));
        ASSERT_TRUE(text) << word;
        EXPECT_EQ(text->unit(), FileError::Unit::line);
        EXPECT_THAT(text->reason(), HasSubstr(word));
    }
}

TEST(FlipLogDamage, AnEdgeThatDoesNotExistIsRefusedThoughTheChecksumFits) {
    for (const std::uint64_t edge :
         {6ULL, 127ULL, 128ULL, 70000ULL, 0x7fffffffULL, 0x80000000ULL, 0xffffffffULL,
          0x100000000ULL, 0x100000005ULL, 0x7ffffffffULL, 0x7fffffffffULL, 0x8000000000000000ULL}) {
        Content content = content_of(small_log());
        content.flips = {0, 5, edge, 1};
        const std::string bytes = binary_by_hand(content);
        const auto refusal = refusal_of_bytes(bytes);
        ASSERT_TRUE(refusal) << edge;
        const std::size_t at = 20 + 12 * 8 + 4 + 2;
        EXPECT_GE(refusal->position(), at) << refusal->what();
        EXPECT_LT(refusal->position(), bytes.size() - 8) << refusal->what();
        expect_refused_in_line(refusal_of_bytes(text_by_hand(content)), 19, "edge");
    }
}

TEST(FlipLogDamage, AFlipThatIsRefusedIsNoDamage) {
    const Triangulation start = families::book(6);
    const FlipLog log{start, {refused_edge(start)}};
    EXPECT_EQ(parse(binary_of(log)), log) << "replay says what is wrong with it";
    EXPECT_FALSE(replay(parse(text_of(log))).is_complete());
}

// ---- logs that count byte by byte ----

TEST(FlipLogAsWritten, TakesWhatWasWrittenInEitherForm) {
    RecordedSurface surface(families::random(200, 1, 3));  // edges of one byte and of two
    for (Index e = 0; e < surface.surface().edge_count(); ++e)
        surface.flip({e});
    for (const std::string& bytes : {text_of(surface.log()), binary_of(surface.log())}) {
        const RawFlipLog log = parse_flip_log_as_written(bytes, "run.log");
        EXPECT_EQ(log.flips, surface.log().flips);
        EXPECT_EQ(log.start.vertex_count, 200);
        EXPECT_TRUE(std::ranges::equal(log.start.records, surface.log().start.table()));
    }
}

TEST(FlipLogAsWritten, RefusesAnotherSpellingInItsLine) {
    const std::string text = text_of(small_log());
    const auto with = [&](const std::string& old, const std::string& spelling) {
        std::string changed = text;
        const std::size_t at = text.find(old);
        return at == std::string::npos ? "nothing to change"
                                       : changed.replace(at, old.size(), spelling);
    };
    const auto capitals = [&] {
        std::string changed = text;
        const auto sum = changed.begin() + static_cast<std::ptrdiff_t>(changed.find("check ")) + 6;
        std::transform(sum, changed.end(), sum, [](char c) {
            return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        });
        return changed;
    };
    const auto last_line = static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
    struct Case {
        std::string text;
        std::uint64_t line;
    };
    for (const auto& [changed, line] :
         {Case{with("vertices 4", "vertices  4"), 2}, Case{with("vertices 4", "vertices 04"), 2},
          Case{with("vertices 4\n", "vertices 4 # four\n"), 2},
          Case{with("vertices 4\n", "vertices 4\r\n"), 2},
          Case{with("vertices 4\n", "vertices 4\n\n"), 3}, Case{with("# next", "# Next"), 4},
          Case{with("# next", " # next"), 4}, Case{capitals(), last_line},
          Case{text.substr(0, text.size() - 1), last_line}, Case{text + " ", last_line + 1}}) {
        EXPECT_EQ(parse(changed), small_log()) << "a reader may pass over it: " << changed;
        expect_refused_in_line(refusal_of([&, &bytes = changed] {
                                   return parse_flip_log_as_written(bytes, "run.log");
                               }),
                               line, "every byte counts");
    }
}

TEST(FlipLogAsWritten, RefusesALongerSpellingOfANumberInTheBinaryForm) {
    Content content = content_of(small_log());
    content.flips = {5, 3};
    std::string bytes = binary_by_hand(content);
    const std::size_t first_flip = bytes.size() - 8 - 2;
    bytes.replace(first_flip, 1, "\x85" + std::string(1, '\0'));
    EXPECT_EQ(parse(bytes).flips, (std::vector<Edge>{{5}, {3}}));
    const auto refusal = refusal_of([&] { return parse_flip_log_as_written(bytes, "run.log"); });
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->unit(), FileError::Unit::byte);
    EXPECT_EQ(refusal->position(), first_flip);
}

TEST(FlipLogAsWritten, ItsStartIsNotJudged) {
    Content content = content_of(small_log());
    content.records[3].next = {99};
    EXPECT_EQ(parse_flip_log_as_written(binary_by_hand(content), "run.log").start.records[3].next,
              Halfedge{99});
}

}  // namespace
}  // namespace tightflip::kernel
