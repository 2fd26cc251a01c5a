// SPDX-License-Identifier: Apache-2.0
#include "driver/import/deck_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "driver/base/files/data_path.hpp"

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

tl::expected<base::SourceText, IncludeFault> OpenFiles::open(std::string_view name,
                                                             std::size_t size_limit) {
  const auto path = base::resolve_data_path(folder_.path, name, folder_.allow_outside);
  if (!path) return tl::unexpected(IncludeFault{false, path.error().message, {}});
  const std::string file = path->string();
  std::error_code ignored;
  const bool is_open = std::any_of(open_.begin(), open_.end(), [&](const std::string& one) {
    return std::filesystem::equivalent(one, file, ignored);
  });
  if (is_open) {
    return tl::unexpected(IncludeFault{false, "files include each other without end", {}});
  }
  if (open_.size() > deepest_) {
    return tl::unexpected(IncludeFault{
        false, fmt::format("files include each other {} deep, and no deeper", deepest_), {}});
  }
  auto source = base::read_source(file, size_limit);
  if (!source) {
    return tl::unexpected(IncludeFault{true, source.error().diagnostic.message,
                                       "files that a deck includes are looked for in its folder"});
  }
  constexpr std::size_t kMostAgain = std::size_t{16} << 20U;
  constexpr std::size_t kLeast = 4096;  // reading an empty one takes time, too
  if (!known_.insert(file).second) again_ += std::max(kLeast, source->text().size());
  if (again_ > kMostAgain) {
    return tl::unexpected(
        IncludeFault{false, "files that are included more than once are more than 16 MiB", {}});
  }
  open_.push_back(file);
  return std::move(*source);
}

}  // namespace slipbench::driver::import
