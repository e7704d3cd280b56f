/// \file
/// Runs what may crash or hang where it does no harm: in a child process (POSIX).
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace tightflip::properties {

/// What a child wrote, and how it ended.
struct ChildResult {
    std::string output;   ///< all that it wrote before it ended
    std::string failure;  ///< empty where it ended well; else the signal or the time, in words
    bool timed_out = false;
};

/// Writes to the parent; what was written stays written whatever happens to the child.
using ChildOutput = std::function<void(std::string_view)>;

/// Runs `work` in a child. A child that is ended by a signal, throws, or does not end within
/// `seconds`, is a failure; its standard error is dropped. Throws std::system_error where there can
/// be no child.
[[nodiscard]] ChildResult run_in_child(const std::function<void(const ChildOutput&)>& work,
                                       unsigned seconds);

}  // namespace tightflip::properties
