#include "replay.hpp"

#include <tightflip/kernel/file_error.hpp>

#include <fstream>
#include <ostream>
#include <sstream>
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

const Target odd_target{
    .name = "odd",
    .description = "objects to an odd second byte",
    .layout = {.head = 2, .record = 0, .most_records = 0},
    .objection = [](Input input) -> std::string {
        return input.size() > 1 && input[1] % 2 == 1 ? "even: it is odd" : "";
    },
    .show = [](std::ostream& out, Input input) { out << input.size() << " bytes\n"; },
    .seeds =
        [] {
            return std::vector<Seed>{{"two", {1, 2}}, {"three", {1, 3}}};
        }};

class Replay : public ::testing::Test {
protected:
    Replay() {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "inner");
    }
    ~Replay() override { fs::remove_all(folder_); }
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    void write(const std::string& name, Input input) { write_input(folder_ / name, input); }

    fs::path folder_ = fs::path(::testing::TempDir()) /
                       ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ostringstream out_;
    std::ostringstream errors_;
    Replayer replayer_{odd_target, out_, errors_};
};

TEST_F(Replay, FindsWhatBreaksAClaimInADirectoryAndThoseInIt) {
    write("a", InputBytes{1, 4});
    write("b", InputBytes{1, 5});
    write("inner/c", InputBytes{1, 7});
    replayer_.replay_path(folder_);
    EXPECT_EQ(replayer_.summary().inputs, 3U);
    EXPECT_EQ(replayer_.summary().broken, 2U);
    EXPECT_EQ(replayer_.summary().skipped, 0U);
    EXPECT_THAT(out_.str(), HasSubstr("b: 2 bytes\n"));
    EXPECT_THAT(out_.str(), HasSubstr("c: even: it is odd\n"));
    EXPECT_THAT(out_.str(), Not(HasSubstr("a: ")));
    EXPECT_EQ(describe(replayer_.summary()), "3 inputs, 2 break a claim");
}

TEST_F(Replay, SkipsAndNamesWhatItCannotRead) {
    write("empty", {});
    write("good", InputBytes{1, 2});
    write("other_version", InputBytes{2, 3});
    fs::create_symlink("nowhere", folder_ / "dangling");
    replayer_.replay_path(folder_);
    EXPECT_EQ(replayer_.summary().inputs, 1U);
    EXPECT_EQ(replayer_.summary().broken, 0U);
    EXPECT_EQ(replayer_.summary().skipped, 3U);
    EXPECT_THAT(errors_.str(), HasSubstr("empty: of another version than 1"));
    EXPECT_THAT(errors_.str(), HasSubstr("other_version: of another version than 1"));
    EXPECT_THAT(errors_.str(), HasSubstr("dangling: "));
    EXPECT_THAT(errors_.str(), Not(HasSubstr("good")));
    EXPECT_EQ(describe(replayer_.summary()), "1 inputs, every claim held, 3 files skipped");
}

TEST_F(Replay, SkipsAndNamesWhatIsNoRegularFile) {
    write("inner/good", InputBytes{1, 2});
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_directory_symlink("inner", folder_ / "linked");
    fs::create_symlink("inner/good", folder_ / "linked_file");
    replayer_.replay_path(folder_);
    EXPECT_EQ(replayer_.summary().inputs, 2U);
    EXPECT_EQ(replayer_.summary().skipped, 2U);
    EXPECT_THAT(errors_.str(), HasSubstr("pipe: is no regular file"));
    EXPECT_THAT(errors_.str(), HasSubstr("linked: is no regular file"));
    replayer_.replay_path(folder_ / "pipe");
    EXPECT_EQ(replayer_.summary().skipped, 3U);
}

TEST_F(Replay, SkipsAPathThatIsNot) {
    replayer_.replay_path(folder_ / "missing");
    EXPECT_EQ(replayer_.summary().inputs, 0U);
    EXPECT_EQ(replayer_.summary().skipped, 1U);
}

TEST_F(Replay, RunsSeedsByName) {
    replayer_.replay_seeds();
    EXPECT_EQ(replayer_.summary().inputs, 2U);
    EXPECT_EQ(replayer_.summary().broken, 1U);
    EXPECT_THAT(out_.str(), HasSubstr("seed three: even: it is odd"));
}

TEST_F(Replay, ShowsEveryInputWhereAskedTo) {
    Replayer verbose(odd_target, out_, errors_, true);
    verbose.replay_seeds();
    EXPECT_THAT(out_.str(), HasSubstr("seed two: 2 bytes"));
}

TEST_F(Replay, ReadsBackWhatItWrites) {
    const InputBytes input{0, 1, 10, 13, 255};
    write("bytes", input);
    EXPECT_EQ(read_input(folder_ / "bytes"), input);
    EXPECT_THROW(static_cast<void>(read_input(folder_ / "missing")), kernel::FileError);
}

}  // namespace
}  // namespace tightflip::fuzz
