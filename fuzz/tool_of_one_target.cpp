// tightflip_fuzz on a target of one's own.

#include "fuzzed_target.hpp"
#include "tool.hpp"

int main(int argc, char** argv) {
    return tightflip::fuzz::run_tool({&tightflip::fuzz::fuzzed_target, 1}, argc, argv);
}
