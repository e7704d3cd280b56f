#include "minimise.hpp"

#include <tightflip/properties/child_process.hpp>
#include <tightflip/properties/shrink.hpp>

#include <algorithm>
#include <functional>

namespace tightflip::fuzz {
namespace {

using Fails = std::function<bool(Input)>;

InputBytes joined(const std::vector<InputBytes>& pieces) {
    InputBytes bytes;
    for (const InputBytes& piece : pieces)
        bytes.insert(bytes.end(), piece.begin(), piece.end());
    return bytes;
}

/// The input in pieces of equal size; the last is filled up with what missing bytes count as.
std::vector<InputBytes> records_of(Input bytes, std::size_t size) {
    std::vector<InputBytes> records;
    for (; size > 0 && !bytes.empty(); bytes = bytes.subspan(std::min(size, bytes.size()))) {
        const Input record = bytes.first(std::min(size, bytes.size()));
        records.emplace_back(record.begin(), record.end()).resize(size);
    }
    return records;
}

/// The text in lines, each with its end.
std::vector<InputBytes> lines_of(Input text) {
    std::vector<InputBytes> lines;
    while (!text.empty()) {
        const auto end = std::find(text.begin(), text.end(), '\n');
        const auto size =
            static_cast<std::size_t>(end - text.begin()) + (end != text.end() ? 1 : 0);
        lines.emplace_back(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
        text = text.subspan(size);
    }
    return lines;
}

/// Leaves out what can be left out of the pieces behind the first so many bytes. The pieces'
/// numbers are shrunk as if they were edges of a script.
InputBytes with_fewer(Input head, const std::vector<InputBytes>& pieces, const Fails& fails) {
    const auto of = [&](std::span<const kernel::Edge> numbers) {
        std::vector<InputBytes> kept{InputBytes(head.begin(), head.end())};
        for (const kernel::Edge number : numbers)
            kept.push_back(pieces[static_cast<std::size_t>(number.id)]);
        return joined(kept);
    };
    properties::FlipScript all(pieces.size());
    for (kernel::Index k = 0; kernel::Edge & number : all)
        number = {k++};
    return of(properties::shrink(
        all, [&](std::span<const kernel::Edge> numbers) { return fails(of(numbers)); }));
}

/// The least value of a byte with which the input still fails.
void make_smaller(InputBytes& input, std::size_t place, const Fails& fails) {
    const std::uint8_t value = input[place];
    for (std::uint8_t smaller = 0; smaller < value; ++smaller) {
        input[place] = smaller;
        if (fails(input)) return;
    }
    input[place] = value;
}

/// The same of two bytes, the low one first: one byte where that will do. A number that counts
/// modulo a small one has a small name, which no change of one byte may lead to.
void make_one_byte(InputBytes& input, std::size_t low, const Fails& fails) {
    const InputBytes before = input;
    if (input[low + 1] == 0) return;
    input[low + 1] = 0;
    for (unsigned value = 0; value < 256; ++value) {
        input[low] = static_cast<std::uint8_t>(value);
        if (fails(input)) return;
    }
    input = before;
}

InputBytes minimised_records(const Layout& layout, InputBytes input, const Fails& fails) {
    input.resize(std::max(input.size(), layout.head));
    input.resize(std::min(input.size(), layout.most_bytes()));
    while (true) {
        const InputBytes before = input;
        const Input head = Input(before).first(layout.head);
        const auto records = records_of(Input(before).subspan(layout.head), layout.record);
        input = with_fewer(head, records, fails);
        for (std::size_t place = 1; place < input.size(); ++place)
            make_smaller(input, place, fails);
        for (std::size_t place = 1; place + 1 < input.size(); ++place)
            make_one_byte(input, place, fails);
        if (input == before) return input;
    }
}

InputBytes minimised_text(const InputBytes& input, const Fails& fails) {
    const InputBytes fewer_lines = with_fewer({}, lines_of(input), fails);
    return with_fewer({}, records_of(fewer_lines, 1), fails);
}

}  // namespace

std::string guarded_objection(const Target& target, Input input, unsigned seconds) {
    const properties::ChildResult result = properties::run_in_child(
        [&](const properties::ChildOutput& write) { write(objection(target, input)); }, seconds);
    if (result.failure.empty()) return result.output;
    return (result.timed_out ? "time: " : "crash: ") + result.failure;
}

InputBytes minimise(const Target& target, Input input) {
    const std::string objected = guarded_objection(target, input);
    if (objected.empty()) return {input.begin(), input.end()};
    const InputBytes bytes(input.begin(), input.end());
    const std::string_view claim = claim_of(objected);
    const auto minimised = [&](const Fails& fails) {
        return target.layout.is_text() ? minimised_text(bytes, fails)
                                       : minimised_records(target.layout, bytes, fails);
    };
    // One child for all candidates is much faster; where one of them ends it, each has its own.
    constexpr unsigned seconds = 600;
    const properties::ChildResult at_once = properties::run_in_child(
        [&](const properties::ChildOutput& write) {
            if (claim == "time") return;  // it would be waited for again
            const InputBytes smallest = minimised(
                [&](Input candidate) { return claim_of(objection(target, candidate)) == claim; });
            write(std::string(smallest.begin(), smallest.end()));
        },
        seconds);
    if (at_once.failure.empty() && !at_once.output.empty()) {
        return {at_once.output.begin(), at_once.output.end()};
    }
    return minimised(
        [&](Input candidate) { return claim_of(guarded_objection(target, candidate)) == claim; });
}

}  // namespace tightflip::fuzz
