// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// The files that a page is made of, as the build embedded them (cmake/SlipbenchEmbed.cmake).
namespace slipbench::driver::report::page_part {

std::string_view page_html();         ///< the layout, with {{places}} for the others
std::string_view fit_html();          ///< that of a fit's page
std::string_view style_css();         ///< of both
std::string_view fit_css();           ///< what a fit's page has besides
std::string_view sweep_css();         ///< of the page of a sweep, which has nothing else
std::string_view tools_js();          ///< what both programs have in common, before either
std::string_view curves_js();         ///< of a report: its rows and how they are drawn
std::string_view picture_tools_js();  ///< zooming and saving
std::string_view page_js();
std::string_view fit_js();
std::string_view live_js();   ///< the bench in the page, behind the report's program
std::string_view live_css();  ///< and its style
std::string_view chart_js();  ///< Chart.js, minified, with its licence

}  // namespace slipbench::driver::report::page_part
