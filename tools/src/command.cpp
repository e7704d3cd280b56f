#include "command.hpp"

#include <tightflip/kernel/file_error.hpp>

#include <charconv>
#include <cmath>
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

/// A line that can be read as soon as it is written: a script may wait for it.
void print_line(std::string_view line) {
    // What fails is remembered by the stream; see Output::is_broken.
    static_cast<void>(std::fwrite(line.data(), 1, line.size(), stdout));
    static_cast<void>(std::fputc('\n', stdout));
    static_cast<void>(std::fflush(stdout));
}

/// Whether the whole text is one number.
template <class Number>
bool parse(const std::string& text, Number& value) {
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stopped == end;
}

/// A check for a finite number that is not negative; `what` names it.
CLI::Validator finite_from_zero(const char* what) {
    return {[what](std::string& text) {
                double value = 0;
                if (parse(text, value) && std::isfinite(value) && value >= 0) return std::string{};
                return fmt::format("'{}' is no {}", text, what);
            },
            ""};
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
    if (!as_json) print_line(line);
}

void Output::object(const Json& json) const {
    // Names of files need not be UTF-8; a byte that is not is replaced, never thrown over.
    if (as_json) print_line(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Output::complain(std::string_view line) {
    // Where standard error is lost too, the exit code is all that can be said.
    const std::string text = fmt::format("tightflip: {}\n", line);
    static_cast<void>(std::fputs(text.c_str(), stderr));
}

bool Output::is_broken() {
    return std::ferror(stdout) != 0;
}

Exit Output::finish(Exit exit) {
    if (std::fflush(stdout) == 0 && !is_broken()) return exit;
    complain("the results could not be written to standard output");
    return Exit::unusable;
}

Exit for_each_input(const Output& output, const std::vector<std::string>& inputs,
                    const std::function<Exit(const std::string&)>& judge) {
    Exit exit = Exit::holds;
    for (const std::string& input : inputs) {
        if (Output::is_broken()) break;
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

CLI::Validator whole_number(std::uint64_t least) {
    return {[least](std::string& text) {
                std::uint64_t value = 0;
                if (parse(text, value) && value >= least) {
                    text = std::to_string(value);  // the parser takes 010 for eight
                    return std::string{};
                }
                return fmt::format("'{}' is no whole number from {} up", text, least);
            },
            ""};
}

CLI::Validator seconds() {
    return finite_from_zero("number of seconds");
}

CLI::Validator length() {
    return finite_from_zero("length");
}

CLI::Validator file_name() {
    return {[](std::string& text) { return text.empty() ? "a file needs a name" : ""; }, ""};
}

}  // namespace tightflip::tools
