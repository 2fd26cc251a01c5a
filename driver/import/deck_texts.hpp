// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"

namespace slipbench::driver::import {

/// Texts of a deck, its own and those of the files it includes. A piece of a text, a view into it,
/// knows its place.
class DeckTexts {
 public:
  DeckTexts() = default;
  explicit DeckTexts(base::SourceText deck) { add(std::move(deck)); }

  /// Takes a text over; returns its index. Views into texts stay good.
  std::size_t add(base::SourceText text);
  const base::SourceText& operator[](std::size_t index) const { return texts_[index]; }
  std::size_t size() const { return texts_.size(); }

  /// The text that a piece is of; the deck's own where it is of none.
  const base::SourceText& of(std::string_view piece) const;
  /// The file of a piece, as messages name it.
  const std::string& name(std::string_view piece) const { return of(piece).name(); }
  /// The place of a piece in its file; an empty one is the place before which it stands.
  base::SourcePosition position(std::string_view piece) const;
  /// "joint.inc:12", where a piece stands, without the file's folders.
  std::string place(std::string_view piece) const;

  /// All texts, for messages that quote from them.
  std::vector<base::SourceText> all() const { return {texts_.begin(), texts_.end()}; }

 private:
  std::deque<base::SourceText> texts_;
};

/// Returns whether a file is among those that are being read: a deck that includes it there has no
/// end. Links are followed.
bool is_open(const std::vector<std::string>& open, const std::string& path);

}  // namespace slipbench::driver::import
