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
    int code = 0;
    try {
        work([pipe_end](std::string_view text) {
            while (!text.empty()) {
                const ssize_t n = write(pipe_end, text.data(), text.size());
                if (n <= 0) return;
                text.remove_prefix(static_cast<std::size_t>(n));
            }
        });
    } catch (...) {
        code = 1;
    }
    _exit(code);  // without the parent's destructors
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
    const int code = WEXITSTATUS(status);
    return code == 0 ? std::string() : "ended with exit code " + std::to_string(code);
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
    result.failure = failure_of(status, seconds);
    result.timed_out = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    return result;
}

}  // namespace tightflip::properties
