/// \file
/// Runs what may crash or hang where it does no harm: in a child process (POSIX).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace tightflip::properties {

/// What a child wrote, and how it ended.
struct ChildResult {
    std::string output;   ///< all that it wrote before it ended
    std::string failure;  ///< empty where the work was done; else why it was not, in words
    bool timed_out = false;
};

/// Writes to the parent; what was written stays written whatever happens to the child.
using ChildOutput = std::function<void(std::string_view)>;

/// Runs `work` in a child. It is a failure unless `work` returns within `seconds`: what it throws,
/// a signal, and even exit(0). Its standard error is dropped. Throws std::system_error where there
/// can be no child.
[[nodiscard]] ChildResult run_in_child(const std::function<void(const ChildOutput&)>& work,
                                       unsigned seconds);

/// The same in this process: only what `work` throws is a failure.
[[nodiscard]] ChildResult run_here(const std::function<void(const ChildOutput&)>& work);

/// What `work` throws, in words; nothing where it returns.
[[nodiscard]] std::optional<std::string> thrown_by(const std::function<void()>& work);

}  // namespace tightflip::properties
