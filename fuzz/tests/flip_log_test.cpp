#include "targets/flip_log.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_log.hpp>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::Edge;
using kernel::FlipLog;

const FlipLog& sample() {
    static const FlipLog log{kernel::families::book(200), {{0}, {130}, {3}, {593}, {130}}};
    return log;
}
std::string text() {
    return written([](std::ostream& out) { write_text(out, sample()); });
}
std::string binary() {
    return written([](std::ostream& out) { write_binary(out, sample()); });
}

TEST(RightChecksum, IsThatOfTheContentInBothForms) {
    EXPECT_EQ(with_right_checksum(text()), text());
    EXPECT_EQ(with_right_checksum(binary()), binary());
    std::string damaged = text();
    damaged.replace(damaged.find("check ") + 6, 4, "0000");
    EXPECT_EQ(with_right_checksum(damaged), text());
    damaged = binary();
    damaged.back() = static_cast<char>(damaged.back() + 1);
    EXPECT_EQ(with_right_checksum(damaged), binary());
}

TEST(RightChecksum, MakesChangedLogsReadable) {
    std::string changed = text();
    changed.replace(changed.find("\n593\n"), 5, "\n592\n# c\n");
    EXPECT_THROW(static_cast<void>(kernel::parse_flip_log(changed, "log")), kernel::FileError);
    const FlipLog log = kernel::parse_flip_log(with_right_checksum(changed), "log");
    EXPECT_EQ(log.flips[3], Edge{592});
}

TEST(RightChecksum, LeavesAloneWhatIsNoLog) {
    for (const std::string& bytes :
         {std::string(), std::string("check "), text().substr(0, text().size() - 9),
          std::string("check 0123456789abcdef\n"), binary().substr(0, 25),
          binary().replace(16, 4, "\xff\xff\xff\xff")})
        EXPECT_EQ(with_right_checksum(bytes), bytes);
}

TEST(FlipLogSeeds, AreReadRefusedAndFollowedInPart) {
    int complete = 0;
    int stopped = 0;
    int refused = 0;
    for (const Seed& seed : flip_log_target.seeds()) {
        try {
            const auto followed = replay(kernel::parse_flip_log(as_text(seed.bytes), "log"));
            ++(followed.is_complete() ? complete : stopped);
        } catch (const kernel::FileError&) {
            ++refused;
        }
    }
    EXPECT_GE(complete, 80);
    EXPECT_GE(stopped, 2);
    EXPECT_GE(refused, 20);
}

TEST(FlipLogTarget, HoldsForLogsCutAnywhere) {
    const FlipLog log{kernel::families::tetrahedron(), {{0}, {3}}};
    for (const std::string& bytes : {written([&](std::ostream& out) { write_text(out, log); }),
                                     written([&](std::ostream& out) { write_binary(out, log); })}) {
        for (std::size_t size = 0; size <= bytes.size(); ++size)
            EXPECT_EQ(flip_log_objection(bytes.substr(0, size)), "") << size;
    }
}

}  // namespace
}  // namespace tightflip::fuzz
