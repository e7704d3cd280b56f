#include "flip_script.hpp"
#include "targets.hpp"
#include <tightflip/properties/claims.hpp>

namespace tightflip::fuzz {

const Target script_log_target{
    .name = "script_log",
    .description = "a start and a flip script: the log of it, written, read and replayed",
    .layout = script_layout,
    .objection = [](Input input) -> std::string {
        const properties::FlipCase flip_case = decode_script(input);
        const auto finding =
            properties::log_reproduces_run(start_of(flip_case), script_of(flip_case));
        return finding ? "log_reproduces_run: " + describe(*finding) : std::string();
    },
    .show = show_script,
    .seeds = script_seeds,
};

}  // namespace tightflip::fuzz
