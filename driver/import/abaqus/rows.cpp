// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "driver/base/text/diagnostic.hpp"
#include "driver/import/abaqus/keyword_list.hpp"

namespace slipbench::driver::abaqus {

std::string word_of(const KeywordDeck& deck, const Block& block, std::string_view name,
                    const std::vector<std::string_view>& words) {
  const Parameter* const one = block.find(name);
  if (one == nullptr) return std::string(words.front());
  const FoundName found = find_name(one->value.value_or(""), words);
  if (found.name.empty()) {
    deck.error(one->where, block, fmt::format("{} is {}", name, base::in_words(words)));
    return std::string(words.front());
  }
  return std::string(found.name);
}

std::vector<Row> read_rows(const KeywordDeck& deck, const Block& block,
                           const std::vector<Items>& lines, std::size_t most,
                           std::string_view wanted) {
  constexpr std::size_t kItemsOfLine = 8;
  const std::size_t lines_of_row = (most + kItemsOfLine - 1) / kItemsOfLine;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < lines.size(); i += lines_of_row) {
    Row row;
    row.reserve(std::min(lines[i].size(), most));
    bool sound = true;
    for (std::size_t k = i; k < std::min(i + lines_of_row, lines.size()); ++k) {
      // Behind a line that ends early, items of the row's next line keep their places.
      row.resize((k - i) * kItemsOfLine);
      for (const std::string_view item : lines[k]) {
        if (row.size() == most) {
          deck.error(item, block, fmt::format("is one number too many: wanted {}", wanted));
          sound = false;
          break;
        }
        if (item.empty()) {
          row.emplace_back();
          continue;
        }
        const auto number = deck.number(item);
        if (!number) {
          deck.error(item, block, number.error() + ": wanted " + std::string(wanted));
          sound = false;
          break;
        }
        row.emplace_back(*number);
      }
    }
    if (sound && !row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<int> component_in(const KeywordDeck& deck, std::string_view item) {
  const auto number = deck.number(item);
  if (!number || *number != std::floor(*number) || *number < 1.0 || *number > 6.0) {
    return std::nullopt;
  }
  return static_cast<int>(*number);
}

}  // namespace slipbench::driver::abaqus
