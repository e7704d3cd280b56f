// libFuzzer's door to a target.

#include "target.hpp"

#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tightflip;
    if (const std::string objected = fuzz::objection({data, size}); !objected.empty()) {
        std::cerr << "\n" << objected << "\n";
        fuzz::show(std::cerr, {data, size});
        std::abort();
    }
    return 0;
}
