#include "mutate.hpp"

#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>

namespace tightflip::fuzz {
namespace {

using kernel::RandomStream;

std::size_t below(RandomStream& random, std::size_t bound) {
    return random.below(static_cast<std::uint32_t>(bound));
}

std::uint8_t random_byte(RandomStream& random) {
    return static_cast<std::uint8_t>(random.below(256));
}

/// An input in its parts: a whole head and whole records.
class Parts {
public:
    Parts(const Layout& layout, Input input, std::size_t most_bytes)
        : layout_(layout), most_bytes_(most_bytes), most_records_(most_records()) {
        const std::size_t head = std::min(layout.head, input.size());
        bytes_.assign(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(head));
        bytes_.resize(layout.head);
        append_records(input.subspan(head));
    }

    [[nodiscard]] std::size_t records() const {
        return layout_.record == 0 ? 0 : (bytes_.size() - layout_.head) / layout_.record;
    }
    [[nodiscard]] std::size_t room() const { return most_records_ - records(); }
    [[nodiscard]] std::span<std::uint8_t> head() { return std::span(bytes_).first(layout_.head); }
    [[nodiscard]] std::span<std::uint8_t> tail() { return std::span(bytes_).subspan(layout_.head); }
    [[nodiscard]] std::span<std::uint8_t> run(std::size_t first, std::size_t count) {
        return tail().subspan(first * layout_.record, count * layout_.record);
    }

    /// Puts records, given as bytes, before one of them; those at the end that are too many go.
    void insert(std::size_t before, Input records) {
        const InputBytes copy(records.begin(), records.end());
        bytes_.insert(place(before), copy.begin(), copy.end());
        bytes_.resize(std::min(bytes_.size(), layout_.head + most_records_ * layout_.record));
    }
    void erase(std::size_t first, std::size_t count) {
        bytes_.erase(place(first), place(first + count));
    }
    /// Puts the whole records among the bytes behind the others, as far as there is room.
    void append_records(Input bytes) {
        if (layout_.record == 0) return;
        insert(records(), bytes.first(bytes.size() - bytes.size() % layout_.record));
    }
    [[nodiscard]] InputBytes record(RandomStream& random) const {
        InputBytes record(layout_.record);
        for (std::uint8_t& byte : record)
            byte = random_byte(random);
        return record;
    }

    [[nodiscard]] InputBytes finish() && {
        bytes_.front() = format_version;
        bytes_.resize(std::min(bytes_.size(), most_bytes_));
        return std::move(bytes_);
    }

private:
    [[nodiscard]] std::size_t most_records() const {
        if (layout_.record == 0 || most_bytes_ < layout_.head) return 0;
        return std::min(layout_.most_records, (most_bytes_ - layout_.head) / layout_.record);
    }
    [[nodiscard]] InputBytes::iterator place(std::size_t record) {
        return bytes_.begin() + static_cast<std::ptrdiff_t>(layout_.head + record * layout_.record);
    }

    Layout layout_;
    std::size_t most_bytes_;
    std::size_t most_records_;
    InputBytes bytes_;
};

// ---- mutations: each says whether there was anything that it could do ----

void change(std::uint8_t& byte, RandomStream& random) {
    switch (random.below(4)) {
        case 0:
            ++byte;
            break;
        case 1:
            --byte;
            break;
        default:
            byte = random_byte(random);
    }
}

bool change_head(Parts& parts, RandomStream& random) {
    const auto behind_version = parts.head().subspan(1);
    if (behind_version.empty()) return false;
    change(behind_version[below(random, behind_version.size())], random);
    return true;
}

bool change_record(Parts& parts, RandomStream& random) {
    if (parts.records() == 0) return false;
    change(parts.tail()[below(random, parts.tail().size())], random);
    return true;
}

bool insert_record(Parts& parts, RandomStream& random) {
    if (parts.room() == 0) return false;
    parts.insert(below(random, parts.records() + 1), parts.record(random));
    return true;
}

bool append_several(Parts& parts, RandomStream& random) {
    if (parts.room() == 0) return false;
    for (std::size_t count = 1 + below(random, parts.room()); count > 0; --count)
        parts.append_records(parts.record(random));
    return true;
}

/// A run of records that are there: where it begins, and how many.
struct Run {
    std::size_t first;
    std::size_t count;
};

/// Short runs as often as long ones.
Run any_run(const Parts& parts, RandomStream& random) {
    const std::size_t longest = 1 + below(random, parts.records());
    const std::size_t count = 1 + below(random, longest);
    return {below(random, parts.records() - count + 1), count};
}

bool remove_run(Parts& parts, RandomStream& random) {
    if (parts.records() == 0) return false;
    const auto [first, count] = any_run(parts, random);
    parts.erase(first, count);
    return true;
}

bool duplicate_run(Parts& parts, RandomStream& random) {
    if (parts.records() == 0 || parts.room() == 0) return false;
    const auto [first, count] = any_run(parts, random);
    parts.insert(below(random, parts.records() + 1), parts.run(first, count));
    return true;
}

bool swap_records(Parts& parts, RandomStream& random) {
    if (parts.records() < 2) return false;
    const std::size_t a = below(random, parts.records() - 1);
    const std::size_t b = a + 1 + below(random, parts.records() - a - 1);
    std::ranges::swap_ranges(parts.run(a, 1), parts.run(b, 1));
    return true;
}

constexpr std::array mutations{change_head, change_record, insert_record, append_several,
                               remove_run,  duplicate_run, swap_records};
constexpr std::uint32_t one_in = 8;  ///< inputs that the fuzzer's own mutation changes

InputBytes mutated_bytes(Input input, std::size_t most_bytes, ByteMutator mutate_bytes) {
    InputBytes bytes(input.begin(), input.end());
    const std::size_t size = std::min(bytes.size(), most_bytes);
    bytes.resize(most_bytes);
    bytes.resize(mutate_bytes(bytes.data(), size, most_bytes));
    return bytes;
}

}  // namespace

InputBytes mutate(const Layout& layout, Input input, std::size_t most_bytes, std::uint64_t seed,
                  ByteMutator mutate_bytes) {
    RandomStream random(seed);
    const bool as_bytes = layout.is_text() || random.below(one_in) == 0;
    if (mutate_bytes != nullptr && as_bytes) {
        const InputBytes bytes = mutated_bytes(input, most_bytes, mutate_bytes);
        return layout.is_text() ? bytes : Parts(layout, bytes, most_bytes).finish();
    }
    if (layout.is_text()) return {input.begin(), input.end()};
    Parts parts(layout, input, most_bytes);
    const std::size_t first = below(random, mutations.size());
    for (std::size_t k = 0; k < mutations.size(); ++k) {
        if (mutations[(first + k) % mutations.size()](parts, random)) break;
    }
    return std::move(parts).finish();
}

InputBytes cross_over(const Layout& layout, Input first, Input second, std::size_t most_bytes,
                      std::uint64_t seed) {
    if (layout.is_text()) return {};
    RandomStream random(seed);
    Parts parts(layout, first, most_bytes);
    Parts other(layout, second, most_bytes);
    if (random.below(2) == 0) std::ranges::copy(other.head(), parts.head().begin());
    const std::size_t kept = below(random, parts.records() + 1);
    parts.erase(kept, parts.records() - kept);
    const std::size_t left_out = below(random, other.records() + 1);
    parts.append_records(other.run(left_out, other.records() - left_out));
    return std::move(parts).finish();
}

}  // namespace tightflip::fuzz
