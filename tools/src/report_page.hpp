/// \file
/// The web page of an optimisation: start and end in space, the flips one by one, plots, tables.
///
/// One file that needs no network. The page's own sources stand in tools/report; they and the two
/// libraries that it draws with are put together when the command is built, if these are there.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tightflip::tools {

/// A value against flips; one plot.
struct ReportSeries {
    std::string name;
    std::vector<std::int64_t> flips;  ///< ascending
    std::vector<double> values;  ///< one for each of these; those that are not finite are left out
};

struct OptimisationReport {
    std::string title;
    std::vector<std::pair<std::string, std::string>> facts;  ///< rows of the table, in words
    const geometry::Surface& before;
    std::span<const geometry::Edge> flips;  ///< from there, in order
    std::vector<ReportSeries> series;
};

/// How much a page keeps, so that a browser still opens it.
struct ReportLimits {
    /// Of flips to step through; beyond it whole surfaces are kept, from start to end ...
    std::size_t flips = 1'000'000;
    /// ... at most so many ...
    std::size_t surfaces = 50;
    /// ... and so many halfedges in all, but never less than start and end.
    std::size_t halfedges = 4'000'000;
    /// Larger surfaces are not in the page at all, which then has plots and tables only.
    geometry::Index vertices = 200'000;
    /// Of each series; of more, the least and the greatest of equal stretches are kept.
    std::size_t series_points = 2'000;
};

/// Whether the libraries were there when the command was built.
[[nodiscard]] bool can_write_report() noexcept;
/// What to say where they were not.
inline constexpr std::string_view how_to_get_reports =
    "this command was built without the libraries of the report: install the packages libjs-three "
    "and libjs-chart.js and build again";

/// Writes DIRECTORY/index.html, and makes the directory. Edges' shapes are decided exactly, for
/// each flip of five edges. Throws kernel::FileError where that cannot be written or the libraries
/// are missing, and std::invalid_argument or std::out_of_range where a flip is not defined on the
/// surface it is to be done on.
void write_report(const std::filesystem::path& directory, const OptimisationReport& report,
                  const ReportLimits& limits = {});

}  // namespace tightflip::tools
