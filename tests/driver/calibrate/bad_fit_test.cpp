// SPDX-License-Identifier: Apache-2.0
// Every file of cases/bad/calibration is refused, at the place and with the words its second line
// wants: "# wants PATH ... WORDS".
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "driver/calibrate/read_fit.hpp"
#include "driver/read/read_case.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> bad_fits() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::source_dir() + "/cases/bad/calibration")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST_CASE("A bad fit file is refused with its place and what is wrong") {
  const std::vector<fs::path> files = bad_fits();
  CHECK(files.size() >= 45);
  for (const fs::path& file : files) {
    std::ifstream in(file);
    std::string what, wanted;
    std::getline(in, what);
    std::getline(in, wanted);
    const ReadFit read = read_fit(file.string());
    const std::string shown = base::render(read.diagnostics, read.sources);
    INFO(file.filename() << "\n" << what << "\n" << wanted << "\n" << shown);
    REQUIRE(wanted.starts_with("# wants "));
    const std::size_t dots = wanted.find(" ... ");
    REQUIRE(dots != std::string::npos);
    const std::string place = wanted.substr(8, dots - 8);
    const std::string words = wanted.substr(dots + 5);
    CHECK_FALSE(read.value.has_value());
    CHECK_FALSE(read.environment_failure);
    bool found = false;
    for (const base::Diagnostic& one : read.diagnostics.sorted()) {
      if (one.severity != base::Severity::kError) continue;
      CHECK(one.where.line > 0);
      const std::string text = one.message + "; " + one.hint;
      const bool here = one.path == place || one.file.ends_with(place);
      found = found || (here && text.find(words) != std::string::npos);
    }
    CHECK(found);
    // One fault is one error.
    CHECK(read.diagnostics.count(base::Severity::kError) == 1);
  }
}

TEST_CASE("The cases beside the bad fits are sound, or nothing could be learnt from them") {
  for (const char* name : {"loop", "table", "no_units", "extra"}) {
    const read::ReadCase read =
        read::read_case(test::source_dir() + "/cases/bad/calibration/sound/" + name + ".yaml");
    INFO(base::render(read.diagnostics, read.sources));
    CHECK(read.value.has_value());
  }
}

}  // namespace
}  // namespace slipbench::driver::calibrate
