// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/parse.hpp"

#include <fmt/core.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <memory>
#include <streambuf>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "driver/yaml/layout_scan.hpp"

namespace slipbench::driver::yaml {
namespace {

using detail::NodeRecord;
using detail::TreeData;

// Text for the YAML library: the source with each row of numbers cut down to "[]", which makes
// long tables several times faster, and the way back from its offsets to those of the source.
class Feed {
 public:
  Feed(std::string_view text, std::vector<NumberRow> rows) : rows_(std::move(rows)) {
    if (rows_.empty()) {
      whole_ = text;
      return;
    }
    std::size_t from = 0;
    opens_.reserve(rows_.size());
    for (const NumberRow& row : rows_) {
      shortened_ += text.substr(from, row.open - from);
      opens_.push_back(shortened_.size());
      shortened_ += '[';
      from = row.close;
    }
    shortened_ += text.substr(from);
  }

  [[nodiscard]] std::string_view text() const { return rows_.empty() ? whole_ : shortened_; }

  [[nodiscard]] std::size_t source_offset(std::size_t offset) const {
    // The last row that opens before this offset says how much was left out.
    const auto after = std::lower_bound(opens_.begin(), opens_.end(), offset);
    if (after == opens_.begin()) return offset;
    const auto last = static_cast<std::size_t>(after - opens_.begin()) - 1;
    return rows_[last].close + (offset - opens_[last] - 1);
  }

  // The row whose "[" is at this offset of the fed text.
  [[nodiscard]] const NumberRow* row_at(std::size_t offset) const {
    const auto found = std::lower_bound(opens_.begin(), opens_.end(), offset);
    if (found == opens_.end() || *found != offset) return nullptr;
    return &rows_[static_cast<std::size_t>(found - opens_.begin())];
  }

  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }

 private:
  std::vector<NumberRow> rows_;
  std::vector<std::size_t> opens_{};
  std::string shortened_{};
  std::string_view whole_{};
};

// Lets a stream read a text in place.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* const begin = const_cast<char*>(text.data());  // streambuf's interface; only read
    setg(begin, begin, begin + text.size());
  }
};

// Thrown through the YAML library when going on would be useless or dangerous.
struct StopReading {};

bool ends_word(std::string_view rest, std::size_t length) {
  return rest.size() <= length || rest.find_first_of(" \n\t,]}", length) == length;
}

// Returns how many bytes of a spelled-out null stand here; 0 if none does, or if it is a key.
std::size_t null_word_length(std::string_view rest) {
  for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
    if (!rest.starts_with(word) || !ends_word(rest, word.size())) continue;
    const std::size_t next = rest.find_first_not_of(' ', word.size());
    const bool is_key = next != std::string_view::npos && rest[next] == ':';
    return is_key ? 0 : word.size();
  }
  return 0;
}

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const base::SourceText& source, const Feed& feed)
      : source_(source), text_(source.text()), feed_(feed), data_{source} {}

  base::Diagnostics& found() { return found_; }
  [[nodiscard]] std::size_t rows_met() const { return rows_met_; }
  [[nodiscard]] bool has_root() const { return has_root_; }
  TreeData take() { return std::move(data_); }
  [[nodiscard]] const NodeRecord& root() const { return data_.root; }

  [[nodiscard]] std::size_t offset_of(const YAML::Mark& mark) const {
    const std::size_t fed = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
    return std::min(feed_.source_offset(fed), text_.size());
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!has_root_) return;
    error(skip_space(offset_of(mark)), 1, {}, "this does not belong to what stands above",
          "one file holds one map; check the indentation");
    throw StopReading{};
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(null_record(offset_of(mark)), {1, 1}, anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const std::size_t offset = offset_of(mark);
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) {
      error(offset, alias_length(offset), current_path(),
            fmt::format("the alias '{}' stands inside what it stands for", alias_at(offset)));
      add(scalar_record(offset, 0), {1, 1}, 0, true);
      return;
    }
    const Anchored& target = known->second;
    expanded_ += target.extent.nodes;
    expanded_text_ += target.extent.text;
    // A file that is longer itself means to do more.
    const std::size_t most_text = kAliasText + 2 * text_.size();
    if (expanded_ > kAliasBudget || expanded_text_ > most_text) {
      const bool values = expanded_ > kAliasBudget;
      error(offset, alias_length(offset), current_path(),
            fmt::format("the aliases of this file stand for more than {} {}",
                        values ? kAliasBudget : most_text,
                        values ? "values" : "characters of long texts"));
      throw StopReading{};
    }
    if (frames_.size() + target.extent.height - 1 > kDeepestNesting) stop_at_depth(offset);
    NodeRecord record = target.record;
    record.offset = narrow(offset);
    if (record.marks_key) record = {0, 0, narrow(offset), NodeKind::kNull, false, false, false};
    add(record, target.extent, 0, true);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const std::size_t offset = after_properties(offset_of(mark));
    NodeRecord record = scalar_record(offset, value.size());
    record.quoted = tag == "!";
    if (record.quoted || text_.substr(offset, value.size()) != value) {
      // A quoted text without escapes still is a part of the source.
      // A tag '!' at the end of the source, which is refused, has nothing behind it.
      const bool verbatim = record.quoted && offset < text_.size() &&
                            text_.substr(offset + 1, value.size()) == value &&
                            (text_[offset] == '"' || text_[offset] == '\'');
      record.decoded = !verbatim;
      record.begin = narrow(verbatim ? offset + 1 : data_.decoded_text.size());
      if (!verbatim) data_.decoded_text += value;
    }
    constexpr std::size_t kLongestNumber = 32;
    add(record, {1, 1, value.size() > kLongestNumber ? value.size() : 0}, anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    const std::size_t fed = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
    const bool flow = style == YAML::EmitterStyle::Flow;
    open(offset_of(mark), NodeKind::kSequence, anchor, flow);
    if (!flow) return;
    const NumberRow* row = feed_.row_at(fed);
    if (row == nullptr) row = feed_.row_at(fed_after_properties(fed));
    if (row == nullptr) return;
    ++rows_met_;
    for (NumberRange n = next_number(text_, *row, row->open); n.length > 0;
         n = next_number(text_, *row, n.begin + n.length)) {
      pending_.push_back(scalar_record(n.begin, n.length));
      ++frames_.back().extent.nodes;
    }
    frames_.back().extent.height = 2;
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(offset_of(mark), NodeKind::kMap, anchor, style == YAML::EmitterStyle::Flow);
  }
  void OnMapEnd() override {
    report_duplicates(frames_.size() - 1);
    close();
  }

  // For maps that will not be finished because reading has stopped.
  void report_open_duplicates() {
    for (std::size_t i = 0; i < frames_.size(); ++i) report_duplicates(i);
  }

  void error(std::size_t offset, std::size_t length, std::string path, std::string message,
             std::string hint = {}) {
    // To find a place takes a walk through its line: not for messages that will not be shown.
    if (is_flooded()) return found_.add({});
    found_.error(source_.name(), source_.position(offset, length), std::move(path),
                 std::move(message), std::move(hint));
  }

  [[nodiscard]] bool is_flooded() const {
    return found_.count(base::Severity::kError) >= base::Diagnostics::kMaxKept;
  }

  [[nodiscard]] std::string current_path() const { return path_to(frames_.size()).text(); }

 private:
  struct Extent {
    std::size_t nodes = 1;   // with everything that aliases in it stand for
    std::size_t height = 1;  // 1 for a scalar
    std::size_t text = 0;    // characters of its long texts
  };
  struct Frame {
    NodeKind kind = NodeKind::kSequence;
    bool flow = false;
    std::size_t offset = 0;
    std::size_t first_pending = 0;
    YAML::anchor_t anchor = 0;
    Extent extent{};
  };
  struct Anchored {
    NodeRecord record{};
    Extent extent{};
  };

  // The source is smaller than 2^32 bytes, and each node takes at least one of them.
  static std::uint32_t narrow(std::size_t value) { return static_cast<std::uint32_t>(value); }

  static NodeRecord scalar_record(std::size_t offset, std::size_t length) {
    return {narrow(offset), narrow(length), narrow(offset), NodeKind::kScalar, false, false, false};
  }

  [[nodiscard]] std::size_t skip_space(std::size_t offset) const {
    return std::min(text_.find_first_not_of(" \n\t", offset), text_.size());
  }

  // The library's mark is at the anchor of a node that has one.
  [[nodiscard]] std::size_t after_properties(std::size_t offset) const {
    while (offset < text_.size() && (text_[offset] == '&' || text_[offset] == '!'))
      offset = skip_space(std::min(text_.find_first_of(" \n\t,[]{}", offset), text_.size()));
    return offset;
  }

  [[nodiscard]] std::size_t fed_after_properties(std::size_t offset) const {
    const std::string_view fed = feed_.text();
    while (offset < fed.size() && (fed[offset] == '&' || fed[offset] == '!')) {
      const std::size_t end = fed.find_first_of(" \n\t,[]{}", offset);
      offset = std::min(fed.find_first_not_of(" \n\t", std::min(end, fed.size())), fed.size());
    }
    return offset;
  }

  [[nodiscard]] std::size_t alias_length(std::size_t offset) const {
    return std::min(text_.find_first_of(" \n\t,[]{}", offset), text_.size()) - offset;
  }

  [[nodiscard]] std::string alias_at(std::size_t offset) const {
    return std::string(text_.substr(offset, alias_length(offset)));
  }

  [[nodiscard]] bool wants_key() const {
    const Frame& frame = frames_.back();
    return frame.kind == NodeKind::kMap && (pending_.size() - frame.first_pending) % 2 == 0;
  }

  [[nodiscard]] std::string_view text_of(const NodeRecord& record) const {
    const std::string_view from = record.decoded ? std::string_view(data_.decoded_text) : text_;
    return from.substr(record.begin, record.count);
  }

  // The path of the element that is being read in frame `depth` - 1, as far as it will be shown:
  // its keys may be long.
  [[nodiscard]] Path path_to(std::size_t depth) const {
    Path path;
    if (is_flooded()) return path;
    for (std::size_t i = 0; i < depth; ++i) {
      const Frame& frame = frames_[i];
      const std::size_t end = pending_end(i);
      const std::size_t elements = end - frame.first_pending;
      if (frame.kind == NodeKind::kSequence) {
        path = path / elements;
      } else if (elements % 2 == 1 && pending_[end - 1].kind == NodeKind::kScalar) {
        path = path / text_of(pending_[end - 1]);
      }
    }
    return path;
  }

  // A null is spelled out, or it is an absence: then it is shown at its key or its dash.
  [[nodiscard]] NodeRecord null_record(std::size_t offset) const {
    NodeRecord record = scalar_record(offset, 0);
    record.kind = NodeKind::kNull;
    const std::size_t word = after_properties(offset);
    const std::size_t length = null_word_length(text_.substr(word));
    if (length > 0) {
      record.begin = record.offset = narrow(word);
      record.count = narrow(length);
    } else if (!frames_.empty() && frames_.back().kind == NodeKind::kMap && !wants_key()) {
      const NodeRecord& key = pending_.back();
      record.offset = key.offset;
      record.marks_key = true;
      record.count = narrow(key_end(key) - key.offset);
    } else if (!frames_.empty() && !frames_.back().flow) {
      record.offset = narrow(dash_before(offset));
    }
    return record;
  }

  // The last "-" before an offset, comments and empty lines passed over.
  [[nodiscard]] std::size_t dash_before(std::size_t offset) const {
    std::size_t end = offset;
    while (end > 0) {
      const std::size_t feed = text_.rfind('\n', end - 1);
      const std::size_t begin = feed == std::string_view::npos ? 0 : feed + 1;
      std::string_view line = text_.substr(begin, end - begin);
      if (const std::size_t comment = std::min(line.find(" #"), line.find('#'));
          comment != std::string_view::npos) {
        line = line.substr(0, comment);
      }
      const std::size_t last = line.find_last_not_of(" \t\n");
      if (last != std::string_view::npos) return line[last] == '-' ? begin + last : offset;
      if (begin == 0) break;
      end = feed;
    }
    return offset;
  }

  // Where a key ends in the source, its closing quote included.
  [[nodiscard]] std::size_t key_end(const NodeRecord& key) const {
    if (!key.decoded) return key.begin + key.count + (key.quoted ? 1U : 0U);
    return key.offset + (key.quoted ? detail::quoted_length(text_.substr(key.offset)) : 1);
  }

  void open(std::size_t offset, NodeKind kind, YAML::anchor_t anchor, bool flow) {
    const std::size_t begin = after_properties(offset);
    if (frames_.size() >= kDeepestNesting) stop_at_depth(begin);
    frames_.push_back({kind, flow, begin, pending_.size(), anchor, {}});
  }

  [[noreturn]] void stop_at_depth(std::size_t offset) {
    // The path would be as unreadable as the file.
    error(offset, 1, {}, fmt::format("nested deeper than {}", kDeepestNesting));
    throw StopReading{};
  }

  // Moves the children of the innermost list or map to their final, consecutive places.
  void close() {
    const Frame frame = frames_.back();
    const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(frame.first_pending);
    NodeRecord record;
    record.begin = narrow(data_.records.size());
    record.count = narrow(pending_.size() - frame.first_pending);
    record.offset = narrow(frame.offset);
    record.kind = frame.kind;
    data_.records.insert(data_.records.end(), first, pending_.end());
    pending_.erase(first, pending_.end());
    frames_.pop_back();
    add(record, frame.extent, frame.anchor);
  }

  void add(const NodeRecord& record, Extent extent, YAML::anchor_t anchor, bool is_alias = false) {
    if (anchor != 0) anchors_[anchor] = {record, extent};
    if (frames_.empty()) {
      data_.root = record;
      has_root_ = true;
      return;
    }
    if (wants_key()) {
      check_key(record, is_alias);
    } else {
      check_value(record);
    }
    pending_.push_back(record);
    Extent& own = frames_.back().extent;
    own.nodes += extent.nodes;
    own.height = std::max(own.height, extent.height + 1);
    own.text += extent.text;
  }

  void check_key(const NodeRecord& key, bool is_alias) {
    const auto path = [&] { return path_to(frames_.size() - 1).text(); };
    if (is_alias) {
      error(key.offset, alias_length(key.offset), path(), "an alias cannot be a key");
    } else if (key.kind == NodeKind::kNull && key.count == 0 &&
               text_.substr(key.offset).starts_with(',')) {
      // The library reports both halves of ", ,": said once is enough.
      error(key.offset, 1, path(), "nothing stands before this ','");
    } else if (key.kind == NodeKind::kNull && key.count == 0 &&
               text_.substr(key.offset).starts_with(':')) {
      error(key.offset, 1, path(), "nothing stands before this ':'", "a key is wanted");
    } else if (key.kind != NodeKind::kScalar) {
      error(key.offset, 1, path(),
            fmt::format("{} cannot be a key",
                        key.kind == NodeKind::kNull ? "a null" : name_of(key.kind)),
            "write a word");
    } else if (!key.quoted && text_of(key) == "<<") {
      error(key.offset, 2, path(), "the merge key '<<' is not accepted", "write the keys out");
    }
  }

  void check_value(const NodeRecord& value) {
    if (value.kind != NodeKind::kNull) return;
    const Frame& frame = frames_.back();
    if (frame.kind == NodeKind::kSequence) {
      if (frame.flow && value.count == 0 && !text_.substr(value.offset).starts_with('&'))
        error(value.offset, 1, current_path(), "nothing stands before this ','");
      return;
    }
    const NodeRecord& key = pending_.back();
    if (!value.marks_key || key.kind != NodeKind::kScalar) return;
    const std::size_t end = key_end(key);
    const std::size_t next = text_.find_first_not_of(' ', end);
    if (next != std::string_view::npos && text_[next] == ':') return;
    error(key.offset, end - key.offset, path_to(frames_.size() - 1).text(),
          fmt::format("missing ':' after '{}'", text_of(key)), split_number(key.offset));
  }

  /// Explains "0,2" between braces: there its comma ends the 0. Empty if it is not that.
  [[nodiscard]] std::string split_number(std::size_t offset) const {
    const auto is_digit = [&](std::size_t at) { return text_[at] >= '0' && text_[at] <= '9'; };
    if (offset < 2 || text_[offset - 1] != ',' || !is_digit(offset - 2) || !is_digit(offset)) {
      return {};
    }
    return "',' ends the number before it: the decimal mark is '.'";
  }

  // Where the finished children of frame i end.
  [[nodiscard]] std::size_t pending_end(std::size_t i) const {
    return i + 1 < frames_.size() ? frames_[i + 1].first_pending : pending_.size();
  }

  void report_duplicates(std::size_t index) {
    if (frames_[index].kind != NodeKind::kMap) return;
    std::vector<std::size_t> keys;
    for (std::size_t i = frames_[index].first_pending; i < pending_end(index); i += 2) {
      if (pending_[i].kind == NodeKind::kScalar) keys.push_back(i);
    }
    std::stable_sort(keys.begin(), keys.end(), [&](std::size_t a, std::size_t b) {
      return text_of(pending_[a]) < text_of(pending_[b]);
    });
    for (std::size_t i = 1, first = 0; i < keys.size(); ++i) {
      const NodeRecord& key = pending_[keys[i]];
      if (text_of(key) != text_of(pending_[keys[first]])) {
        first = i;
        continue;
      }
      if (is_flooded()) return;
      const int line = source_.position(pending_[keys[first]].offset).line;
      const Path path = path_to(index) / text_of(key);
      error(key.offset, key_end(key) - key.offset, path.text(),
            fmt::format("duplicate key, first given in line {}", line));
    }
  }

  const base::SourceText& source_;
  std::string_view text_;
  const Feed& feed_;
  TreeData data_;
  base::Diagnostics found_{};
  bool has_root_ = false;
  std::vector<Frame> frames_{};
  // Finished nodes whose parents are still open.
  std::vector<NodeRecord> pending_{};
  std::unordered_map<YAML::anchor_t, Anchored> anchors_{};
  std::size_t expanded_ = 0;
  std::size_t expanded_text_ = 0;
  std::size_t rows_met_ = 0;
};

struct Said {
  std::string message{};
  std::string hint{};
  std::size_t length = 1;
};

// Returns what the library's exceptions mean for the text of a case.
Said in_plain_words(const std::string& message, std::string_view text, std::size_t offset) {
  namespace Msg = YAML::ErrorMsg;
  const std::string_view rest = text.substr(std::min(offset, text.size()));
  const std::size_t line_begin = text.substr(0, offset).rfind('\n') + 1;
  const std::string_view before = text.substr(line_begin, offset - line_begin);
  const auto is = [&](const char* known) { return message == known; };

  if (is(Msg::UNKNOWN_ANCHOR)) {
    const std::size_t end = std::min(rest.find_first_of(" \n\t,[]{}"), rest.size());
    const std::string_view name =
        rest.substr(std::min<std::size_t>(1, end), end - std::min<std::size_t>(1, end));
    return {fmt::format("the alias '*{}' is not defined", name),
            fmt::format("'&{}' must stand before it", name), std::max<std::size_t>(1, end)};
  }
  if (is(Msg::MAP_VALUE) || is(Msg::MAP_KEY)) {
    if (before.find(": ") != std::string_view::npos)
      return {"a second ':' in one line", "put a text that holds ': ' in quotes"};
    return {"a ':' cannot stand here", "check the indentation"};
  }
  if (is(Msg::END_OF_MAP) || is(Msg::END_OF_SEQ))
    return {"this does not continue what stands above", "check the indentation"};
  if (is(Msg::END_OF_MAP_FLOW)) return {"',' or '}' is wanted before this", {}};
  if (is(Msg::END_OF_SEQ_FLOW)) return {"',' or ']' is wanted before this", {}};
  if (is(Msg::BLOCK_ENTRY))
    return {"a list's '- ' cannot stand here", "begin it on a line of its own"};
  if (is(Msg::FLOW_END)) return {"this bracket closes nothing", {}};
  if (is(Msg::UNKNOWN_TOKEN))
    return {fmt::format("'{}' cannot begin a text", rest.substr(0, 1)), "put the text in quotes"};
  if (message.starts_with(Msg::INVALID_ESCAPE) || is(Msg::INVALID_HEX) ||
      message.starts_with(Msg::INVALID_UNICODE)) {
    return {"unknown escape in a quoted text", "in single quotes a backslash is only a backslash"};
  }
  if (is(Msg::EOF_IN_SCALAR) || is(Msg::DOC_IN_SCALAR)) return {"a quote is not closed", {}};
  if (is(Msg::TAB_IN_INDENTATION)) return {"tab in the indentation", "indent with blanks"};
  return {fmt::format("not understood as YAML: {}", message), {}};
}

// True for complaints that follow from a text that was cut off.
bool follows_from_cut(const std::string& message) {
  namespace Msg = YAML::ErrorMsg;
  return message == Msg::END_OF_MAP || message == Msg::END_OF_SEQ ||
         message == Msg::END_OF_MAP_FLOW || message == Msg::END_OF_SEQ_FLOW ||
         message == Msg::EOF_IN_SCALAR;
}

// Runs the library over the feed; what it finds ends up in the builder.
void run_library(const Feed& feed, std::string_view source_text, bool cut, TreeBuilder& builder) {
  ViewBuffer buffer(feed.text());
  std::istream stream(&buffer);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const StopReading&) {
    // The builder has said why.
    builder.report_open_duplicates();
  } catch (const YAML::Exception& problem) {
    builder.report_open_duplicates();
    const std::size_t offset = builder.offset_of(problem.mark);
    if (cut && (follows_from_cut(problem.msg) || offset >= source_text.size())) return;
    Said said = in_plain_words(problem.msg, source_text, offset);
    builder.error(offset, said.length, {}, std::move(said.message), std::move(said.hint));
  }
}

void check_root(const base::SourceText& source, TreeBuilder& builder) {
  const std::string_view text = source.text();
  const NodeRecord& root = builder.root();
  if (!builder.has_root()) {
    builder.error(0, 1, {}, "the file is empty", "nothing but blanks and comments is in it");
  } else if (root.kind == NodeKind::kNull) {
    builder.error(root.offset, 1, {}, "a map ('key: value') is wanted, this is null");
  } else if (root.kind == NodeKind::kSequence) {
    builder.error(root.offset, 1, {}, "a map ('key: value') is wanted, this is a list");
  } else if (root.kind == NodeKind::kScalar) {
    const std::size_t end = std::min(text.find('\n', root.offset), text.size());
    builder.error(root.offset, end - root.offset, {},
                  "a map ('key: value') is wanted, this is a text",
                  text.substr(root.offset, end - root.offset).find(':') == std::string_view::npos
                      ? "a ':' and a blank stand after a key"
                      : "a blank stands after the ':' of a key");
  }
}

}  // namespace

tl::expected<Tree, base::Diagnostics> parse_yaml(const base::SourceText& source) {
  base::Diagnostics found = base::check_text(source);
  std::string_view text = source.text();
  if (text.size() > std::numeric_limits<std::int32_t>::max())
    found.error(source.name(), source.position(0), {}, "the text is larger than 2 GiB");
  if (found.has_errors()) return tl::make_unexpected(std::move(found));

  Layout layout = scan_layout(text, kDeepestNesting);
  for (const LayoutSlip& slip : layout.slips)
    found.error(source.name(), source.position(slip.offset, slip.length), {}, slip.message,
                slip.hint);

  // Behind a broken structure nothing can be said for sure: the library reads up to its line.
  const bool cut = layout.first_break < text.size();
  if (cut) {
    text = text.substr(0, text.substr(0, layout.first_break).rfind('\n') + 1);
    std::erase_if(layout.rows, [&](const NumberRow& row) { return row.close >= text.size(); });
  }
  const Feed feed(text, std::move(layout.rows));
  auto builder = std::make_unique<TreeBuilder>(source, feed);
  run_library(feed, text, cut, *builder);
  const Feed whole(text, {});
  if (!builder->found().has_errors() && !cut && builder->rows_met() != feed.row_count()) {
    // A bracket that looked like a row was a part of a text: once more, without the short cut.
    builder = std::make_unique<TreeBuilder>(source, whole);
    run_library(whole, text, cut, *builder);
  }
  if (!cut && !builder->found().has_errors() && !found.has_errors()) check_root(source, *builder);
  found.append(builder->found());
  if (found.has_errors()) return tl::make_unexpected(std::move(found));

  TreeData data = builder->take();
  builder.reset();
  return Tree(std::make_shared<const TreeData>(std::move(data)));
}

}  // namespace slipbench::driver::yaml
