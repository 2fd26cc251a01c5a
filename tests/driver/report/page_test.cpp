// SPDX-License-Identifier: Apache-2.0
#include "driver/report/page.hpp"

#include <catch2/catch.hpp>

#include "driver/report/page_parts.hpp"

namespace slipbench::driver::report {
namespace {

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST_CASE("a page carries style, program, chart library with its licence, and the document") {
  const std::string page = report_page(R"({"schema": 1})", "Two runs");
  CHECK(page.find("<title>Two runs</title>") != std::string::npos);
  CHECK(count(page, R"({"schema": 1})") == 1);
  CHECK(count(page, page_part::style_css()) == 1);
  CHECK(count(page, page_part::tools_js()) == 1);
  CHECK(count(page, page_part::page_js()) == 1);
  CHECK(count(page, page_part::chart_js()) == 1);
  CHECK(page.find("Released under the MIT License") != std::string::npos);
  CHECK(page.find("</html>") != std::string::npos);
}

TEST_CASE("nothing in a page is fetched from elsewhere") {
  const std::string page = report_page("{}", "x");
  CHECK(page.find("src=\"") == std::string::npos);
  CHECK(page.find("@import") == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(count(page_part::page_html(), "<link") == 1);  // the empty icon
}

TEST_CASE(
    "a page with the bench may run it, carries it along, and its cases' data files stay text") {
  LiveBench bench{.page_part = "<script>bench</script>"};
  bench.files.emplace_back(base::json::Object{{"rig.csv", "t</script>\n1\n"}});
  const std::string page = report_page("{}", "x", &bench);
  CHECK(page.find("script-src 'unsafe-inline' 'wasm-unsafe-eval'") != std::string::npos);
  CHECK(count(page, bench.page_part) == 1);
  CHECK(count(page, page_part::live_js()) == 1);
  CHECK(count(page, page_part::live_css()) == 1);
  CHECK(page.find(R"([{"rig.csv": "t\u003c/script>\n1\n"}])") != std::string::npos);
  const std::string plain = report_page("{}", "x");
  CHECK(plain.find("wasm") == std::string::npos);
  CHECK(count(plain, page_part::live_js()) == 0);
}

TEST_CASE("a title and a document stay text, whatever they look like") {
  const std::string hostile = "</script></title><script>x()</script>{{script}} & \"";
  const std::string page = report_page("{\"title\":\"" + hostile + "\"}", hostile);
  const std::string plain = report_page("{}", "");
  CHECK(count(page, "<script") == count(plain, "<script"));
  CHECK(count(page, "</script>") == count(plain, "</script>"));
  CHECK(count(page, "</title>") == 1);
  CHECK(page.find("<title>&lt;/script&gt;&lt;/title&gt;&lt;script&gt;x()&lt;/script&gt;{{script}} "
                  "&amp; &quot;</title>") != std::string::npos);
  CHECK(page.find(R"({"title":"\u003c/script>\u003c/title>)") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::report
