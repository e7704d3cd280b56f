/// \file
/// Looking at what a reader or writer of files refuses: what it threw, where and why.
#pragma once

#include <tightflip/kernel/file_error.hpp>

#include <cstdint>
#include <optional>
#include <string>

#include <gmock/gmock.h>

namespace tightflip::kernel::testing {

/// The FileError that `action` ended with; empty where it returned. Anything else passes through.
template <class Action>
[[nodiscard]] std::optional<FileError> refusal_of(Action&& action) {
    try {
        static_cast<void>(action());
    } catch (const FileError& error) {
        return error;
    }
    return std::nullopt;
}

/// Expects a refusal in this line, with `word` in the reason.
inline void expect_refused_in_line(const std::optional<FileError>& refusal, std::uint64_t line,
                                   const std::string& word) {
    ASSERT_TRUE(refusal.has_value()) << "was not refused";
    EXPECT_EQ(refusal->unit(), FileError::Unit::line) << refusal->what();
    EXPECT_EQ(refusal->position(), line) << refusal->what();
    EXPECT_THAT(refusal->reason(), ::testing::HasSubstr(word));
}

}  // namespace tightflip::kernel::testing
