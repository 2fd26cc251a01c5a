// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA keyword deck as blocks of cards: what the keywords on friction have below them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/import/deck_texts.hpp"

namespace slipbench::driver::lsdyna {

/// Keyword with the cards up to the next one. Texts are views into the deck's source.
struct Block {
  std::string keyword;                  ///< in capitals, without '*' and the marks of a format
  std::string_view where;               ///< its line
  std::vector<std::string_view> cards;  ///< without comments
  bool is_long = false;                 ///< fields of 20 columns in place of 10
};

/// Blocks of a deck on friction: *CONTACT.., *DEFINE_FRICTION, tables, curves, sets of parts.
struct KeywordDeck {
  import::DeckTexts texts;
  std::vector<Block> blocks = {};
  base::NamedNumbers parameters = {};  ///< of *PARAMETER, which fields name as &name
};

/// Splits a deck into blocks, and those of the files that it includes, which are looked for in
/// `folder`; one that cannot be read is a warning, one outside of it an error. Lines that begin
/// with '$' are comments.
KeywordDeck split_deck(const base::SourceText& source, const import::DeckFolder& folder,
                       base::Diagnostics& out);

/// Fields of the cards of a block: 10 columns each (20 in long format), or between commas. The
/// first fault is reported, and all fields are 0 from then on.
class CardReader {
 public:
  CardReader(const KeywordDeck& deck, const Block& block, base::Diagnostics& out)
      : deck_(deck), block_(block), out_(out) {}

  std::size_t count() const { return block_.cards.size(); }
  bool sound() const { return sound_; }
  /// The text of a field, without blanks around it; empty behind the last one.
  std::string_view text(std::size_t card, std::size_t field, std::size_t columns = 10) const;
  /// Tells whether a card has nothing in it.
  bool is_blank(std::size_t card) const;
  /// Its number; 0 where it is empty.
  double number(std::size_t card, std::size_t field, std::string_view name,
                std::size_t columns = 10);
  int id(std::size_t card, std::size_t field, std::string_view name, std::size_t columns = 10);
  /// Reports that a field has a number which cannot be meant.
  void refuse(std::size_t card, std::size_t field, const std::string& message) {
    fault(text(card, field), message);
  }

 private:
  void fault(std::string_view piece, const std::string& message);

  const KeywordDeck& deck_;
  const Block& block_;
  base::Diagnostics& out_;
  bool sound_ = true;
};

}  // namespace slipbench::driver::lsdyna
