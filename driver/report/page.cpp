// SPDX-License-Identifier: Apache-2.0
#include "driver/report/page.hpp"

#include <array>
#include <span>
#include <utility>

#include "driver/report/page_parts.hpp"
#include "driver/report/page_text.hpp"

namespace slipbench::driver::report {

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

namespace {

/// In JSON a '<' stands in strings only. Escaped, no string can end the element it is embedded in.
std::string escape_json(std::string_view json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

// As they stand in the layouts.
constexpr const char* kPageStart = "<!doctype html>\n";
constexpr const char* kGenerator = "<meta name=\"generator\" content=\"slipbench ";

/// A part of a page and the name of its place in the layout.
using Part = std::pair<std::string_view, std::string_view>;

/// In one pass over the layout, so that places within the parts are left as they are.
std::string fill(std::string_view layout, std::span<const Part> parts) {
  std::string page;
  std::size_t size = layout.size();
  for (const Part& part : parts) size += part.second.size();
  page.reserve(size);
  std::string_view rest = layout;
  while (!rest.empty()) {
    const std::size_t open = rest.find("{{");
    const std::size_t close = open == std::string_view::npos ? open : rest.find("}}", open);
    if (close == std::string_view::npos) break;
    page += rest.substr(0, open);
    const std::string_view place = rest.substr(open + 2, close - open - 2);
    for (const auto& [name, text] : parts) {
      if (name == place) page += text;
    }
    rest.remove_prefix(close + 2);
  }
  page += rest;
  return page;
}

}  // namespace

std::string report_page(std::string_view json_document, std::string_view title,
                        const LiveBench* bench) {
  const std::string document = escape_json(json_document);
  const std::string heading = escape_html(title);
  const std::string live =
      bench == nullptr ? ""
                       : bench->page_part + "<script type=\"application/json\" id=\"live-files\">" +
                             escape_json(base::json::Value(bench->files).dump()) + "</script>";
  const std::array<Part, 12> parts{{
      {"title", heading},
      {"style", page_part::style_css()},
      {"document", document},
      {"chart", page_part::chart_js()},
      {"tools", page_part::tools_js()},
      {"curves", page_part::curves_js()},
      {"picture_tools", page_part::picture_tools_js()},
      {"script", page_part::page_js()},
      {"policy", bench == nullptr ? "" : " 'wasm-unsafe-eval'"},
      {"bench", live},
      {"live", bench == nullptr ? "" : page_part::live_js()},
      {"live_style", bench == nullptr ? "" : page_part::live_css()},
  }};
  return fill(page_part::page_html(), parts);
}

std::string fit_page(std::string_view json_document, std::string_view title,
                     std::string_view source) {
  const std::string document = escape_json(json_document);
  const std::string heading = escape_html(title);
  const std::string name = escape_html(source);
  const std::array<Part, 8> parts{{
      {"title", heading},
      {"source", name},
      {"style", page_part::style_css()},
      {"fit_style", page_part::fit_css()},
      {"document", document},
      {"chart", page_part::chart_js()},
      {"tools", page_part::tools_js()},
      {"script", page_part::fit_js()},
  }};
  return fill(page_part::fit_html(), parts);
}

base::FileMark report_page_mark() {
  return {"a page of slipbench's reports", kPageStart, kGenerator + std::string("report\">")};
}

base::FileMark fit_page_mark(std::string_view source) {
  return {"the page of " + std::string(source), kPageStart,
          kGenerator + ("calibrate " + escape_html(source)) + "\">"};
}

}  // namespace slipbench::driver::report
