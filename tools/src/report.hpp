/// \file
/// An audit's report in JSON and in a person's words.
#pragma once

#include "command.hpp"
#include <tightflip/kernel/audit.hpp>

#include <functional>
#include <string>

namespace tightflip::tools {

using PlaceInWords = std::function<std::string(const kernel::Violation&)>;

[[nodiscard]] Json to_json(const kernel::Violation& violation, const PlaceInWords& where);
/// The keys of docs/formats.md.
[[nodiscard]] Json to_json(const kernel::AuditReport& report, const PlaceInWords& where);

/// "a sphere", "a torus", "an orientable surface of genus 3", "a Klein bottle", ...
[[nodiscard]] std::string surface_in_words(const kernel::Topology& topology);
/// Several lines, without a newline at the end.
[[nodiscard]] std::string report_in_words(const kernel::AuditReport& report,
                                          const PlaceInWords& where);

}  // namespace tightflip::tools
