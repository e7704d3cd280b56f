#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace tightflip::tools {
namespace {

std::atomic<bool> interrupted = false;  // lock-free, so a signal handler may set it

}  // namespace

void note_interrupts() {
    for (const int signal : {SIGINT, SIGTERM}) {
        static_cast<void>(std::signal(signal, [](int) { interrupted = true; }));
    }
}

bool was_interrupted() {
    return interrupted;
}

}  // namespace tightflip::tools
