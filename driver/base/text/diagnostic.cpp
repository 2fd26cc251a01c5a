// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/diagnostic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "driver/base/text/source_text.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::base {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::size_t kWindow = 100;

std::string_view word_for(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      break;
  }
  return "note";
}

bool is_harmful(std::uint32_t c) {
  const bool control = c < 0x20 || (c >= 0x7F && c <= 0x9F);
  const bool line_break = c == 0x2028 || c == 0x2029;
  const bool bidirectional = c == 0x061C || (c >= 0x200E && c <= 0x200F) ||
                             (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  const bool no_character = c == 0xFFFE || c == 0xFFFF;  // which XML forbids
  return control || line_break || bidirectional || c == 0xFEFF || no_character;
}

// The first byte after `count` code points.
std::size_t byte_offset(std::string_view text, std::size_t count) {
  std::size_t offset = 0;
  for (; count > 0 && offset < text.size(); --count) {
    offset += decode_utf8(text.substr(offset)).length;
  }
  return offset;
}

struct Excerpt {
  std::string text{};
  std::size_t caret = 0;
  std::size_t length = 1;
};

// The part of a line that is shown, and where the caret stands in it (in code points from 0).
Excerpt excerpt_of(std::string_view line, const SourcePosition& where) {
  const std::size_t wanted = where.column > 0 ? static_cast<std::size_t>(where.column) - 1 : 0;
  const std::size_t before = std::min(wanted, count_code_points(line));
  const std::size_t first = before > kWindow / 2 ? before - kWindow / 2 : 0;
  // Only the window is decoded: a line may be as long as the file.
  const std::size_t begin = byte_offset(line, first);
  std::string_view rest = line.substr(begin);
  const std::size_t end = byte_offset(rest, kWindow);
  const bool whole = first == 0 && end == rest.size();
  const bool short_start = before <= kWindow / 2;
  Excerpt result;
  result.text = printable(rest.substr(0, end));
  const std::size_t shown = count_code_points(rest.substr(0, end));
  result.caret = std::min(before - first, shown);
  result.length = static_cast<std::size_t>(std::max(1, where.length));
  result.length =
      std::clamp<std::size_t>(result.length, 1, std::max<std::size_t>(1, shown - result.caret));
  if (!whole) {
    if (!short_start) {
      result.text = "..." + result.text;
      result.caret += 3;
    }
    if (end < rest.size()) result.text += "...";
  }
  return result;
}

/// Tells whether a spreadsheet takes a cell that begins with it for a formula.
bool begins_formula(char c) { return std::string_view("=+-@").find(c) != std::string_view::npos; }

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  const std::size_t added = ++counts_[static_cast<std::size_t>(diagnostic.severity)];
  if (added <= kMaxKept) kept_.push_back(std::move(diagnostic));
}

void Diagnostics::error(std::string_view file, SourcePosition where, std::string path,
                        std::string message, std::string hint) {
  add({Severity::kError, std::string(file), where, std::move(path), std::move(message),
       std::move(hint)});
}

void Diagnostics::warning(std::string_view file, SourcePosition where, std::string path,
                          std::string message, std::string hint) {
  add({Severity::kWarning, std::string(file), where, std::move(path), std::move(message),
       std::move(hint)});
}

void Diagnostics::note(std::string_view file, SourcePosition where, std::string path,
                       std::string message, std::string hint) {
  add({Severity::kNote, std::string(file), where, std::move(path), std::move(message),
       std::move(hint)});
}

void Diagnostics::append(const Diagnostics& other) {
  std::array<std::size_t, 3> unseen = other.counts_;
  for (const Diagnostic& diagnostic : other.kept_) {
    add(diagnostic);
    --unseen[static_cast<std::size_t>(diagnostic.severity)];
  }
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += unseen[i];
}

bool Diagnostics::empty() const {
  return std::all_of(counts_.begin(), counts_.end(), [](std::size_t n) { return n == 0; });
}

std::size_t Diagnostics::count(Severity severity) const {
  return counts_[static_cast<std::size_t>(severity)];
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<std::string_view> files;
  const auto rank = [&](std::string_view file) {
    return std::find(files.begin(), files.end(), file) - files.begin();
  };
  for (const Diagnostic& diagnostic : kept_) {
    if (rank(diagnostic.file) == std::ssize(files)) files.push_back(diagnostic.file);
  }
  std::vector<Diagnostic> result = kept_;
  std::stable_sort(result.begin(), result.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(rank(a.file), a.where.line, a.where.column) <
           std::tuple(rank(b.file), b.where.line, b.where.column);
  });
  return result;
}

std::string render(const Diagnostic& diagnostic, const SourceText* source) {
  const SourcePosition& where = diagnostic.where;
  std::string head;
  if (!diagnostic.file.empty()) head += printable(diagnostic.file) + ":";
  if (where.line > 0) head += fmt::format("{}:{}:", where.line, where.column);
  if (!head.empty()) head += " ";
  head += fmt::format("{}: ", word_for(diagnostic.severity));
  if (!diagnostic.path.empty()) head += printable(diagnostic.path) + ": ";
  head += printable(diagnostic.message);
  if (!diagnostic.hint.empty()) head += "; " + printable(diagnostic.hint);
  head += "\n";
  if (source == nullptr || where.line < 1 || where.line > source->line_count()) return head;

  const Excerpt excerpt = excerpt_of(source->line(where.line), where);
  head += fmt::format("{:>5} | {}\n", where.line, excerpt.text);
  head += fmt::format("{:>5} | {}^{}\n", "", std::string(excerpt.caret, ' '),
                      std::string(excerpt.length - 1, '~'));
  return head;
}

std::string render(const Diagnostics& diagnostics, std::span<const SourceText> sources) {
  std::string result;
  std::array<std::size_t, 3> shown{};
  for (const Diagnostic& diagnostic : diagnostics.sorted()) {
    std::size_t& already = shown[static_cast<std::size_t>(diagnostic.severity)];
    if (already == Diagnostics::kMaxShown) continue;
    ++already;
    const auto source = std::find_if(sources.begin(), sources.end(), [&](const SourceText& text) {
      return text.name() == diagnostic.file;
    });
    result += render(diagnostic, source == sources.end() ? nullptr : &*source);
  }
  for (const Severity severity : {Severity::kError, Severity::kWarning, Severity::kNote}) {
    const std::size_t hidden =
        diagnostics.count(severity) - shown[static_cast<std::size_t>(severity)];
    if (hidden > 0) {
      result +=
          fmt::format("... and {} more {}{}\n", hidden, word_for(severity), hidden == 1 ? "" : "s");
    }
  }
  return result;
}

std::string summary(const Diagnostics& diagnostics) {
  std::string result;
  for (const Severity severity : {Severity::kError, Severity::kWarning}) {
    const std::size_t count = diagnostics.count(severity);
    if (count == 0) continue;
    if (!result.empty()) result += ", ";
    result += fmt::format("{} {}{}", count, word_for(severity), count == 1 ? "" : "s");
  }
  return result;
}

std::optional<std::string_view> nearest_name(std::string_view word,
                                             std::span<const std::string_view> candidates) {
  // A word longer than any name has no near one, and the distance is quadratic in its length.
  constexpr std::size_t kLongestWord = 100;
  if (word.empty() || word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  for (const std::string_view candidate : candidates_among(word, candidates)) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    const std::size_t allowed = longer / 3;
    // Letters that one of the two has more are as many differences at least.
    if (longer - shorter > allowed) continue;
    const std::size_t d = name_distance(word, candidate);
    if (d <= allowed && (!nearest || d < least)) {
      nearest = candidate;
      least = d;
    }
  }
  return nearest;
}

std::string in_words(std::span<const std::string_view> names, std::string_view conjunction) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) result += i + 1 == names.size() ? fmt::format(" {} ", conjunction) : ", ";
    result += names[i];
  }
  return result;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    // Plain characters and colours stay; the rest is printed as a part of a line is.
    const auto plain = [](char c) { return (c >= ' ' && c < 0x7F) || c == '\n' || c == '\t'; };
    auto end =
        static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), plain) - text.begin());
    if (text.substr(end).starts_with("\033[")) {
      const std::size_t last = text.find_first_not_of("0123456789;", end + 2);
      if (last != text.npos && text[last] == 'm') end = last + 1;
    }
    result += text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t length = text.empty() ? 0 : decode_utf8(text).length;
    result += printable(text.substr(0, length));
    text.remove_prefix(length);
  }
  return result;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const CodePoint c = decode_utf8(text);
    if (c.valid && c.value == '\t') {
      result += ' ';
    } else if (!c.valid || is_harmful(c.value)) {
      result += kReplacement;
    } else {
      result += text.substr(0, c.length);
    }
    text.remove_prefix(c.length);
  }
  return result;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return printable(text);
  return printable(whole_characters(text, most)) + "...";
}

std::string in_cell(std::string_view name) {
  const bool guarded = !name.empty() && begins_formula(name.front());
  return (guarded ? "'" : "") + std::string(name);
}

std::string out_of_cell(std::string_view name) {
  const bool guarded = name.size() > 1 && name.front() == '\'' && begins_formula(name[1]);
  return std::string(name.substr(guarded ? 1 : 0));
}

std::string in_cells(std::string_view text) {
  std::string result;
  bool begins_cell = false;
  for (const char c : text) {
    if (begins_cell && begins_formula(c)) result += '\'';
    result += c;
    begins_cell = c == ',' || c == ';' || (begins_cell && c == '"');
  }
  return result;
}

std::string out_of_cells(std::string_view text) {
  std::string result;
  bool begins_cell = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool guards =
        begins_cell && c == '\'' && i + 1 < text.size() && begins_formula(text[i + 1]);
    if (!guards) result += c;
    begins_cell = c == ',' || c == ';' || (begins_cell && c == '"');
  }
  return result;
}

}  // namespace slipbench::driver::base
