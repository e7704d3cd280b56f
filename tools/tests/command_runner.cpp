#include "command_runner.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace tightflip::tools {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr unsigned most_seconds = 300;

struct Pipe {
    int read_end = -1;
    int write_end = -1;
};

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
    return {ends[0], ends[1]};
}

void close_once(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

void limit(int resource, std::optional<rlim_t> most) {
    if (!most) return;
    const rlimit limits{*most, *most};
    ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

/// What is ready on a pipe, added to `text`; false at its end.
bool take(int descriptor, std::string& text) {
    std::array<char, 1 << 14> block{};
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    return count > 0;
}

}  // namespace

std::vector<Json> Outcome::objects() const {
    std::vector<Json> objects;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        Json json = Json::parse(line, nullptr, false);
        EXPECT_TRUE(json.is_object()) << "this line is no JSON object: " << line;
        objects.push_back(std::move(json));
    }
    EXPECT_TRUE(out.empty() || out.ends_with('\n')) << out;
    return objects;
}

Json Outcome::object() const {
    const std::vector<Json> all = objects();
    EXPECT_EQ(all.size(), 1U) << out << err;
    return all.size() == 1 ? all.front() : Json(nullptr);
}

Running::Running(const fs::path& directory, std::vector<std::string> arguments,
                 const Circumstances& circumstances) {
    std::string executable = circumstances.executable;
    std::vector<char*> pointers{executable.data()};
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    Pipe in = make_pipe();
    Pipe out = make_pipe();
    Pipe err = make_pipe();
    const std::string& input = circumstances.input;  // less than a pipe holds, so nothing waits
    if (::write(in.write_end, input.data(), input.size()) < std::ssize(input)) fail("write");
    close_once(in.write_end);
    if (circumstances.nobody_reads) close_once(out.read_end);
    process_ = ::fork();
    if (process_ < 0) fail("fork");
    if (process_ == 0) {  // from here on only what a signal handler might do
        const int to = circumstances.output_to.empty()
                           ? out.write_end
                           : ::open(circumstances.output_to.c_str(), O_WRONLY);
        const bool ready = ::chdir(directory.c_str()) == 0 && ::dup2(in.read_end, 0) == 0 &&
                           ::dup2(to, 1) == 1 && ::dup2(err.write_end, 2) == 2;
        limit(RLIMIT_AS, circumstances.most_memory);
        limit(RLIMIT_FSIZE, circumstances.most_bytes_a_file);
        ::alarm(most_seconds);
        if (ready) ::execv(executable.c_str(), pointers.data());
        ::_exit(127);
    }
    ::close(in.read_end);
    ::close(out.write_end);
    ::close(err.write_end);
    out_ = out.read_end;
    err_ = err.read_end;
}

Running::~Running() {
    for (int* descriptor : {&out_, &err_})
        close_once(*descriptor);
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
}

void Running::send(int signal) const {
    ::kill(process_, signal);
}

std::string Running::line() {
    std::string line;
    for (char byte = 0; byte != '\n' && ::read(out_, &byte, 1) == 1;)
        line += byte;
    return line;
}

Outcome Running::finish() {
    Outcome outcome;
    while (out_ >= 0 || err_ >= 0) {
        std::array<pollfd, 2> both{{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};
        if (::poll(both.data(), both.size(), -1) < 0) fail("poll");
        if (both[0].revents != 0 && !take(out_, outcome.out)) close_once(out_);
        if (both[1].revents != 0 && !take(err_, outcome.err)) close_once(err_);
    }
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    return outcome;
}

CommandTest::CommandTest() {
    std::string pattern = (fs::temp_directory_path() / "tightflip-command-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail("mkdtemp");
    directory_ = pattern;
}

CommandTest::~CommandTest() {
    std::error_code ignored;
    fs::remove_all(directory_, ignored);
}

Outcome CommandTest::run(std::vector<std::string> arguments,
                         const Circumstances& circumstances) const {
    return Running(directory_, std::move(arguments), circumstances).finish();
}

Json CommandTest::run_json(std::vector<std::string> arguments, int exit_code) const {
    arguments.emplace_back("--json");
    const Outcome outcome = run(std::move(arguments));
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    return outcome.object();
}

void CommandTest::expect_unusable(const std::vector<std::string>& arguments,
                                  const std::vector<std::string>& words,
                                  const Circumstances& circumstances) const {
    const Outcome outcome = run(arguments, circumstances);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("tightflip: ")) << outcome.err;
    for (const std::string& word : words)
        EXPECT_THAT(outcome.err, HasSubstr(word));

    std::vector<std::string> with_json = arguments;
    with_json.emplace_back("--json");
    const Outcome again = run(with_json, circumstances);
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_EQ(again.err, outcome.err);
    const Json json = again.object();
    EXPECT_EQ(json.size(), 2U) << json;
    EXPECT_TRUE(json.contains("file")) << json;
    EXPECT_EQ("tightflip: " + json.value("error", "") + "\n", outcome.err);
}

void CommandTest::expect_wrong_usage(const std::vector<std::string>& arguments,
                                     const std::vector<std::string>& words) const {
    for (const bool as_json : {false, true}) {
        std::vector<std::string> all = arguments;
        if (as_json) all.emplace_back("--json");
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(outcome.err.starts_with("tightflip: ")) << outcome.err;
        for (const std::string& word : words)
            EXPECT_THAT(outcome.err, HasSubstr(word));
    }
}

void CommandTest::write(const std::string& name, const std::string& bytes) const {
    std::ofstream out(path(name), std::ios::binary);
    out << bytes;
    out.close();
    ASSERT_TRUE(out) << name;
}

std::string CommandTest::read(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    EXPECT_TRUE(in) << name << " is not there";
    return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> CommandTest::names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory_)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

}  // namespace tightflip::tools
