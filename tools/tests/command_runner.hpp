/// \file
/// The command as a stranger's script meets it: started as a process in a directory of its own,
/// with what it printed, how it ended and what it left on disk.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tightflip::tools {

using Json = nlohmann::json;

/// How a run of the command ended.
struct Outcome {
    int exit_code = -1;  ///< -1: ended by the signal
    int signal = 0;
    std::string out;
    std::string err;

    /// Standard output read as one JSON object a line; anything else fails the test.
    [[nodiscard]] std::vector<Json> objects() const;
    /// The only object; null and a failed test where there is another number of them.
    [[nodiscard]] Json object() const;
};

/// The circumstances of a run.
struct Circumstances {
    std::string executable = TIGHTFLIP_COMMAND;
    std::string input{};  ///< on standard input; a few thousand bytes at most
    std::optional<rlim_t> most_memory{};
    std::optional<rlim_t> most_bytes_a_file{};  ///< a disk that is full after so many bytes
    std::string output_to{};                    ///< a file to be standard output
    bool nobody_reads = false;                  ///< standard output is a pipe without a reader
};

/// A run under way. One that takes many minutes is ended by SIGALRM.
class Running {
public:
    Running(const std::filesystem::path& directory, std::vector<std::string> arguments,
            const Circumstances& circumstances);
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running();

    void send(int signal) const;
    /// The next line of standard output as soon as it is there; empty where the run ends before.
    [[nodiscard]] std::string line();
    /// Reads both streams to their ends and waits.
    [[nodiscard]] Outcome finish();

private:
    pid_t process_ = -1;
    int out_ = -1;
    int err_ = -1;
};

/// A test with a fresh directory, which is the command's working directory.
class CommandTest : public ::testing::Test {
protected:
    CommandTest();
    ~CommandTest() override;

    Outcome run(std::vector<std::string> arguments, const Circumstances& circumstances = {}) const;
    /// The object of a run with --json, which must exit with `exit_code`.
    Json run_json(std::vector<std::string> arguments, int exit_code = 0) const;
    /// Expects exit code 2, nothing on standard output, and a message with each of the words; then,
    /// again with --json, one object with the keys "file" and "error", or none for wrong usage.
    void expect_unusable(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& words,
                         const Circumstances& circumstances = {}) const;
    void expect_wrong_usage(const std::vector<std::string>& arguments,
                            const std::vector<std::string>& words) const;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const {
        return directory_ / name;
    }
    void write(const std::string& name, const std::string& bytes) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    /// Everything in the directory.
    [[nodiscard]] std::set<std::string> names() const;

private:
    std::filesystem::path directory_;
};

}  // namespace tightflip::tools
