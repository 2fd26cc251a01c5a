// SPDX-License-Identifier: Apache-2.0
#include "driver/import/deck_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

namespace slipbench::driver::import {

std::size_t DeckTexts::add(base::SourceText text) {
  texts_.push_back(std::move(text));
  return texts_.size() - 1;
}

const base::SourceText& DeckTexts::of(std::string_view piece) const {
  const std::less_equal<> before;  // of pointers into different texts
  const auto found = std::find_if(texts_.begin(), texts_.end(), [&](const base::SourceText& one) {
    const std::string_view text = one.text();
    return before(text.data(), piece.data()) && before(piece.data(), text.data() + text.size());
  });
  return found == texts_.end() ? texts_.front() : *found;
}

base::SourcePosition DeckTexts::position(std::string_view piece) const {
  const base::SourceText& source = of(piece);
  const auto offset = static_cast<std::size_t>(piece.data() - source.text().data());
  return source.position(offset, std::max<std::size_t>(1, piece.size()));
}

std::string DeckTexts::place(std::string_view piece) const {
  return fmt::format("{}:{}", std::filesystem::path(name(piece)).filename().string(),
                     position(piece).line);
}

bool is_open(const std::vector<std::string>& open, const std::string& path) {
  std::error_code ignored;
  return std::any_of(open.begin(), open.end(), [&](const std::string& one) {
    return std::filesystem::equivalent(one, path, ignored);
  });
}

}  // namespace slipbench::driver::import
