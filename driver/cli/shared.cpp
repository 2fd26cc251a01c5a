// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/table/table_head.hpp"

namespace slipbench::driver::cli {
namespace {

std::string found(const std::string& value) { return ", found '" + base::printable(value) + "'"; }

}  // namespace

void declare_settings(CLI::App& command, std::vector<std::string>& settings, bool& allow_outside) {
  command
      .add_option("--set", settings,
                  "Give a parameter of the case another value; a number or an expression")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--allow-outside", allow_outside,
                   "Let the case read data files outside its own folder");
}

CLI::Validator whole_number(int first, int last) {
  return {[=](std::string& value) {
            const auto number = base::parse_number(value);
            if (number && *number >= first && *number <= last && *number == std::floor(*number)) {
              return std::string();
            }
            return fmt::format("wanted a whole number from {} to {}", first, last) + found(value);
          },
          ""};
}

CLI::Validator any_number() {
  return {[](std::string& value) {
            return base::parse_number(value) ? std::string() : "wanted a number" + found(value);
          },
          ""};
}

CLI::Validator number_between(double first, double last) {
  return {[=](std::string& value) {
            const auto number = base::parse_number(value);
            if (number && *number >= first && *number <= last) return std::string();
            return fmt::format("wanted a number from {} to {}", first, last) + found(value);
          },
          ""};
}

CLI::Validator one_of(std::vector<std::string> words) {
  return {[words = std::move(words)](std::string& value) {
            const std::vector<std::string_view> names(words.begin(), words.end());
            if (std::find(names.begin(), names.end(), value) != names.end()) return std::string();
            return fmt::format("unknown word '{}'; {}", base::printable(value),
                               base::did_you_mean(value, names, "the help lists all"));
          },
          ""};
}

void declare_format(CLI::App& command, std::string& format) {
  command.add_option("--format", format, "Format of the rows: csv, npy (NumPy) or h5 (HDF5)")
      ->type_name("csv|npy|h5")
      ->check(one_of({table::kTableFormats.begin(), table::kTableFormats.end()}))
      ->capture_default_str();
}

void declare_force(CLI::App& command, bool& force, const std::string& what) {
  command.add_flag("--force", force, "Replace a file that is " + what + ", but never an input");
}

void name_cases(std::vector<std::string>& paths) {
  for (std::string& path : paths) path = commands::named_case(path);
}

}  // namespace slipbench::driver::cli
