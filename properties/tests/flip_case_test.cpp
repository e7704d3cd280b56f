#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

FlipCase book_case() {
    return {.kind = find_start_kind("book"),
            .request = {.vertices = 4, .genus = 0, .seed = 9},
            .picks = {0, 7, 65535}};
}

TEST(FlipCase, TakesPicksModuloTheEdgesOfTheStart) {
    const kernel::FlipLog log = book_case().log();
    EXPECT_EQ(log.start, kernel::families::book(4));
    EXPECT_EQ(log.flips, (FlipScript{{0}, {1}, {3}}));  // of 6 edges
}

TEST(FlipCase, WithoutAnythingIsATetrahedronAndNoFlips) {
    const kernel::FlipLog log = FlipCase{}.log();
    EXPECT_EQ(log.start, kernel::families::tetrahedron());
    EXPECT_TRUE(log.flips.empty());
}

TEST(FlipCase, IsDescribedOnOneLine) {
    EXPECT_EQ(describe(book_case()), "book, V = 4, genus 0, seed 9, E = 6; flips 0 1 3");
    EXPECT_THAT(describe(FlipCase{}), ::testing::EndsWith("; flips none"));
}

TEST(WriteInWords, TellsWhatEachFlipDoesOrWhyItIsRefused) {
    const Triangulation book = kernel::families::book(4);
    FlipScript script;
    for (Index e = 0; e < book.edge_count(); ++e)
        script.push_back({e});
    std::ostringstream out;
    write_in_words(out, {book, script});
    std::istringstream lines(out.str());
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line, "a surface of genus 0 with 4 vertices and 6 edges");
    Triangulation surface = book;
    for (const Edge e : script) {
        const auto ends = [&] {
            return std::to_string(surface.origin(halfedge_of(e)).id) + "-" +
                   std::to_string(surface.target(halfedge_of(e)).id);
        };
        ASSERT_TRUE(std::getline(lines, line));
        EXPECT_THAT(line,
                    ::testing::HasSubstr("edge " + std::to_string(e.id) + " joins " + ends()));
        const bool done = static_cast<bool>(surface.flip(e));
        EXPECT_THAT(line, ::testing::HasSubstr(done ? ", becomes " + ends() : ", refused: "));
    }
    EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace tightflip::properties
