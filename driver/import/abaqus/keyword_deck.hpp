// SPDX-License-Identifier: Apache-2.0
// An Abaqus input deck as keywords with their data lines, through all files that it includes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/import/deck_texts.hpp"

namespace slipbench::driver::abaqus {

/// NAME=value of a keyword line; texts are views into the deck, without blanks at their ends.
struct Parameter {
  std::string_view name;  ///< as the list of keywords has it
  std::optional<std::string_view> value = std::nullopt;
  std::string_view where;  ///< in the deck
};

/// Lines `first` .. `end` - 1 of a file.
struct LineRange {
  std::size_t file = 0;
  int first = 0;
  int end = 0;
};

/// Keyword with the lines below it, up to the next one. Parameters are there only of keywords that
/// are read (keyword_list.hpp).
struct Block {
  std::string_view keyword;  ///< as the list has it; as the deck has it where it is unknown
  std::string_view where;    ///< in the deck
  std::vector<Parameter> parameters = {};
  std::vector<LineRange> data = {};  ///< with comments and blank lines; several across files
  std::string_view name = {};  ///< of a comment "** Name: .." before it, as Abaqus/CAE writes it

  const Parameter* find(std::string_view wanted) const;
  bool has(std::string_view wanted) const { return find(wanted) != nullptr; }
  /// The value of a parameter; empty where it has none, or is not there.
  std::string value_of(std::string_view wanted) const;
};

/// Item of a data line or a value of a parameter: a number or a label.
using Items = std::vector<std::string_view>;

/// Deck, in memory as its bytes and an index of its keywords: the mesh costs no more.
class KeywordDeck {
 public:
  /// Reads a deck and the files it includes, which are looked for in its folder. What is wrong is
  /// reported with file, line and column; what a keyword that is not read has in it is not judged.
  /// \return nothing if the deck itself cannot be read; `environment_failure` tells on which side
  ///         the fault is
  static std::optional<KeywordDeck> read(const std::string& path, base::Diagnostics& out,
                                         bool& environment_failure, bool allow_outside = false);

  /// The same from a text in memory.
  static KeywordDeck read_text(base::SourceText text, const import::DeckFolder& folder,
                               base::Diagnostics& out);

  const std::vector<Block>& blocks() const { return blocks_; }
  /// The texts of all files, the deck's first.
  std::vector<base::SourceText> sources() const { return files_.all(); }

  /// Calls with each data line of a block that is neither blank nor a comment.
  void for_each_line(const Block& block, const std::function<void(std::string_view)>& take) const;
  /// The data lines of a block, each as its items; empty ones are kept.
  std::vector<Items> lines(const Block& block) const;

  /// Reads a number: `1.`, `.35`, `1.5D-3`, or `<name>` of *PARAMETER. Errors: a sentence.
  tl::expected<double, std::string> number(std::string_view item) const;
  /// The same of a whole number; `otherwise` where it is none.
  long whole(std::string_view item, long otherwise) const;

  /// Adds a message on a piece of the deck.
  void error(std::string_view piece, const Block& block, std::string message,
             std::string hint = {}) const;
  void warning(std::string_view piece, const Block& block, std::string message,
               std::string hint = {}) const;
  /// "file:12", where a piece stands.
  std::string place(std::string_view piece) const { return files_.place(piece); }

 private:
  KeywordDeck(base::Diagnostics& out, import::OpenFiles open_files)
      : open_files_(std::move(open_files)), out_(&out) {}
  void scan(std::size_t file, bool is_first);
  void begin_block(std::size_t file, int& line);
  void include(const Block& block);
  void read_parameters(const Block& block);

  import::DeckTexts files_;
  std::vector<Block> blocks_;
  base::NamedNumbers numbers_;  ///< of *PARAMETER, by their names in small letters
  import::OpenFiles open_files_;
  base::Diagnostics* out_;
};

/// Splits a line at its commas, those in quotes left alone, and takes blanks off the ends of items.
/// A comma at the end ends the last item, it begins no new one.
Items split_items(std::string_view line);

/// Returns a label as it is compared: without blanks and in capitals, or what is in its quotes.
std::string label_of(std::string_view item);

/// Returns a label as people know it: without quotes.
std::string shown(std::string_view item);

}  // namespace slipbench::driver::abaqus
