#include "failures_directory.hpp"
#include "false_claim.hpp"
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/failing_case.hpp>
#include <tightflip/properties/geometry_claims.hpp>

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The same of a surface with points.
std::optional<GeometryFinding> never_three(const geometry::Surface&, std::span<const Edge> script) {
    const auto three = std::ranges::find(script, Edge{3});
    if (three == script.end()) return std::nullopt;
    return GeometryFinding{GeometryClaim::gauss_bonnet,
                           static_cast<std::size_t>(three - script.begin()) + 1, "three"};
}

const FlipScript long_script{{0}, {2}, {3}, {5}, {3}, {4}, {1}, {0}, {1}};

geometry::Surface flat_tetrahedron() {
    return {kernel::families::tetrahedron(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 1, 1e-300}}};
}

TEST(FailingCase, IsNothingWhereTheClaimHolds) {
    const Triangulation start = kernel::families::tetrahedron();
    EXPECT_FALSE(failing_case(never_three_then_one, start, {{1}, {3}}));
    EXPECT_FALSE(failing_case(reference_model_agrees, start, long_script));
}

TEST(FailingCase, HasAShortestScriptAndItsFinding) {
    const Triangulation start = kernel::families::tetrahedron();
    const auto failing = failing_case(never_three_then_one, start, long_script);
    ASSERT_TRUE(failing);
    EXPECT_EQ(failing->log.start, start);
    EXPECT_EQ(failing->log.flips, (FlipScript{{3}, {1}}));
    EXPECT_THAT(failing->finding, StartsWith("after flip 2: "));
    EXPECT_TRUE(failing->points.empty());
    const std::string words = in_words(*failing);
    EXPECT_THAT(words, StartsWith(failing->finding + "\na surface of genus 0 with 4 vertices"));
    EXPECT_THAT(words, HasSubstr("\nflip 1: edge 3 joins "));
    EXPECT_THAT(words, HasSubstr("\nflip 2: edge 1 joins "));
    EXPECT_THAT(words, testing::Not(HasSubstr("vertex 0 at")));
}

TEST(FailingCase, OfASurfaceShowsItsPoints) {
    const auto failing = failing_case(never_three, flat_tetrahedron(), long_script);
    ASSERT_TRUE(failing);
    EXPECT_EQ(failing->log.flips, (FlipScript{{3}}));
    EXPECT_THAT(in_words(*failing), HasSubstr("vertex 3 at 0.10000000000000001 1 1e-300\n"));
}

TEST(WriteFailingCase, WritesWhatReplays) {
    const FailuresDirectory directory("write_failing_case");
    const auto failing = failing_case(never_three, flat_tetrahedron(), long_script);
    const auto path = write_failing_case("My/Suite.Test 1", failing.value());
    EXPECT_EQ(path, directory.path() / "My-Suite.Test-1.flips");
    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    EXPECT_EQ(log.start, kernel::families::tetrahedron());
    EXPECT_EQ(log.flips, (FlipScript{{3}}));
    const auto points = directory.path() / "My-Suite.Test-1.surface";
    const auto read = geometry::parse_surface(kernel::read_file(points), points.string());
    EXPECT_EQ(read.points, failing->points);
}

TEST(WriteFailingCase, WritesNoPointsWhereThereAreNone) {
    const FailuresDirectory directory("write_failing_case_plain");
    write_failing_case("plain", {{kernel::families::tetrahedron(), {{1}}}, "", {}});
    EXPECT_TRUE(std::filesystem::exists(directory.path() / "plain.flips"));
    EXPECT_FALSE(std::filesystem::exists(directory.path() / "plain.surface"));
}

TEST(WriteFailingCase, MakesItsDirectory) {
    const FailuresDirectory directory("write_failing_case_new");
    for (const char* place : {"not/there", "slash/at/the/end/"}) {
        FailuresDirectory::name_instead(directory.path() / place);
        const auto path =
            write_failing_case("new", {{kernel::families::tetrahedron(), {}}, "", {}});
        EXPECT_EQ(path, directory.path() / place / "new.flips");
        EXPECT_TRUE(std::filesystem::exists(path));
    }
}

TEST(WriteFailingCase, WritesHereWhereNoDirectoryIsNamed) {
    const FailuresDirectory directory("write_failing_case_here");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(directory.path());
    FailuresDirectory::name_instead("");
    const auto path = write_failing_case("here", {{kernel::families::tetrahedron(), {}}, "", {}});
    std::filesystem::current_path(before);
    EXPECT_EQ(path, "./here.flips");
    EXPECT_TRUE(std::filesystem::exists(directory.path() / "here.flips"));
}

TEST(WrittenAndInWords, SaysWhyACaseCouldNotBeWrittenBehindItsScript) {
    const FailuresDirectory directory("written_and_in_words");
    const auto failing =
        failing_case(never_three_then_one, kernel::families::tetrahedron(), long_script);
    EXPECT_EQ(written_and_in_words("case", *failing),
              in_words(*failing) + "written to " + (directory.path() / "case.flips").string());

    kernel::write_file(directory.path() / "file", [](std::ostream& out) { out << "no directory"; });
    FailuresDirectory::name_instead(directory.path() / "file" / "inner");
    EXPECT_THROW(write_failing_case("case", *failing), kernel::FileError);
    EXPECT_EQ(written_and_in_words("case", *failing),
              in_words(*failing) + "not written: " + (directory.path() / "file/inner").string() +
                  ": cannot be made: Not a directory");

    FailuresDirectory::name_instead(directory.path());
    std::filesystem::create_directory(directory.path() / "taken.flips");
    EXPECT_THAT(written_and_in_words("taken", *failing),
                testing::EndsWith("is a directory; name a file"));
}

}  // namespace
}  // namespace tightflip::properties
