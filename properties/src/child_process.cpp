#include <tightflip/properties/child_process.hpp>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace tightflip::properties {
namespace {

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

/// After the output of a child whose work is over stand this and the failure, if any.
constexpr char end_mark = '\0';

std::string failure_in(const std::function<void(const ChildOutput&)>& work,
                       const ChildOutput& write) {
    const auto thrown = thrown_by([&] { work(write); });
    return thrown ? "threw: " + *thrown : std::string();
}

[[noreturn]] void be_the_child(const std::function<void(const ChildOutput&)>& work,
                               unsigned seconds, int pipe_end) {
    // A sanitizer's handlers would report and exit; here the signal itself is the answer.
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM})
        static_cast<void>(std::signal(signal, SIG_DFL));
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDERR_FILENO);
    alarm(seconds);
    const auto to_parent = [pipe_end](std::string_view text) {
        while (!text.empty()) {
            const ssize_t n = write(pipe_end, text.data(), text.size());
            if (n <= 0) return;
            text.remove_prefix(static_cast<std::size_t>(n));
        }
    };
    to_parent(end_mark + failure_in(work, to_parent));
    _exit(0);  // without the parent's destructors
}

std::string read_all(int pipe_end) {
    std::string output;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 1; n > 0;) {
        n = read(pipe_end, buffer.data(), buffer.size());
        if (n > 0) output.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return output;
}

std::string failure_of(int status, unsigned seconds) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGALRM) return "did not answer within " + std::to_string(seconds) + " s";
        return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
    }
    return "ended its process with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildResult run_in_child(const std::function<void(const ChildOutput&)>& work, unsigned seconds) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe");
    static_cast<void>(std::fflush(nullptr));  // or the child would write it again
    const pid_t child = fork();
    if (child < 0) {
        close(ends[0]);
        close(ends[1]);
        fail("no child process");
    }
    if (child == 0) {
        close(ends[0]);
        be_the_child(work, seconds, ends[1]);
    }
    close(ends[1]);
    ChildResult result{.output = read_all(ends[0]), .failure = {}, .timed_out = false};
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (const auto end = result.output.rfind(end_mark); end != std::string::npos) {
        result.failure = result.output.substr(end + 1);
        result.output.resize(end);
    } else {
        result.failure = failure_of(status, seconds);
        result.timed_out = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    }
    return result;
}

ChildResult run_here(const std::function<void(const ChildOutput&)>& work) {
    ChildResult result;
    result.failure = failure_in(work, [&](std::string_view text) { result.output += text; });
    return result;
}

std::optional<std::string> thrown_by(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "something that is no std::exception";
    }
}

}  // namespace tightflip::properties
