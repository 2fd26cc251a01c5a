// SPDX-License-Identifier: Apache-2.0
// Messages to the user that know their place, collected rather than thrown.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::base {

class SourceText;

/// Weight of a message; only errors stop a command.
enum class Severity { kError, kWarning, kNote };

/// A place in a text. Lines and columns count from 1, columns and length in code points, so that a
/// caret stands under the right character of a UTF-8 line; line 0 means "no place".
struct SourcePosition {
  int line = 0;
  int column = 0;
  int length = 1;

  friend bool operator==(const SourcePosition&, const SourcePosition&) = default;
};

/// One message: "file:line:column: severity: path: message; hint". `path` is the key's path in the
/// document ("friction[0].coefficient"); file, path and hint may be empty.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file{};
  SourcePosition where{};
  std::string path{};
  std::string message{};
  std::string hint{};
};

/// A list of messages that is filled while reading goes on. It keeps at most kMaxKept messages of
/// each severity (later ones are only counted), so a flood costs no memory.
class Diagnostics {
 public:
  static constexpr std::size_t kMaxKept = 200;
  static constexpr std::size_t kMaxShown = 20;

  /// Adds a message as it is.
  void add(Diagnostic diagnostic);
  /// Adds an error, a warning or a note from its parts.
  void error(std::string_view file, SourcePosition where, std::string path, std::string message,
             std::string hint = {});
  void warning(std::string_view file, SourcePosition where, std::string path, std::string message,
               std::string hint = {});
  void note(std::string_view file, SourcePosition where, std::string path, std::string message,
            std::string hint = {});
  /// Adds all messages of another list, and its count of those not kept.
  void append(const Diagnostics& other);

  /// Tells whether at least one error was added.
  [[nodiscard]] bool has_errors() const { return count(Severity::kError) > 0; }
  /// Tells whether nothing was added.
  [[nodiscard]] bool empty() const;
  /// Returns how many messages of this severity were added, kept or not.
  [[nodiscard]] std::size_t count(Severity severity) const;
  /// The kept messages by file (in order of appearance) and position; equal places keep the order
  /// in which they were added, messages without a place come first in their file.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

 private:
  std::vector<Diagnostic> kept_;
  std::array<std::size_t, 3> counts_{};
};

/// One message in compiler style, ending with a line feed. With the source text of its file the
/// line and a caret follow:
///   shock.yaml:9:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?
///       9 |     coeficient: 0.15
///         |     ^~~~~~~~~~
/// A long line is cut around the caret; control characters never reach the terminal.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, const SourceText* source = nullptr);

/// All messages in order, at most Diagnostics::kMaxShown of each severity; what is left out is
/// counted ("... and 12 more errors"). `sources` are the texts that lines may be quoted from.
[[nodiscard]] std::string render(const Diagnostics& diagnostics,
                                 std::span<const SourceText> sources = {});

/// "2 errors", "1 error, 3 warnings"; empty if there are neither (notes are not counted).
[[nodiscard]] std::string summary(const Diagnostics& diagnostics);

/// The candidate that a mistyped word probably meant: least optimal-string-alignment distance
/// (insert, delete, replace, swap of neighbours), blind to case and to '-' against '_'; nothing if
/// even the nearest differs in more than a third of the word. Ties go to the earlier candidate.
[[nodiscard]] std::optional<std::string_view> nearest_name(
    std::string_view word, std::span<const std::string_view> candidates);

/// "a", "a or b", "a, b or c"; with `conjunction` "and": "a, b and c". Empty for no names.
[[nodiscard]] std::string in_words(std::span<const std::string_view> names,
                                   std::string_view conjunction = "or");

/// The text with every character that could harm a terminal (control characters, bidirectional
/// overrides, bytes that are no UTF-8) shown as U+FFFD and each tab as one blank: as many code
/// points out as in.
[[nodiscard]] std::string printable(std::string_view text);
/// The same of text of many lines: line feeds, tabs, and the sequences that colour it, stay.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// The text as printable() has it, cut behind at most `most` bytes, which "..." then says.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// The name of a column with an apostrophe before it if it begins with =, +, - or an at sign: a
/// spreadsheet would take it for a formula.
[[nodiscard]] std::string in_cell(std::string_view name);
/// The name that in_cell was given.
[[nodiscard]] std::string out_of_cell(std::string_view name);

/// Lines of a CSV file with an apostrophe before each =, +, - and at sign that begins a cell,
/// quoted or not: behind a comma or a semicolon.
[[nodiscard]] std::string in_cells(std::string_view text);
/// The lines that in_cells was given.
[[nodiscard]] std::string out_of_cells(std::string_view text);

}  // namespace slipbench::driver::base
