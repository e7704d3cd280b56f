#include "refusals.hpp"
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::refusal_of;
using ::testing::StartsWith;

// ---- FileError ----

TEST(FileError, ReadsAsSourcePlaceReason) {
    const FileError in_line("a.off", FileError::Unit::line, 12, "no number");
    EXPECT_STREQ(in_line.what(), "a.off:12: no number");
    EXPECT_EQ(in_line.unit(), FileError::Unit::line);
    EXPECT_EQ(in_line.position(), 12U);
    EXPECT_EQ(in_line.source(), "a.off");
    EXPECT_EQ(in_line.reason(), "no number");

    EXPECT_STREQ(FileError("a.bin", FileError::Unit::byte, 5000000000U, "cut short").what(),
                 "a.bin: byte 5000000000: cut short");

    const FileError whole("a.off", "is gone");
    EXPECT_STREQ(whole.what(), "a.off: is gone");
    EXPECT_EQ(whole.unit(), FileError::Unit::none);
}

// ---- files ----

/// Each test has a directory of its own.
class FileIo : public ::testing::Test {
protected:
    FileIo() {
        std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::ranges::replace(test, '/', '-');  // before the number of a parameter
        directory_ = fs::temp_directory_path() /
                     ("tightflip-file-io-" + std::to_string(::getpid()) + "-" + test);
        fs::remove_all(directory_);
        fs::create_directories(directory_);
    }
    ~FileIo() override {
        std::error_code ignored;
        fs::permissions(directory_, fs::perms::owner_all, ignored);
        fs::remove_all(directory_, ignored);
    }

    [[nodiscard]] fs::path in_directory(const std::string& name) const { return directory_ / name; }
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(directory_)) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }
    /// Makes a file without the code under test.
    fs::path make(const std::string& name, const std::string& content) {
        std::ofstream(in_directory(name), std::ios::binary) << content;
        return in_directory(name);
    }

private:
    fs::path directory_;
};

void expect_refused(const std::optional<FileError>& refusal, const fs::path& path,
                    const std::string& word) {
    ASSERT_TRUE(refusal.has_value()) << path;
    EXPECT_EQ(refusal->source(), path.string());
    EXPECT_THAT(refusal->what(), StartsWith(path.string() + ": "));
    EXPECT_THAT(refusal->reason(), HasSubstr(word));
}

/// Writes the bytes given.
auto writer(std::string bytes) {
    return [bytes = std::move(bytes)](std::ostream& out) { out << bytes; };
}

/// For its lifetime the effective user is one without privileges, where the process can do that.
class WithoutPrivileges {
public:
    WithoutPrivileges() : before_(::geteuid()) {
        if (before_ == 0) static_cast<void>(::seteuid(65534));
    }
    WithoutPrivileges(const WithoutPrivileges&) = delete;
    WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;
    ~WithoutPrivileges() { static_cast<void>(::seteuid(before_)); }
    [[nodiscard]] static bool succeeded() { return ::geteuid() != 0; }

private:
    ::uid_t before_;
};

/// For its lifetime no file can grow beyond so many bytes, as on a disk that is full.
class FileSizeLimit {
public:
    explicit FileSizeLimit(::rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const ::rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    void (*handler_)(int);
    ::rlimit before_{};
};

TEST_F(FileIo, RoundTripKeepsEveryByte) {
    std::string bytes;
    for (int i = 0; i < 256 * 1024; ++i)
        bytes += static_cast<char>((i * 7 + i / 256) % 256);
    const fs::path path = in_directory("all bytes.bin");
    for (const std::string& content : {bytes, std::string(), std::string("\r\n\n\0\n", 5)}) {
        write_file(path, writer(content));
        EXPECT_EQ(fs::file_size(path), content.size());
        EXPECT_TRUE(read_file(path) == content) << content.size() << " bytes";
    }
    EXPECT_THAT(names(), ElementsAre("all bytes.bin"));
}

TEST_F(FileIo, WriteReplacesLongerContent) {
    const fs::path path = make("file", std::string(10000, 'x'));
    write_file(path, writer("short"));
    EXPECT_EQ(read_file(path), "short");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(FileIo, WritesUnderARelativeName) {
    const fs::path before = fs::current_path();
    fs::current_path(in_directory("."));
    write_file("bare name", writer("content"));
    const std::string content = read_file("bare name");
    fs::current_path(before);
    EXPECT_EQ(content, "content");
    EXPECT_THAT(names(), ElementsAre("bare name"));
}

TEST_F(FileIo, TheOldFileStandsUntilTheNewOneIsWhole) {
    const fs::path path = make("file", "old");
    write_file(path, [&](std::ostream& out) {
        out << "new" << std::flush;
        EXPECT_EQ(read_file(path), "old");
    });
    EXPECT_EQ(read_file(path), "new");
}

TEST_F(FileIo, ReadRefusesAMissingFile) {
    const fs::path path = in_directory("missing");
    expect_refused(refusal_of([&] { return read_file(path); }), path, "No such file");
    const fs::path below = in_directory("no such directory/file");
    expect_refused(refusal_of([&] { return read_file(below); }), below, "No such file");
}

TEST_F(FileIo, ReadRefusesADirectory) {
    const fs::path path = in_directory("");
    expect_refused(refusal_of([&] { return read_file(path); }), path, "directory");
}

TEST_F(FileIo, ReadRefusesAFileThatBreaksOffWithAnError) {
    const fs::path path = "/proc/self/mem";  // opens, but nothing lies at address 0
    if (!fs::exists(path)) GTEST_SKIP() << "needs " << path;
    expect_refused(refusal_of([&] { return read_file(path); }), path, "cannot be read: Input");
}

TEST_F(FileIo, ReadRefusesAnUnreadableFile) {
    const fs::path path = make("secret", "content");
    fs::permissions(path, fs::perms::none);
    const WithoutPrivileges guard;
    if (!WithoutPrivileges::succeeded()) GTEST_SKIP() << "cannot give up the rights of root";
    expect_refused(refusal_of([&] { return read_file(path); }), path, "Permission denied");
}

TEST_F(FileIo, WriteRefusesADirectoryWithoutPermission) {
    const fs::path path = make("file", "old");
    fs::permissions(in_directory(""), fs::perms::owner_read | fs::perms::owner_exec |
                                          fs::perms::others_read | fs::perms::others_exec);
    {
        const WithoutPrivileges guard;
        if (!WithoutPrivileges::succeeded()) GTEST_SKIP() << "cannot give up the rights of root";
        expect_refused(refusal_of([&] { write_file(path, writer("new")); }), path,
                       "Permission denied");
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(FileIo, WriteRefusesAMissingDirectory) {
    const fs::path path = in_directory("missing/file");
    bool asked = false;
    expect_refused(refusal_of([&] { write_file(path, [&](std::ostream&) { asked = true; }); }),
                   path, "No such file");
    EXPECT_FALSE(asked) << "nothing need be made that cannot be stored";
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(FileIo, WriteRefusesToReplaceADirectory) {
    const fs::path path = in_directory("directory");
    fs::create_directory(path);
    expect_refused(refusal_of([&] { write_file(path, writer("new")); }), path, "irectory");
    EXPECT_TRUE(fs::is_directory(path));
    EXPECT_THAT(names(), ElementsAre("directory"));
}

TEST_F(FileIo, AnExceptionOfTheWriterPassesThroughAndLeavesNothing) {
    const fs::path path = make("file", "old");
    const auto write = [](std::ostream& out) {
        out << std::string(100000, 'x');
        throw std::logic_error("changed my mind");
    };
    for (const fs::path& target : {path, in_directory("another")}) {
        try {
            write_file(target, write);
            FAIL() << "the exception was lost";
        } catch (const std::logic_error& error) {
            EXPECT_STREQ(error.what(), "changed my mind");
        }
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(FileIo, AStreamThatTheWriterGaveUpIsAFailure) {
    const fs::path path = make("file", "old");
    EXPECT_TRUE(refusal_of(
        [&] { write_file(path, [](std::ostream& out) { out.setstate(std::ios::failbit); }); }));
    EXPECT_EQ(read_file(path), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(FileIo, ASymbolicLinkStaysOne) {
    const fs::path file = make("file", "old");
    fs::create_symlink("file", in_directory("link"));
    write_file(in_directory("link"), writer("new"));
    EXPECT_TRUE(fs::is_symlink(in_directory("link")));
    EXPECT_EQ(read_file(file), "new");
    EXPECT_THAT(names(), ElementsAre("file", "link"));
}

TEST_F(FileIo, APipeIsWrittenStraight) {
    const fs::path path = in_directory("pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    write_file(path, writer("content"));
    std::string content(100, ' ');
    const auto size = ::read(reader, content.data(), content.size());
    ::close(reader);
    EXPECT_EQ(content.substr(0, static_cast<std::size_t>(std::max<::ssize_t>(size, 0))), "content");
    EXPECT_EQ(fs::status(path).type(), fs::file_type::fifo);
    EXPECT_THAT(names(), ElementsAre("pipe"));
}

/// Without privileges, so that code that replaces devices cannot replace this one.
TEST_F(FileIo, AFullDeviceIsReported) {
    if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "needs /dev/full";
    const fs::path path = in_directory("full");
    fs::create_symlink("/dev/full", path);
    const WithoutPrivileges guard;
    if (!WithoutPrivileges::succeeded()) GTEST_SKIP() << "cannot give up the rights of root";
    expect_refused(refusal_of([&] { write_file(path, writer("content")); }), path, "No space left");
    EXPECT_THAT(names(), ElementsAre("full"));
}

/// Whether the disk fills up while `write` runs or only when the last buffer is written.
class FileIoFullDisk : public FileIo, public ::testing::WithParamInterface<std::size_t> {};

TEST_P(FileIoFullDisk, LeavesTheOldFileAndNothingElse) {
    const fs::path path = make("file", "old");
    std::optional<FileError> refusal;
    {
        const FileSizeLimit limit(100);
        refusal = refusal_of([&] { write_file(path, writer(std::string(GetParam(), 'x'))); });
    }
    expect_refused(refusal, path, "writing failed");
    EXPECT_EQ(read_file(path), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, FileIoFullDisk, ::testing::Values(101U, 1000U, 1000000U));

}  // namespace
}  // namespace tightflip::kernel
