/// \file
/// The page of a report without its data, as the build puts it together from tools/report.
#pragma once

#include <string_view>

namespace tightflip::tools {

/// With places for the title and the data; empty where a library was missing.
[[nodiscard]] std::string_view report_page_text() noexcept;

}  // namespace tightflip::tools
