#include "command.hpp"

#include <tightflip/kernel/file_error.hpp>

#include <algorithm>
#include <cstdio>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

/// The message of an exception that bad input or usage can cause.
std::string reason_of(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        return "not enough memory for this input";
    }
    return error.what();
}

}  // namespace

Exit worse(Exit a, Exit b) noexcept {
    constexpr auto rank = [](Exit exit) {
        switch (exit) {
            case Exit::holds:
                return 0;
            case Exit::undecided:
                return 1;
            case Exit::does_not_hold:
                return 2;
            case Exit::unusable:
                return 3;
        }
        return 3;
    };
    return rank(a) >= rank(b) ? a : b;
}

void Output::say(std::string_view line) const {
    if (!as_json) fmt::print("{}\n", line);
}

void Output::object(const Json& json) const {
    // Names of files need not be UTF-8; a byte that is not is replaced, never thrown over.
    if (as_json) fmt::print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Output::complain(std::string_view line) {
    fmt::print(stderr, "tightflip: {}\n", line);
}

Exit Output::finish(Exit exit) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit;
    complain("the results could not be written to standard output");
    return Exit::unusable;
}

Exit for_each_input(const Output& output, const std::vector<std::string>& inputs,
                    const std::function<Exit(const std::string&)>& judge) {
    Exit exit = Exit::holds;
    for (const std::string& input : inputs) {
        try {
            exit = worse(exit, judge(input));
        } catch (const std::exception& error) {
            Output::complain(reason_of(error));
            output.object({{"file", input}, {"error", reason_of(error)}});
            exit = Exit::unusable;
        }
    }
    return exit;
}

}  // namespace tightflip::tools
