// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/rows.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "driver/base/text/diagnostic.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

/// Takes a number and what follows it, a comma or nothing, from the front of a text.
template <class Number>
bool take_number(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.empty()) return true;
  if (text.front() != ',') return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

table::TableHead rows_head(const Sweep& sweep, const std::string& identity,
                           const std::optional<Part>& part) {
  table::TableHead head;
  head.lines =
      fmt::format("# slipbench {}\n# sweep: {}\n# title: {}\n# case: {}\n",
                  results::program_version(), file_name(sweep), base::printable(sweep.title),
                  base::printable(fs::path(sweep.case_path).filename().string()));
  if (const std::string settings = settings_text(sweep); !settings.empty()) {
    head.lines += "# set: " + base::printable(settings) + "\n";
  }
  if (part) {
    head.lines +=
        fmt::format("# part: {}/{}\n# identity: {}\n", part->number, part->count, identity);
  }
  head.columns.emplace_back("id");
  for (const VariedParameter& one : sweep.varied) head.columns.push_back(one.name);
  for (const Collected& one : sweep.collected) head.columns.push_back(one.name);
  return head;
}

bool read_row(std::string_view line, std::size_t id, std::span<const double> values,
              std::span<double> numbers) {
  std::size_t own = 0;
  if (!take_number(line, own) || own != id) return false;
  double value = 0.0;
  // Another machine's logarithm may differ in the last digits.
  constexpr double kRounding = 1e-12;
  for (const double known : values) {
    if (!take_number(line, value)) return false;
    if (!(std::abs(value - known) <= kRounding * std::abs(known))) return false;
  }
  for (double& number : numbers) {
    if (!take_number(line, number)) return false;
  }
  return line.empty();
}

}  // namespace slipbench::driver::sweep
