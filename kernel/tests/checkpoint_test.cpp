#include "../src/checkpoint.hpp"

#include "temporary_directory.hpp"
#include <tightflip/kernel/file_io.hpp>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5};
const std::vector<std::uint64_t> words{7, 0, ~std::uint64_t{0}};

class CheckpointTest : public ::testing::Test {
protected:
    CheckpointTest() {
        write_file(file, [](std::ostream& out) {
            CheckpointWriter writer(out, "kind");
            writer.array(bytes);
            writer.array(words);
            writer.array(std::vector<std::uint32_t>{});
            writer.finish();
        });
        content = read_file(file);
    }

    void read_all(const char* kind = "kind") const {
        CheckpointReader reader(file, kind);
        std::vector<std::uint8_t> found_bytes;
        std::vector<std::uint64_t> found_words(words.size());
        std::vector<std::uint32_t> nothing{1};
        reader.array(found_bytes);
        reader.array(std::span(found_words));
        reader.array(nothing);
        reader.finish();
        EXPECT_EQ(found_bytes, bytes);
        EXPECT_EQ(found_words, words);
        EXPECT_TRUE(nothing.empty());
    }
    void replace_content(const std::string& by) const {
        write_file(file, [&](std::ostream& out) { out << by; });
    }

    testing::TemporaryDirectory directory;
    std::filesystem::path file = directory / "state";
    std::string content;
};

TEST_F(CheckpointTest, GivesBackWhatWasWritten) {
    read_all();
}

TEST_F(CheckpointTest, RefusesEveryChangeOfAByte) {
    for (std::size_t i = 0; i < content.size(); ++i) {
        for (const char change : {'\x01', '\x20', '\x80', '\xff'}) {
            std::string damaged = content;
            damaged[i] = static_cast<char>(damaged[i] ^ change);
            replace_content(damaged);
            EXPECT_THROW(read_all(), FileError) << "byte " << i;
        }
    }
}

TEST_F(CheckpointTest, RefusesEveryTruncationAndExtension) {
    for (std::size_t length = 0; length < content.size(); ++length) {
        replace_content(content.substr(0, length));
        EXPECT_THROW(read_all(), FileError) << length << " bytes";
    }
    replace_content(content + '\0');
    EXPECT_THROW(read_all(), FileError);
}

TEST_F(CheckpointTest, RefusesAnotherKindByName) {
    try {
        read_all("other");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(error.reason().find("\"other\""), std::string::npos);
        EXPECT_EQ(error.source(), file.string());
    }
}

TEST_F(CheckpointTest, ChecksTheLengthOfMemoryThatStands) {
    CheckpointReader reader(file, "kind");
    std::vector<std::uint8_t> too_long(bytes.size() + 1);
    EXPECT_THROW(reader.array(std::span(too_long)), FileError);
}

TEST_F(CheckpointTest, ReservesNoMoreThanTheFileCanHold) {
    std::string damaged = content;
    damaged[8 + 4 + 6] = '\x7f';  // the length of the first array: beyond any memory
    replace_content(damaged);
    EXPECT_THROW(read_all(), FileError);
}

}  // namespace
}  // namespace tightflip::kernel
