/// \file
/// What a fuzz target is: a judge of inputs, what its inputs look like, and a few of them to begin
/// with. Fuzzers, the replayer and the minimiser know no more than this.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tightflip::fuzz {

using Input = std::span<const std::uint8_t>;
using InputBytes = std::vector<std::uint8_t>;

/// The first byte of every input with a head. It changes when bytes change their meaning; what
/// begins otherwise is not tested.
inline constexpr std::uint8_t format_version = 1;

/// How inputs are built: a head of fixed size, the version first, then at most so many records of
/// equal size. Without a head an input is free text.
struct Layout {
    std::size_t head = 0;
    std::size_t record = 0;
    std::size_t most_records = 0;

    [[nodiscard]] constexpr bool is_text() const noexcept { return head == 0; }
    /// The size of the longest input; what follows is ignored. Not of text.
    [[nodiscard]] constexpr std::size_t most_bytes() const noexcept {
        return head + record * most_records;
    }
};

/// An input to begin with. The name says what it shows, and is a file name.
struct Seed {
    std::string name;
    InputBytes bytes;
};

struct Target {
    std::string_view name;
    std::string_view description;  ///< one line: what an input is, and what must hold of it
    Layout layout;
    /// What does not hold of an input, empty where everything does. It begins with the claim's
    /// name; a colon and the details follow. Takes any bytes; missing ones count as 0.
    std::string (*objection)(Input input);
    /// The input in words, in lines; also where what is tested is broken.
    void (*show)(std::ostream& out, Input input);
    /// The same ones each time, under different names.
    std::vector<Seed> (*seeds)();
};

/// Whether the input is text, or of the version that this program knows.
[[nodiscard]] bool is_of_this_version(const Layout& layout, Input input);

/// What the target objects to, an exception included: "exception: ...".
[[nodiscard]] std::string objection(const Target& target, Input input);

/// The claim that an objection names: what stands before its first colon.
[[nodiscard]] std::string_view claim_of(std::string_view objection);

}  // namespace tightflip::fuzz
