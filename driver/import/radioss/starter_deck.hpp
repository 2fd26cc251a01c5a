// SPDX-License-Identifier: Apache-2.0
// A starter deck as blocks of lines: what the keywords on friction have under them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/import/deck_texts.hpp"

namespace slipbench::driver::radioss {

/// A keyword with the lines up to the next one. Texts are views into the deck's source.
struct DeckBlock {
  std::vector<std::string> words;            ///< of "/FRICTION/7/2": FRICTION, 7, 2, in capitals
  std::string_view keyword;                  ///< the line as it is, without blanks at its end
  std::vector<std::string_view> lines;       ///< below it, without comments; blank ones of /INTER
  std::optional<std::string_view> gap = {};  ///< a blank line between them
};

/// The blocks of a deck that matter for friction: /BEGIN, /FRICTION, /FRIC_ORIENT, /GRPART, /INTER,
/// /PARAMETER, /UNIT, and /PART, of which only the keyword is kept.
struct StarterDeck {
  import::DeckTexts texts;
  std::vector<DeckBlock> blocks;
  base::NamedNumbers parameters = {};  ///< of /PARAMETER, which fields name as &name
  bool has_includes = false;           ///< other files belong to it, which cannot be read
  bool has_submodels = false;          ///< some ids count from an offset, which is not added
};

/// Splits a deck into blocks; a block ends at the next line that begins with '/', the deck at /END
/// or at its end. Lines that begin with '#' or '$' are comments. Bytes that are no text (NUL and
/// other control characters) are an error; titles may be in any encoding. Files it includes are
/// looked for in `folder`; one that cannot be read is a warning.
StarterDeck split_deck(const base::SourceText& source, const std::string& folder,
                       base::Diagnostics& out);

/// The id behind a keyword, /GRPART/PART/id or /FRICTION/id: word `index` as an integer of at least
/// 1; 0 if there is none.
int id_of(const DeckBlock& block, std::size_t index);

}  // namespace slipbench::driver::radioss
