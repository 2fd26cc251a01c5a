// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/fit_report.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>

#include "driver/report/page_parts.hpp"
#include "tests/driver/calibrate/report/made_fits.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST_CASE("the page of a fit is one file with all that it needs") {
  const TemporaryFolder folder;
  const MadeFit made = made_table_fit();
  const auto size = write_fit_report(made.fit, made.calibration, folder.path() / "fit.html");
  REQUIRE(size);
  const std::string page = file_text(folder.path() / "fit.html");
  CHECK(page.size() == *size);
  CHECK(count(page, report::page_part::style_css()) == 1);
  CHECK(count(page, report::page_part::fit_css()) == 1);
  CHECK(count(page, report::page_part::tools_js()) == 1);
  CHECK(count(page, report::page_part::fit_js()) == 1);
  CHECK(count(page, report::page_part::chart_js()) == 1);
  CHECK(page.find("<title>Brake pad: coefficient over slip rate and temperature</title>") !=
        std::string::npos);
  CHECK(page.find("src=\"") == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(count(report::page_part::fit_html(), "<link") == 1);  // the empty icon
}

TEST_CASE("names of a fit stay text in its page, whatever they look like") {
  const TemporaryFolder folder;
  const MadeFit plain = made_slider_fit();
  const MadeFit hostile = made_hostile_fit();
  REQUIRE(write_fit_report(plain.fit, plain.calibration, folder.path() / "plain.html"));
  REQUIRE(write_fit_report(hostile.fit, hostile.calibration, folder.path() / "hostile.html"));
  const std::string page = file_text(folder.path() / "plain.html");
  const std::string other = file_text(folder.path() / "hostile.html");
  for (const char* tag : {"<script", "</script>", "<b>", "</title>"}) {
    INFO(tag);
    CHECK(count(other, tag) == count(page, tag));
  }
  CHECK(other.find("<title>&lt;b&gt;bold&lt;/b&gt;&lt;script&gt;") != std::string::npos);
}

TEST_CASE("a page takes the place of no file that the fit reads") {
  const TemporaryFolder folder;
  const auto data = folder.write("data.csv", "t,F\n");
  const MadeFit made = made_slider_fit();
  const std::array<std::string, 1> inputs{data.string()};
  const auto size = write_fit_report(made.fit, made.calibration, data, {.inputs = inputs});
  REQUIRE_FALSE(size);
  CHECK(size.error().find("data.csv") != std::string::npos);
  CHECK(file_text(data) == "t,F\n");
}

}  // namespace
}  // namespace slipbench::driver::calibrate
