// SPDX-License-Identifier: Apache-2.0
// A result of `slipbench run`: the rows, and after lines "%%%" the JSON and the events beside them.
#include <array>
#include <string>

#include "driver/report/read_result.hpp"
#include "driver/results/plot_data.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void result(std::string_view input) {
  constexpr std::string_view kCut = "%%%\n";
  constexpr std::size_t kMostRows = 100;
  for (const std::string_view name : std::array{"fuzz.csv", "fuzz.json", "fuzz.events.csv"}) {
    const std::size_t end = input.find(kCut);
    own_file(name, input.substr(0, end));
    input = end == input.npos ? std::string_view() : input.substr(end + kCut.size());
  }
  const driver::report::ReadResult read =
      driver::report::read_result("fuzz.csv", "fuzz", kMostRows);
  want(read.code == driver::base::kExitOk || !read.report.message.empty(),
       "a result that is refused is told why");
  const auto drawn = driver::results::read_plot_data("fuzz.csv", "fuzz.csv");
  want(drawn.has_value() || !drawn.error().message.empty(), "an error has a message");
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(result)
