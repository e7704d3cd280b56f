#include "command_runner.hpp"
#include "documented_keys.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::UnorderedElementsAre;

/// A log written by the description in docs/formats.md, without the library.
struct Log {
    int vertices = 0;
    std::vector<std::array<int, 2>> table;  ///< next and origin
    std::vector<int> flips;

    [[nodiscard]] std::vector<int> words() const {
        std::vector<int> words{vertices, static_cast<int>(table.size())};
        for (const auto& [next, origin] : table)
            words.insert(words.end(), {next, origin});
        words.insert(words.end(), flips.begin(), flips.end());
        return words;
    }
    [[nodiscard]] std::uint64_t sum() const {
        std::uint64_t hash = 14695981039346656037U;
        for (const int word : words()) {
            for (const char byte : little_endian(static_cast<std::uint32_t>(word), 4)) {
                hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
            }
        }
        return hash;
    }
    [[nodiscard]] std::string text() const {
        std::ostringstream out;
        out << "tightflip-flip-log 1\nvertices " << vertices << "\nhalfedges " << table.size()
            << "\n";
        for (const auto& [next, origin] : table)
            out << next << ' ' << origin << '\n';
        out << "flips " << flips.size() << '\n';
        for (const int edge : flips)
            out << edge << '\n';
        std::array<char, 17> digits{};
        std::snprintf(digits.data(), digits.size(), "%016jx", static_cast<std::uintmax_t>(sum()));
        out << "check " << digits.data() << '\n';
        return out.str();
    }
    /// For edges below 128, which take one byte each.
    [[nodiscard]] std::string binary() const {
        std::string bytes = "\x89TFLIPS\n" + little_endian(1, 4);
        const std::vector<int> all = words();
        for (std::size_t i = 0; i < 2 + 2 * table.size(); ++i)
            bytes += little_endian(static_cast<std::uint32_t>(all[i]), 4);
        bytes += little_endian(flips.size(), 4);
        for (const int edge : flips)
            bytes += static_cast<char>(edge);
        return bytes + little_endian(sum(), 8);
    }

    static std::string little_endian(std::uint64_t value, int count) {
        std::string bytes;
        for (int i = 0; i < count; ++i)
            bytes += static_cast<char>((value >> (8 * i)) & 255U);
        return bytes;
    }
};

class Replay : public CommandTest {
protected:
    /// A log that starts from a surface that the command makes.
    Log log_from(const std::string& kind, std::vector<int> flips) {
        run({"make", kind, "-o", "start"});
        Log log;
        std::istringstream in(read("start"));
        std::size_t halfedges = 0;
        std::string word;
        in >> word >> word >> word >> log.vertices >> word >> halfedges;
        std::getline(in, word);
        std::getline(in, word);  // the comment
        log.table.resize(halfedges);
        for (auto& [next, origin] : log.table)
            in >> next >> origin;
        log.flips = std::move(flips);
        std::filesystem::remove(path("start"));
        return log;
    }
};

TEST_F(Replay, KeysAreAsDocumented) {
    write("log", log_from("octasphere", {3, 7, 3}).text());
    expect_as_documented("replay", run_json({"replay", "log", "-o", "end"}));
    write("refused", log_from("book", {0}).text());
    expect_as_documented("replay", run_json({"replay", "refused"}, 1));
}

TEST_F(Replay, FollowsBothFormsOfALog) {
    const Log log = log_from("octasphere", {3, 7, 3});
    write("text", log.text());
    write("binary", log.binary());
    std::string with_crlf = log.text();
    for (std::size_t at = 0; (at = with_crlf.find('\n', at)) != std::string::npos; at += 2)
        with_crlf.insert(at, "\r");
    write("crlf", with_crlf);
    for (const std::string name : {"text", "binary", "crlf"}) {
        SCOPED_TRACE(name);
        const Json json = run_json({"replay", "--audit-every", "1", name, "-o", name + ".end"});
        EXPECT_EQ(json["verdict"], "holds");
        EXPECT_EQ(json["flips"], 3);
        EXPECT_EQ(json["flips_done"], 3);
        EXPECT_EQ(json["vertices"], 6);
        EXPECT_EQ(json["genus"], 0);
        EXPECT_EQ(json["violations"], Json::array());
        EXPECT_EQ(read(name + ".end"), read("text.end"));
    }
    EXPECT_EQ(run_json({"check", "text.end"})["valid"], true);
    EXPECT_THAT(run({"replay", "text"}).out, HasSubstr("text: holds: 3 flips on 6 vertices"));
}

TEST_F(Replay, ALogWithARefusedFlipDoesNotHold) {
    write("log", log_from("book", {1}).text());  // three vertices: every flip would make a loop
    const Json json = run_json({"replay", "log", "-o", "end"}, 1);
    EXPECT_EQ(json["verdict"], "violated");
    EXPECT_EQ(json["flips_done"], 0);
    EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr("edge 1"));
    EXPECT_FALSE(json.contains("output"));
    EXPECT_THAT(names(), UnorderedElementsAre("log"));
}

TEST_F(Replay, RefusesATextCutAnywhere) {
    const std::string text = log_from("tetrahedron", {0, 3}).text();
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    std::string cut = "tightflip-flip-log";
    for (std::size_t kept = 0; kept < lines.size(); ++kept) {
        SCOPED_TRACE(kept);
        write("log", cut);
        expect_unusable({"replay", "log", "-o", "end"}, {"log:"});
        EXPECT_THAT(run({"replay", "log"}).err, MatchesRegex("tightflip: log:[0-9]+: .+\n"));
        cut = kept == 0 ? lines[0] + "\n" : cut + lines[kept] + "\n";
    }
    EXPECT_THAT(names(), UnorderedElementsAre("log"));
}

TEST_F(Replay, RefusesABinaryLogCutAnywhere) {
    const std::string bytes = log_from("tetrahedron", {0, 3}).binary();
    for (std::size_t size = 8; size < bytes.size(); size += 7) {
        SCOPED_TRACE(size);
        write("log", bytes.substr(0, size));
        expect_unusable({"replay", "log"}, {"log: byte "});
    }
}

TEST_F(Replay, RefusesATamperedLogAndSaysWhere) {
    const Log log = log_from("tetrahedron", {0, 3});
    const std::string text = log.text();
    const auto edited = [&](const std::string& from, const std::string& to) {
        std::string copy = text;
        const std::size_t at = copy.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return at == std::string::npos ? copy : copy.replace(at, from.size(), to);
    };
    Log pinched = log;  // its check sum fits, its start does not pass
    pinched.table[0][1] = 3;
    Log foreign = log;
    foreign.flips = {0, 6};
    struct Case {
        std::string what;
        std::string bytes;
        std::string words;
    };
    const std::vector<Case> cases{
        {"another flip", edited("flips 2\n0\n", "flips 2\n1\n"), "log:19: the checksum"},
        {"another sum", text.substr(0, text.size() - 17) + std::string(16, '0') + "\n",
         "log:19: the checksum"},
        {"a short sum", edited("check ", "check 12\n# "), "log:19: "},
        {"another version", edited("log 1", "log 2"), "log:1: "},
        {"no such edge", foreign.text(), "log:18: "},
        {"too few flips", edited("flips 2", "flips 3"), "log:19: "},
        {"too many flips", edited("flips 2", "flips 1"), "log:18: "},
        {"no such number of flips", edited("flips 2", "flips 2000000000"), "log:16: "},
        {"no such number of halfedges", edited("halfedges 12", "halfedges 2000000000"), "log:3: "},
        {"a word", edited("flips 2\n0\n", "flips 2\nx\n"), "log:17: "},
        {"more at the end", text + "0\n", "log:20: "},
        {"a start that is no surface", pinched.text(), "start is no valid surface"},
        {"nothing of the kind", "0 3\n", "no flip log"}};
    for (const auto& [what, bytes, words] : cases) {
        SCOPED_TRACE(what);
        write("log", bytes);
        expect_unusable({"replay", "log", "-o", "end"}, {"log:", words});
        EXPECT_EQ(read("log"), bytes);
    }
    EXPECT_THAT(names(), UnorderedElementsAre("log"));
}

TEST_F(Replay, RefusesEveryChangedByteOfABinaryLog) {
    const std::string bytes = log_from("tetrahedron", {0, 3}).binary();
    for (std::size_t at = 0; at < bytes.size(); at += 5) {
        SCOPED_TRACE(at);
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        write("log", changed);
        expect_unusable({"replay", "log"}, {"log"});
    }
}

TEST_F(Replay, SeveralLogsGiveOneObjectEach) {
    write("good", log_from("tetrahedron", {0}).text());
    write("refused", log_from("book", {0}).text());
    const Outcome outcome = run({"replay", "--json", "missing", "refused", "good"});
    EXPECT_EQ(outcome.exit_code, 2);
    const auto objects = outcome.objects();
    ASSERT_EQ(objects.size(), 3U);
    EXPECT_TRUE(objects[0].contains("error"));
    EXPECT_EQ(objects[1]["verdict"], "violated");
    EXPECT_EQ(objects[2]["verdict"], "holds");
    expect_wrong_usage({"replay", "good", "refused", "-o", "end"}, {"--output"});
}

}  // namespace
}  // namespace tightflip::tools
