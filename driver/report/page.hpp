// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver {

/// A page that needs nothing else: the report's layout, style and program, the chart library with
/// its licence, and the document it shows. `json_document` is JSON text, `title` plain text; what
/// either contains stays text, whatever it looks like.
std::string report_page(std::string_view json_document, std::string_view title);

/// The same of a fit: its layout and program, and the document of fit_document.
std::string fit_page(std::string_view json_document, std::string_view title);

}  // namespace slipbench::driver
