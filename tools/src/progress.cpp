#include "progress.hpp"

#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace tightflip::tools {

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)), is_terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (is_terminal_ && shown_at_ >= 0) static_cast<void>(std::fputs("\r\033[K", stderr));
}

void ProgressBar::show(std::uint64_t done, std::uint64_t total, double seconds) {
    constexpr double redraw_seconds = 0.1;
    constexpr int width = 30;
    if (!is_terminal_ || (shown_at_ >= 0 && seconds - shown_at_ < redraw_seconds)) return;
    shown_at_ = seconds;
    const double part = total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
    const int filled = static_cast<int>(part * width);
    const double left = part > 0 ? seconds / part - seconds : 0;
    fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f}%  {:.1f} s left", title_, "", filled,
               "", width - filled, 100 * part, left);
    static_cast<void>(std::fflush(stderr));
}

}  // namespace tightflip::tools
