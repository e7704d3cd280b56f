#include "failures_directory.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/googletest.hpp>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using testing::HasSubstr;

/// A claim that does not hold: no script flips edge 2.
std::optional<Finding> never_two(const Triangulation&, std::span<const Edge> script) {
    const auto two = std::ranges::find(script, Edge{2});
    if (two == script.end()) return std::nullopt;
    return Finding{static_cast<std::size_t>(two - script.begin()) + 1,
                   {.code = ViolationCode::flip_law_broken}};
}

const FlipScript script{{0}, {1}, {2}, {3}, {2}};

TEST(ExpectHolds, SaysNothingWhereTheClaimHolds) {
    const FailuresDirectory directory("expect_holds");
    EXPECT_HOLDS(reference_model_agrees, kernel::families::tetrahedron(), script);
    ASSERT_HOLDS(flip_laws_hold, kernel::families::book(5), script) << "not said";
    EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(ExpectHolds, ShowsTheShortestScriptInWordsAndWritesItsLog) {
    const FailuresDirectory directory("expect_holds_not");
    const Triangulation start = kernel::families::tetrahedron();
    const auto result = holds("never_two", never_two, start, script);
    ASSERT_FALSE(result);
    const std::string message = result.message();
    EXPECT_THAT(message, HasSubstr("never_two does not hold after flip 1: "));
    EXPECT_THAT(message, HasSubstr("\nflip 1: edge 2 joins "));
    EXPECT_THAT(message, testing::Not(HasSubstr("\nflip 2")));
    const auto path =
        directory.path() / "ExpectHolds.ShowsTheShortestScriptInWordsAndWritesItsLog-1.flips";
    EXPECT_THAT(message, HasSubstr("written to " + path.string()));
    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    EXPECT_EQ(log.start, start);
    EXPECT_EQ(log.flips, (FlipScript{{2}}));
    static_cast<void>(holds("never_two", never_two, start, script));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 2);
}

TEST(ExpectHolds, ShowsTheScriptAlsoWhereItCannotBeWritten) {
    const FailuresDirectory directory("expect_holds_unwritten");
    kernel::write_file(directory.path() / "file", [](std::ostream& out) { out << "no directory"; });
    FailuresDirectory::name_instead(directory.path() / "file");
    const auto result = holds("never_two", never_two, kernel::families::tetrahedron(), script);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("\nflip 1: edge 2 joins "));
    EXPECT_THAT(result.message(), HasSubstr("\nnot written: " + directory.path().string()));
}

void failing_assertion() {
    ASSERT_HOLDS(never_two, kernel::families::tetrahedron(), script) << "more";
    throw std::logic_error("not reached");
}

TEST(ExpectHolds, FailsItsTestAndSaysMore) {
    const FailuresDirectory directory("expect_holds_fails");
    EXPECT_NONFATAL_FAILURE(
        EXPECT_HOLDS(never_two, kernel::families::tetrahedron(), script) << "and more", "and more");
    EXPECT_FATAL_FAILURE(failing_assertion(), "never_two does not hold");
}

}  // namespace
}  // namespace tightflip::properties
