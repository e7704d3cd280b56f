/// \file
/// What every reader of bytes owes its caller: what it read, or a FileError that says where; and no
/// memory beyond what the bytes are worth.
#pragma once

#include "allocation_watch.hpp"
#include "target.hpp"
#include <tightflip/kernel/file_error.hpp>

#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace tightflip::fuzz {

[[nodiscard]] std::string_view as_text(Input input);
[[nodiscard]] InputBytes as_bytes(std::string_view text);

/// What a write function puts on a stream.
template <class Write>
[[nodiscard]] std::string written(Write&& write) {
    std::ostringstream out;
    std::forward<Write>(write)(out);
    return std::move(out).str();
}

/// How refusals of a file as a whole may begin; all others name the line or byte.
using WholeFileReasons = std::span<const std::string_view>;

/// What a refusal lacks; empty where it has a reason and, but for those of a whole file, a place
/// that the bytes have.
[[nodiscard]] std::string objection_to_refusal(const kernel::FileError& error,
                                               std::string_view bytes,
                                               WholeFileReasons whole_file = {});

/// What a reader made of bytes.
template <class T>
struct Attempt {
    std::optional<T> value;
    std::string refusal;    ///< why there is none
    std::string objection;  ///< the reader's fault: a refusal without a place, too much memory
};

/// Calls `read`, a function that returns a T or throws FileError. Another exception is left to the
/// caller, as a finding.
template <class Read>
[[nodiscard]] auto attempt(std::string_view bytes, Read&& read, WholeFileReasons whole_file = {}) {
    Attempt<decltype(read())> result;
    const AllocationWatch watch;
    try {
        result.value = std::forward<Read>(read)();
    } catch (const kernel::FileError& error) {
        result.refusal = error.what();
        result.objection = objection_to_refusal(error, bytes, whole_file);
    }
    if (result.objection.empty()) result.objection = watch.objection(bytes.size());
    return result;
}

/// Text as lines with escapes, anything else as bytes in rows of 16 with their place.
void show_bytes(std::ostream& out, Input input);

}  // namespace tightflip::fuzz
