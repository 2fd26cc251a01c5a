// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/layout_scan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace slipbench::driver::yaml {
namespace {

// More slips than anyone mends in one go; each costs a walk through the text.
constexpr std::size_t kMostSlips = 200;
constexpr std::string_view kNoBreakSpace = "\xC2\xA0";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

bool is_flow_indicator(char c) { return c == ',' || c == '[' || c == ']' || c == '{' || c == '}'; }

bool is_number_character(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

class LayoutScanner {
 public:
  LayoutScanner(std::string_view text, int deepest)
      : text_(text), deepest_(static_cast<std::size_t>(deepest)) {}

  Layout scan() {
    while (at_ < text_.size() && !stopped_) {
      begin_line();
      scan_line();
      at_ = std::min(line_end_ + 1, text_.size());
    }
    if (!open_.empty() && !stopped_) report_unclosed(std::nullopt);
    report_tabs();
    return std::move(layout_);
  }

 private:
  struct Bracket {
    char character = '[';
    std::size_t offset = 0;
    std::size_t indent = 0;  // of the line it stands on
    bool after_key = false;  // "key: [", so that a new key must be indented deeper
  };

  void begin_line() {
    line_begin_ = at_;
    line_end_ = std::min(text_.find('\n', at_), text_.size());
    content_ = line_begin_;
    while (content_ < line_end_ && text_[content_] == ' ') ++content_;
  }

  [[nodiscard]] std::ptrdiff_t column(std::size_t offset) const {
    return static_cast<std::ptrdiff_t>(offset - line_begin_);
  }

  [[nodiscard]] bool in_flow() const { return !open_.empty(); }

  // True if the character after `offset` ends a one-letter indicator such as "- " or ": ".
  [[nodiscard]] bool blank_after(std::size_t offset) const {
    return offset + 1 >= text_.size() || is_blank(text_[offset + 1]) || text_[offset + 1] == '\n';
  }

  [[nodiscard]] std::size_t skip_blanks(std::size_t offset) const {
    while (offset < line_end_ && is_blank(text_[offset])) ++offset;
    return offset;
  }

  void slip(std::size_t offset, std::size_t length, std::string message, std::string hint = {}) {
    layout_.slips.push_back({offset, length, std::move(message), std::move(hint)});
    if (layout_.slips.size() >= kMostSlips) stopped_ = true;
  }

  void structural_slip(std::size_t offset, std::size_t length, std::string message,
                       std::string hint = {}) {
    layout_.first_break = std::min(layout_.first_break, offset);
    slip(offset, length, std::move(message), std::move(hint));
  }

  [[nodiscard]] int line_number(std::size_t offset) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(offset);
    return 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
  }

  void report_tabs() {
    if (tab_lines_ == 0) return;
    std::string hint = "indent with blanks";
    if (tab_lines_ > 1)
      hint += fmt::format(" ({} more line{})", tab_lines_ - 1, tab_lines_ == 2 ? "" : "s");
    structural_slip(first_tab_, 1, "tab in the indentation", std::move(hint));
  }

  // Gives up on the open brackets. After a quote that is not closed they may have been closed
  // where nothing was looked at, so nothing is said about them.
  void report_unclosed(std::optional<std::size_t> next_key) {
    const Bracket& innermost = open_.back();
    if (brackets_trusted_) {
      structural_slip(innermost.offset, 1, fmt::format("'{}' is not closed", innermost.character),
                      next_key ? fmt::format("line {} begins something new", line_number(*next_key))
                               : "the file ends before");
    }
    open_.clear();
    brackets_trusted_ = true;
  }

  // "word:" followed by a blank or the end of the line.
  [[nodiscard]] bool looks_like_key(std::size_t offset) const {
    std::size_t i = offset;
    const auto in_word = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '_' || c == '-';
    };
    while (i < line_end_ && in_word(text_[i])) ++i;
    return i > offset && i < line_end_ && text_[i] == ':' && blank_after(i);
  }

  [[nodiscard]] bool starts_document_marker(std::size_t offset) const {
    const std::string_view marker = text_.substr(offset, 3);
    return (marker == "---" || marker == "...") && blank_after(offset + 2);
  }

  // Indentation and whole-line matters; then the tokens of the line.
  void scan_line() {
    const std::size_t content = skip_blanks(content_);
    if (content == line_end_) return;
    if (text_[content] == '#') {
      plain_open_ = false;
      return;
    }
    if (content != content_) {
      if (++tab_lines_ == 1) first_tab_ = content_;
      plain_open_ = false;
      return;
    }
    if (text_.substr(content).starts_with(kNoBreakSpace)) {
      structural_slip(content, kNoBreakSpace.size(), "no-break space in the indentation",
                      "indent with blanks");
      plain_open_ = false;
      return;
    }
    at_ = content;
    if (at_ == line_begin_ && !scan_document_line()) return;
    const std::size_t indent = content - line_begin_;
    if (in_flow() && open_.front().after_key && indent <= open_.front().indent &&
        (looks_like_key(content) || (text_[content] == '-' && blank_after(content)))) {
      report_unclosed(content);
    }
    if (plain_open_ && (in_flow() || column(content) > parent_)) {
      if (!continue_plain()) scan_tokens();
      return;
    }
    plain_open_ = false;
    scan_tokens();
  }

  // Markers and directives at the very beginning of a line; false if the line is done.
  bool scan_document_line() {
    if (text_[at_] == '%' && !content_seen_ && !in_flow()) {
      slip(at_, line_end_ - at_, "directives are not accepted", "remove this line");
      return false;
    }
    const bool marker = starts_document_marker(at_);
    const bool begins_another = (marker && text_[at_] == '-' && (content_seen_ || marker_seen_));
    if (begins_another || (document_ended_ && !marker)) {
      structural_slip(at_, marker ? 3 : line_end_ - at_, "a second document begins here",
                      "one file holds one document");
      stopped_ = true;
      open_.clear();
      return false;
    }
    if (!marker) return true;
    if (in_flow()) report_unclosed(std::nullopt);
    plain_open_ = false;
    (text_[at_] == '-' ? marker_seen_ : document_ended_) = true;
    at_ += 3;
    return text_[at_ - 1] == '-';
  }

  void scan_tokens() {
    bool first = true;
    std::size_t line_of_tokens = line_begin_;
    while (!stopped_) {
      at_ = skip_blanks(at_);
      if (at_ >= line_end_) return;
      if (line_of_tokens != line_begin_) first = false;
      line_of_tokens = line_begin_;
      const char c = text_[at_];
      const bool after_blank = at_ == line_begin_ || is_blank(text_[at_ - 1]);
      if (c == '#' && after_blank) {
        at_ = line_end_;
        return;
      }
      content_seen_ = true;
      if (!in_flow() && (c == '-' || c == '?') && blank_after(at_)) {
        if (c == '?') slip(at_, 1, "an explicit key '?' is not accepted", "write 'key: value'");
        parent_ = key_column_ = column(at_);
        ++at_;
        continue;
      }
      if (first) first_column_ = column(at_);
      scan_token(c, first);
      // An anchor or a tag stands before the key or value that it belongs to.
      if (c != '&' && c != '!') first = false;
    }
  }

  void scan_token(char c, bool first) {
    switch (c) {
      case '[':
      case '{':
        open_bracket(c);
        return;
      case ']':
      case '}':
        close_bracket(c);
        return;
      case ',':
        if (!in_flow()) return scan_plain(first);
        ++at_;
        return;
      case ':':
        if (!in_flow() && !blank_after(at_)) return scan_plain(first);
        // After a key that is no plain word: a quoted text, or something that cannot be a key.
        if (!in_flow()) parent_ = key_column_ = first_column_;
        ++at_;
        return;
      case '"':
      case '\'':
        scan_quote(c, first);
        return;
      case '!': {
        const std::size_t end = word_end(at_);
        slip(at_, end - at_, fmt::format("the tag '{}' is not accepted", shown(at_, end)),
             "remove it");
        at_ = end;
        return;
      }
      case '&':
      case '*':
        at_ = word_end(at_);
        return;
      case '|':
      case '>':
        if (in_flow()) return scan_plain(first);
        skip_block_text();
        return;
      default:
        scan_plain(first);
    }
  }

  [[nodiscard]] std::size_t word_end(std::size_t offset) const {
    ++offset;
    while (offset < line_end_ && !is_blank(text_[offset]) && !is_flow_indicator(text_[offset]))
      ++offset;
    return offset;
  }

  [[nodiscard]] std::string shown(std::size_t begin, std::size_t end) const {
    constexpr std::size_t kLongest = 40;
    const std::string_view part = text_.substr(begin, end - begin);
    return part.size() <= kLongest ? std::string(part)
                                   : std::string(part.substr(0, kLongest)) + "...";
  }

  void open_bracket(char c) {
    if (c == '[' && collect_number_row()) return;
    if (open_.size() >= deepest_) {
      structural_slip(at_, 1, fmt::format("nested deeper than {}", deepest_));
      stopped_ = true;
      open_.clear();
      return;
    }
    open_.push_back({c, at_, content_ - line_begin_, at_ > content_});
    ++at_;
  }

  void close_bracket(char c) {
    const char wanted = c == ']' ? '[' : '{';
    const auto match = std::find_if(open_.rbegin(), open_.rend(), [&](const Bracket& bracket) {
      return bracket.character == wanted;
    });
    if (match == open_.rend()) {
      if (brackets_trusted_) structural_slip(at_, 1, fmt::format("'{}' without '{}'", c, wanted));
    } else {
      if (match != open_.rbegin() && brackets_trusted_) {
        structural_slip(open_.back().offset, 1,
                        fmt::format("'{}' is not closed", open_.back().character),
                        fmt::format("'{}' on line {} comes before", c, line_number(at_)));
      }
      open_.erase(match.base() - 1, open_.end());
    }
    if (open_.empty()) brackets_trusted_ = true;
    ++at_;
  }

  // A row of plain numbers is remembered and passed over at once.
  bool collect_number_row() {
    std::size_t i = skip_blanks(at_ + 1);
    for (;;) {
      const std::size_t begin = i;
      bool digit = false;
      while (i < line_end_ && is_number_character(text_[i])) {
        digit = digit || (text_[i] >= '0' && text_[i] <= '9');
        ++i;
      }
      if (!digit || text_[begin] == 'e' || text_[begin] == 'E') return false;
      i = skip_blanks(i);
      if (i >= line_end_) return false;
      if (text_[i] == ']') break;
      if (text_[i] != ',') return false;
      i = skip_blanks(i + 1);
    }
    layout_.rows.push_back({at_, i});
    at_ = i + 1;
    return true;
  }

  // Moves to the end of a plain scalar within the line; true if it ends before ": ".
  bool run_over_plain() {
    for (; at_ < line_end_; ++at_) {
      const char c = text_[at_];
      if (c == '#' && at_ > line_begin_ && is_blank(text_[at_ - 1])) return false;
      if (in_flow() && is_flow_indicator(c)) return false;
      if (c != ':') continue;
      const bool flow_value = in_flow() && at_ + 1 < line_end_ && is_flow_indicator(text_[at_ + 1]);
      if (blank_after(at_) || flow_value) return true;
    }
    return false;
  }

  [[nodiscard]] std::size_t trimmed_end(std::size_t begin) const {
    std::size_t end = at_;
    while (end > begin && is_blank(text_[end - 1])) --end;
    return end;
  }

  void scan_plain(bool first) {
    const std::size_t begin = at_;
    const bool is_key = run_over_plain();
    const std::size_t end = trimmed_end(begin);
    if (in_flow()) {
      check_cut_expression(begin, end);
    } else if (is_key && first) {
      after_open_quote_ = false;
      parent_ = key_column_ = column(begin);
    } else if (!is_key && first) {
      if (column(begin) <= key_column_) {
        report_missing_colon(begin, end);
        at_ = line_end_;
        return;
      }
      parent_ = key_column_;
    }
    plain_open_ = !is_key && at_ == line_end_;
    plain_begin_ = begin;
    plain_end_ = end;
    plain_first_ = first;
  }

  void report_missing_colon(std::size_t begin, std::size_t end) {
    if (after_open_quote_) return;
    const std::string_view words = text_.substr(begin, end - begin);
    const std::size_t colon = words.find(':');
    if (colon != std::string_view::npos && words.substr(colon + 1).starts_with(kNoBreakSpace)) {
      structural_slip(begin + colon + 1, kNoBreakSpace.size(),
                      "a no-break space (U+00A0) after ':'", "write a blank");
    } else if (colon != std::string_view::npos && colon > 0) {
      structural_slip(begin, end - begin, "missing blank after ':'",
                      fmt::format("write '{}: {}'", shown(begin, begin + colon),
                                  shown(begin + colon + 1, end)));
    } else {
      const std::size_t equals = words.find(" = ");
      structural_slip(begin, end - begin, fmt::format("missing ':' after '{}'", shown(begin, end)),
                      equals == std::string_view::npos
                          ? std::string()
                          : fmt::format("write '{}: {}'", shown(begin, begin + equals),
                                        shown(begin + equals + 3, end)));
    }
  }

  // The next line of a plain text. False if the line is not part of it after all (a slip, since it
  // holds a key), so that it is to be read on its own.
  bool continue_plain() {
    const std::size_t content = at_;
    const bool is_key = run_over_plain();
    if (is_key && !in_flow()) {
      if (plain_first_) {
        report_missing_colon(plain_begin_, plain_end_);
      } else {
        structural_slip(content, trimmed_end(content) - content,
                        fmt::format("'{}' stands below a value and is indented like a part of it",
                                    shown(content, at_)),
                        fmt::format("line {} already has the value '{}'; keys of one map stand "
                                    "in one column, items begin with '- '",
                                    line_number(plain_begin_), shown(plain_begin_, plain_end_)));
      }
      plain_open_ = false;
      at_ = content;
      return false;
    }
    plain_open_ = at_ == line_end_;
    if (at_ < line_end_) scan_tokens();
    return true;
  }

  // "[= max(a, b)]" is two entries to YAML, which is never meant.
  void check_cut_expression(std::size_t begin, std::size_t end) {
    if (text_[begin] != '=' || at_ >= line_end_ || text_[at_] != ',') return;
    const std::string_view words = text_.substr(begin, end - begin);
    if (std::count(words.begin(), words.end(), '(') <= std::count(words.begin(), words.end(), ')'))
      return;
    slip(begin, end - begin,
         fmt::format("the ',' cuts the expression '{}' in two", shown(begin, end)),
         "put the whole expression in quotes");
  }

  void scan_quote(char quote, bool first) {
    const std::size_t begin = at_;
    const std::size_t opening_line_end = line_end_;
    const std::ptrdiff_t key_place = column(begin);
    const std::ptrdiff_t parent =
        in_flow()
            ? (open_.front().after_key ? static_cast<std::ptrdiff_t>(open_.front().indent) : -1)
            : (first ? key_column_ : parent_);
    const std::optional<std::size_t> end = closing_quote(quote, parent);
    const std::size_t next = end ? skip_blanks(*end + 1) : 0;
    const bool several_lines = end && line_end_ != opening_line_end;
    if (!end || (several_lines && !may_follow_quote(*end + 1, next))) {
      structural_slip(begin, 1, fmt::format("the quote {} is not closed", quote),
                      "close it in this line, or indent the lines that belong to the text");
      line_end_ = opening_line_end;
      at_ = opening_line_end;
      brackets_trusted_ = !in_flow();
      after_open_quote_ = true;
      return;
    }
    at_ = *end + 1;
    if (!may_follow_quote(at_, next)) {
      structural_slip(next, line_end_ - next, "text after the closing quote",
                      quote == '"' ? "write a quote inside the text as \\\""
                                   : "write a quote inside the text as ''");
      at_ = line_end_;
      brackets_trusted_ = !in_flow();
      return;
    }
    const bool is_key = next < line_end_ && text_[next] == ':';
    if (is_key && !in_flow() && !blank_after(next)) {
      structural_slip(next, 1, "missing blank after ':'");
      at_ = line_end_;
      return;
    }
    if (is_key && !in_flow() && first) parent_ = key_column_ = key_place;
  }

  [[nodiscard]] bool may_follow_quote(std::size_t end, std::size_t next) const {
    if (next >= line_end_ || text_[next] == ':') return true;
    if (text_[next] == '#') return next > end;
    return in_flow() && (text_[next] == ',' || text_[next] == ']' || text_[next] == '}');
  }

  // The offset of the closing quote, with line_begin_ and line_end_ moved to its line.
  std::optional<std::size_t> closing_quote(char quote, std::ptrdiff_t parent) {
    std::size_t i = at_ + 1;
    for (;;) {
      for (; i < line_end_; ++i) {
        if (quote == '"' && text_[i] == '\\') {
          ++i;
        } else if (text_[i] == quote) {
          const bool doubled = quote == '\'' && i + 1 < line_end_ && text_[i + 1] == quote;
          if (!doubled) return i;
          ++i;
        }
      }
      if (line_end_ >= text_.size()) return std::nullopt;
      at_ = line_end_ + 1;
      begin_line();
      i = skip_blanks(line_begin_);
      const bool outdented = i < line_end_ && column(i) <= parent;
      if (outdented || starts_document_marker(line_begin_)) return std::nullopt;
    }
  }

  // After | or >: everything that is indented deeper than the key is text.
  void skip_block_text() {
    const std::ptrdiff_t parent = at_ == content_ ? key_column_ : parent_;
    for (;;) {
      at_ = line_end_;
      if (line_end_ >= text_.size()) return;
      const std::size_t next = line_end_ + 1;
      const std::size_t next_end = std::min(text_.find('\n', next), text_.size());
      std::size_t content = next;
      while (content < next_end && text_[content] == ' ') ++content;
      const bool belongs =
          content == next_end || static_cast<std::ptrdiff_t>(content - next) > parent;
      if (!belongs) return;
      line_begin_ = next;
      line_end_ = next_end;
    }
  }

  std::string_view text_;
  std::size_t deepest_;
  Layout layout_{};
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  std::size_t line_end_ = 0;
  std::size_t content_ = 0;  // the first character of the line that is no blank
  std::vector<Bracket> open_{};
  bool brackets_trusted_ = true;
  bool after_open_quote_ = false;  // until the next key, lines may be the rest of a text
  // Columns from 0: of the latest key or dash, and of the one whose value is being read.
  std::ptrdiff_t key_column_ = -1;
  std::ptrdiff_t parent_ = -1;
  std::ptrdiff_t first_column_ = 0;  // of the first token of the line, dashes not counted
  bool plain_open_ = false;
  bool plain_first_ = false;
  std::size_t plain_begin_ = 0;
  std::size_t plain_end_ = 0;
  bool content_seen_ = false;
  bool marker_seen_ = false;
  bool document_ended_ = false;
  bool stopped_ = false;
  std::size_t tab_lines_ = 0;
  std::size_t first_tab_ = 0;
};

}  // namespace

Layout scan_layout(std::string_view text, int deepest) {
  return LayoutScanner(text, deepest).scan();
}

NumberRange next_number(std::string_view text, const NumberRow& row, std::size_t offset) {
  std::size_t begin = std::max(offset, row.open + 1);
  while (begin < row.close && !is_number_character(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < row.close && is_number_character(text[end])) ++end;
  return {begin, end - begin};
}

}  // namespace slipbench::driver::yaml
