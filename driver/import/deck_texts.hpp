// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
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

/// Folder of a deck, which the files that it includes lie in.
struct DeckFolder {
  std::string path;
  bool allow_outside = false;  ///< they may lie elsewhere, too
};

/// Reason why an included file is not read.
struct IncludeFault {
  bool is_missing = false;  ///< it cannot be read; else it must not be
  std::string message;
  std::string hint;
};

/// Files of a deck that are being read, each included by the last one.
class OpenFiles {
 public:
  OpenFiles(DeckFolder folder, std::string deck, std::size_t deepest)
      : folder_(std::move(folder)), deepest_(deepest), open_{std::move(deck)} {}

  /// Opens a file that the last one includes, by its name in the deck's folder. Links are followed.
  /// Errors: a file that is open already, as such a deck has no end; one outside of the folder; one
  /// that cannot be read; files that are included again, when they are 16 MiB together: forty
  /// files, each of which includes the next one twice, stand for 10^12 of them.
  tl::expected<base::SourceText, IncludeFault> open(std::string_view name, std::size_t size_limit);
  /// Ends the file that was opened last.
  void close() { open_.pop_back(); }

 private:
  DeckFolder folder_;
  std::size_t deepest_;
  std::vector<std::string> open_;
  std::set<std::string> known_;  ///< those that were included before
  std::size_t again_ = 0;        ///< bytes of those that were included again
};

}  // namespace slipbench::driver::import
