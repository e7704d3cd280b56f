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

void ProgressBar::show(const State& state) {
    constexpr double redraw_seconds = 0.1;
    constexpr int width = 30;
    const double seconds = state.seconds;
    if (!is_terminal_ || (shown_at_ >= 0 && seconds - shown_at_ < redraw_seconds)) return;
    shown_at_ = seconds;
    const auto now_done = static_cast<double>(state.done - state.done_before);
    const double rate = seconds > 0 ? now_done / seconds : 0;
    std::string text = fmt::format("\r\033[K{} ", title_);
    if (state.total > 0) {
        const double part = static_cast<double>(state.done) / static_cast<double>(state.total);
        const int filled = static_cast<int>(part * width);
        text +=
            fmt::format("[{:#<{}}{:.<{}}] {:3.0f}%  ", "", filled, "", width - filled, 100 * part);
        if (rate > 0) {
            text += fmt::format("{:.1f} s left  ",
                                static_cast<double>(state.total - state.done) / rate);
        }
    }
    text += fmt::format("{} done, {:.3g} a second  {}", state.done, rate, state.note);
    static_cast<void>(std::fputs(text.c_str(), stderr));
    static_cast<void>(std::fflush(stderr));
}

}  // namespace tightflip::tools
