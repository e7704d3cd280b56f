// libFuzzer's door to the target flip_script.

#include "decode.hpp"
#include "flip_script.hpp"

#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tightflip;
    const properties::FlipCase flip_case = fuzz::decode({data, size});
    const kernel::FlipLog log = flip_case.log();
    if (const auto broken = fuzz::first_broken_claim(log)) {
        std::cerr << "\n"
                  << broken->claim << " does not hold: " << describe(broken->finding) << "\n"
                  << describe(flip_case) << "\n";
        properties::write_in_words(std::cerr, log);
        std::abort();
    }
    return 0;
}
