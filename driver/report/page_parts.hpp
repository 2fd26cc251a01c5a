// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The files that a page is made of, as the build embedded them (cmake/SlipbenchEmbed.cmake).
namespace slipbench::driver::page_part {

std::string_view page_html();  ///< the layout, with {{places}} for the others
std::string_view style_css();
std::string_view page_js();
std::string_view chart_js();  ///< Chart.js, minified, with its licence

}  // namespace slipbench::driver::page_part
