/// \file
/// What a claim's check returns when the claim does not hold.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace tightflip::properties {

using kernel::AuditReport;
using kernel::Edge;
using kernel::Index;
using kernel::Topology;
using kernel::Triangulation;
using kernel::Violation;
using kernel::ViolationCode;

/// A list of edges to flip in order. Any list of edges of the start is a valid script: refused
/// flips do nothing.
using FlipScript = std::vector<Edge>;

/// Where in a script something went wrong, and what.
struct Finding {
    std::size_t step = 0;  ///< flips attempted up to and including the one after which it showed
    Violation violation;

    friend bool operator==(const Finding&, const Finding&) = default;
};

/// One line: the step, the code, the place and the message.
[[nodiscard]] std::string describe(const Finding& finding);

}  // namespace tightflip::properties
