// SPDX-License-Identifier: Apache-2.0
// A CSV file of a rig. The first byte of the input is the format: '@' the default one.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "driver/base/csv/csv_reader.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {
namespace {

using driver::base::CsvFormat;
using driver::base::CsvReader;
using driver::base::MissingSample;

CsvFormat format_of(unsigned bits) {
  constexpr std::array kSeparators = {'\0', ',', ';', '\t', ' ', '\0', '\0', '\0'};
  constexpr std::array kAnswers = {MissingSample::kError, MissingSample::kSkip,
                                   MissingSample::kHold, MissingSample::kError};
  CsvFormat format;
  format.decimal = (bits & 1U) != 0 ? ',' : '.';
  format.separator = kSeparators[(bits >> 1U) & 7U];
  format.units_row = (bits & 16U) != 0;
  format.missing = kAnswers[(bits >> 5U) & 3U];
  format.skip = (bits & 128U) != 0 ? 2 : 0;
  return format;
}

/// Reads all rows; returns their sum and number, or nothing of a file with a fault.
std::vector<double> sums(CsvReader& reader, std::size_t width) {
  std::vector<double> values(width);
  std::vector<double> sums(width + 1);
  while (true) {
    const auto more = reader.next(values);
    if (!more) {
      want(!more.error().message.empty(), "an error has a message");
      return {};
    }
    if (!*more) return sums;
    for (std::size_t i = 0; i < width; ++i) {
      want(std::isfinite(values[i]), "what is read is a finite number");
      sums[i] += values[i];
    }
    sums.back() += 1.0;
  }
}

}  // namespace

void csv(std::string_view input) {
  if (input.empty()) return;
  const auto bits = static_cast<unsigned char>(input.front());
  const driver::base::DataSource source{own_file("fuzz.csv", input.substr(1)), "fuzz.csv",
                                        format_of(bits ^ static_cast<unsigned>('@'))};
  auto probe = CsvReader::open(source, {});
  if (!probe) return;
  std::vector<std::string> names(probe->header().begin(), probe->header().end());
  constexpr std::size_t kMostColumns = 16;
  if (names.size() > kMostColumns) names.resize(kMostColumns);
  for (const std::string& name : names) probe->unit(name);
  probe->remedy(names);
  auto reader = CsvReader::open(source, names);
  if (!reader) return;
  const std::vector<double> first = sums(*reader, names.size());
  const long line = reader->line();
  if (!reader->rewind()) return;
  const std::vector<double> again = sums(*reader, names.size());
  want(first.size() == again.size() && line == reader->line(), "a file reads the same twice");
  for (std::size_t i = 0; i < first.size(); ++i) {
    want(first[i] == again[i] || std::isnan(first[i]), "a file has the same numbers twice");
  }
  want(driver::base::count_missing(source, names).has_value() || first.empty() ||
           source.format.missing == MissingSample::kError,
       "what is read can be counted");
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(csv)
