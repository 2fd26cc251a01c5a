// SPDX-License-Identifier: Apache-2.0
// Rows of numbers as `convert` reads them: of NumPy where the input begins like that, else CSV.
#include <array>
#include <vector>

#include "driver/table/table_reader.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void table(std::string_view input) {
  const bool npy = input.starts_with("\x93NUMPY");
  const auto opened =
      driver::table::open_table(own_file(npy ? "fuzz.npy" : "fuzz_table.csv", input));
  if (!opened) {
    want(!opened.error().empty(), "an error has a sentence");
    return;
  }
  const std::size_t width = (*opened)->head().columns.size();
  want(width > 0, "a table has a column");
  std::vector<double> numbers(64 * width);
  while (true) {
    const auto rows = (*opened)->read(numbers);
    if (!rows || *rows == 0) break;
    want(*rows <= 64, "no more rows come than there is room for");
  }
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(table)
