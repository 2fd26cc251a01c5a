// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_units.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>

namespace slipbench::driver::commands {

std::vector<std::string> words_of(const std::string& text) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream stream(spaced);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

tl::expected<base::UnitSystem, std::string> parse_units(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  if (words.size() != 3) {
    return tl::make_unexpected("--units wants units of length, force and time, like \"mm N s\"");
  }
  const std::array<base::Dimension, 3> dimensions{base::kLength, base::kForce, base::kTime};
  for (std::size_t i = 0; i < 3; ++i) {
    if (const auto good = base::check_base_unit(words[i], dimensions[i]); !good) {
      return tl::make_unexpected("--units: " + good.error().message);
    }
  }
  return base::UnitSystem{words[0], words[1], words[2], {}};
}

}  // namespace slipbench::driver::commands
