// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "driver/base/files/file_mark.hpp"
#include "driver/report/live_bench.hpp"

namespace slipbench::driver::report {

/// A page that needs nothing else: the report's layout, style and program, the chart library with
/// its licence, and the document it shows. `json_document` is JSON text, `title` plain text; what
/// either contains stays text, whatever it looks like.
/// \param bench runs the cases in the page; null for a page to look at
std::string report_page(std::string_view json_document, std::string_view title,
                        const LiveBench* bench = nullptr);

/// The same of a fit: its layout and program, and the document of fit_document.
/// \param source the name of the fit file
std::string fit_page(std::string_view json_document, std::string_view title,
                     std::string_view source);

/// The marks of the pages: of any report, and of the fits of one file name.
base::FileMark report_page_mark();
base::FileMark fit_page_mark(std::string_view source);

}  // namespace slipbench::driver::report
