// A target for a fuzzer: libFuzzer, or another engine with the same entry points.

#include "fuzzed_target.hpp"
#include "mutate.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

using namespace tightflip::fuzz;  // NOLINT(google-build-using-namespace)

namespace {
std::size_t put(const InputBytes& input, std::uint8_t* data) {
    std::ranges::copy(input, data);
    return input.size();
}
}  // namespace

/// libFuzzer's own mutation; other engines have none.
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                      std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Input input(data, size);
    if (!is_of_this_version(fuzzed_target.layout, input)) return -1;  // not to be kept
    if (const std::string objected = objection(fuzzed_target, input); !objected.empty()) {
        std::cerr << "\n" << objected << "\n";
        fuzzed_target.show(std::cerr, input);
        std::abort();
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    return put(mutate(fuzzed_target.layout, {data, size}, most, seed, LLVMFuzzerMutate), data);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second,
                                                 std::size_t second_size, std::uint8_t* out,
                                                 std::size_t most, unsigned seed) {
    return put(
        cross_over(fuzzed_target.layout, {first, first_size}, {second, second_size}, most, seed),
        out);
}
