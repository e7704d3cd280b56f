/// \file
/// What every verb of the command has in common: exit codes, the two streams, one JSON object an
/// input.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace tightflip::tools {

/// The command's exit codes (docs/formats.md).
enum class Exit : int { holds = 0, does_not_hold = 1, unusable = 2, undecided = 3 };

/// Of several inputs' codes the one to exit with: unusable, does not hold, undecided, holds.
[[nodiscard]] Exit worse(Exit a, Exit b) noexcept;

using Json = nlohmann::ordered_json;

/// Where results and messages go. With --json, stdout carries JSON objects alone, one a line, and
/// words go to stderr.
class Output {
public:
    bool as_json = false;

    /// A line of the result in words; not shown with --json.
    void say(std::string_view line) const;
    /// A result as JSON; shown only with --json.
    void object(const Json& json) const;
    /// A message on stderr.
    static void complain(std::string_view line);
    /// Whether results were lost, to a full disk or a closed pipe.
    [[nodiscard]] static bool is_broken();
    /// The code to exit with: lost results make the run unusable.
    [[nodiscard]] static Exit finish(Exit exit);
};

/// Runs `judge` on each input; one that is unusable gets its message and, with --json, an object
/// with the key "error", and the others go on, for as long as results can be written.
[[nodiscard]] Exit for_each_input(const Output& output, const std::vector<std::string>& inputs,
                                  const std::function<Exit(const std::string&)>& judge);

/// Checks of options: a whole number not below `least`, a number of seconds, a length, and a name
/// that is not empty. The parser alone would take -1 for the largest number there is, "nan" for a
/// time, and an empty name for none.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least = 0);
[[nodiscard]] CLI::Validator seconds();
[[nodiscard]] CLI::Validator length();
[[nodiscard]] CLI::Validator file_name();

/// A verb adds its options to the application and keeps what to do when it is called.
using Action = std::function<Exit()>;
void add_make(CLI::App& app, const Output& output, Action& action);
void add_check(CLI::App& app, const Output& output, Action& action);
void add_campaign(CLI::App& app, const Output& output, Action& action);
void add_flip(CLI::App& app, const Output& output, Action& action);
void add_replay(CLI::App& app, const Output& output, Action& action);
void add_explore(CLI::App& app, const Output& output, Action& action);
void add_path(CLI::App& app, const Output& output, Action& action);
void add_verify(CLI::App& app, const Output& output, Action& action);
void add_canonical(CLI::App& app, const Output& output, Action& action);
void add_isomorphic(CLI::App& app, const Output& output, Action& action);
void add_convert(CLI::App& app, const Output& output, Action& action);
void add_measure(CLI::App& app, const Output& output, Action& action);
void add_render(CLI::App& app, const Output& output, Action& action);
void add_optimise(CLI::App& app, const Output& output, Action& action);
void add_hull(CLI::App& app, const Output& output, Action& action);
void add_info(CLI::App& app, const Output& output, Action& action);

}  // namespace tightflip::tools
