/// \file
/// What `optimise` does, without its words: the searches one after the other, as one log.
#pragma once

#include "flip_outputs.hpp"
#include "surface_input.hpp"
#include <tightflip/geometry/strategy.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tightflip::tools {

struct OptimiseRequest {
    std::string file;
    std::string criterion = "tight";
    std::string then;  ///< a second one, by local search; empty: none
    geometry::Strategy strategy = geometry::Strategy::automatic;
    geometry::OptimiseOptions search;
    std::vector<kernel::Index> locked;
    std::optional<kernel::Index> marked;
    std::optional<double> seconds;
    std::string resume;  ///< a log that starts from the file, to go on from; empty: none
    std::string trace;
    std::string report;
    FlipOutputs outputs;
    InputOptions input;
};

/// One criterion's part of the work.
struct CoursePart {
    std::string criterion;
    geometry::StrategyResult result;  ///< the trace counts flips from the file's surface
    std::size_t levels = 1;           ///< of its energies
};

/// The whole of it: one log from the file's surface to the end.
struct Course {
    geometry::Surface start;
    std::vector<kernel::Edge> flips;
    geometry::Surface surface;
    std::vector<CoursePart> parts;  ///< one, or two with `then`
    double seconds = 0;             ///< of the search

    [[nodiscard]] geometry::OptimiseEnd end() const { return parts.back().result.end; }
};

/// Reads, searches under a progress bar until all is done, a limit is reached or an interrupt was
/// noted, and audits the end. Throws FileError for files, std::invalid_argument for criteria,
/// vertices, edges and strategies that the data do not have.
[[nodiscard]] Course run_course(const OptimiseRequest& request);

}  // namespace tightflip::tools
