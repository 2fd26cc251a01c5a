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

/// Submodel whose numbers count from offsets of their own: //SUBMODEL .. //ENDSUB.
struct Submodel {
  int offset = 0;       ///< off_def: of groups, interfaces, /FRICTION
  int part_offset = 0;  ///< off_part, off_def if that is 0
  int unit_id = 0;      ///< its system of units; negative: that of its own /BEGIN, 0: the deck's
  int version = 0;      ///< of its cards; 0: the deck's
};

/// A keyword with the lines up to the next one. Texts are views into the deck's source.
struct DeckBlock {
  std::vector<std::string> words;            ///< of "/FRICTION/7/2": FRICTION, 7, 2, in capitals
  std::string_view keyword;                  ///< the line as it is, without blanks at its end
  std::vector<std::string_view> lines;       ///< below it, without comments; blank ones of /INTER
  std::optional<std::string_view> gap = {};  ///< a blank line between them
  Submodel submodel = {};                    ///< that it is in
};

/// The blocks of a deck that matter for friction: /BEGIN, /FRICTION, /FRIC_ORIENT, /GRPART, /INTER,
/// /PARAMETER, /UNIT, and /PART, of which only the keyword is kept.
struct StarterDeck {
  import::DeckTexts texts;
  std::vector<DeckBlock> blocks;
  base::NamedNumbers parameters = {};  ///< of /PARAMETER, which fields name as &name
  bool has_includes = false;           ///< other files belong to it, which cannot be read
};

/// Splits a deck into blocks; a block ends at the next line that begins with '/', the deck at /END
/// or at its end. Lines that begin with '#' or '$' are comments. Bytes that are no text (NUL and
/// other control characters) are an error; titles may be in any encoding. Files it includes are
/// looked for in `folder`; one that cannot be read is a warning, one outside of it an error.
StarterDeck split_deck(const base::SourceText& source, const import::DeckFolder& folder,
                       base::Diagnostics& out);

/// The id behind a keyword, /GRPART/PART/id or /FRICTION/id: word `index` as an integer of at least
/// 1; 0 if there is none.
int id_of(const DeckBlock& block, std::size_t index);

/// A word as an integer of at least 1; else 0.
int integer_in(std::string_view word);

/// An id as the whole deck counts it, at most the largest int; none stays none.
int with_offset(int id, int offset);

}  // namespace slipbench::driver::radioss
