// tightflip_fuzz on all targets of ours.

#include "targets.hpp"
#include "tool.hpp"

int main(int argc, char** argv) {
    return tightflip::fuzz::run_tool(tightflip::fuzz::targets(), argc, argv);
}
