// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/node.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace slipbench::driver::yaml {
namespace {

bool is_plain_word(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '<' || (static_cast<unsigned char>(c) & 0x80U) != 0;
  });
}

}  // namespace

namespace detail {

std::size_t quoted_length(std::string_view rest) {
  // A tag "!" alone is a quoted text to the library, and has none.
  if (rest.empty()) return 0;
  const char quote = rest.front();
  for (std::size_t i = 1; i < rest.size() && rest[i] != '\n'; ++i) {
    if (quote == '"' && rest[i] == '\\') {
      ++i;
    } else if (rest[i] == quote) {
      const bool doubled = quote == '\'' && i + 1 < rest.size() && rest[i + 1] == quote;
      if (!doubled) return i + 1;
      ++i;
    }
  }
  return std::min(rest.find('\n'), rest.size());
}

}  // namespace detail

std::string_view name_of(NodeKind kind) {
  switch (kind) {
    case NodeKind::kNull:
      return "nothing";
    case NodeKind::kScalar:
      return "a text";
    case NodeKind::kSequence:
      return "a list";
    case NodeKind::kMap:
      break;
  }
  return "a map";
}

std::string_view Node::text() const {
  const bool has_text = kind() == NodeKind::kScalar || kind() == NodeKind::kNull;
  if (!has_text || record_->marks_key) return {};
  const std::string_view from =
      record_->decoded ? std::string_view(tree_->decoded_text) : tree_->source.text();
  return from.substr(record_->begin, record_->count);
}

std::size_t Node::size() const {
  if (is_sequence()) return record_->count;
  return is_map() ? record_->count / 2 : 0;
}

Node Node::operator[](std::size_t i) const { return {tree_, child(is_map() ? 2 * i + 1 : i)}; }

Entry Node::entry(std::size_t i) const {
  return {Node(tree_, child(2 * i)), Node(tree_, child(2 * i + 1))};
}

std::optional<Node> Node::find(std::string_view key) const {
  if (!is_map()) return std::nullopt;
  for (std::size_t i = 0; i < size(); ++i) {
    if (entry(i).key.text() == key) return entry(i).value;
  }
  return std::nullopt;
}

NodeRange<Node> Node::items() const { return NodeRange<Node>(*this); }

NodeRange<Entry> Node::entries() const { return NodeRange<Entry>(*this); }

base::SourcePosition Node::where() const {
  const std::string_view text = tree_->source.text();
  const std::size_t offset = std::min<std::size_t>(record_->offset, text.size());
  const std::string_view rest = text.substr(offset);
  if (rest.empty()) return tree_->source.position(offset);
  std::size_t length = 1;
  if (rest.front() == '*') {
    length = std::min(rest.find_first_of(" \t\n,[]{}"), rest.size());
  } else if (record_->marks_key) {
    length = record_->count;
  } else if (rest.front() == '"' || rest.front() == '\'') {
    length = detail::quoted_length(rest);
  } else if (is_scalar() && !quoted()) {
    // The first line of a plain text that goes on over several, as it is written.
    length = record_->decoded ? rest.find('\n') : record_->count;
  }
  return tree_->source.position(offset, std::max<std::size_t>(1, length));
}

Path Path::operator/(std::string_view key) const {
  Path result = *this;
  if (!result.text_.empty()) result.text_ += '.';
  result.text_ += is_plain_word(key) ? std::string(key) : fmt::format("'{}'", key);
  return result;
}

Path Path::operator/(std::size_t index) const {
  Path result = *this;
  result.text_ += fmt::format("[{}]", index);
  return result;
}

}  // namespace slipbench::driver::yaml
