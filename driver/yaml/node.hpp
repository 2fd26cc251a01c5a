// SPDX-License-Identifier: Apache-2.0
// A YAML file as an immutable tree that remembers where everything stood.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/source_text.hpp"

namespace slipbench::driver::yaml {

enum class NodeKind : std::uint8_t { kNull, kScalar, kSequence, kMap };

/// "nothing", "a text", "a list", "a map": the kind as messages name it.
[[nodiscard]] std::string_view name_of(NodeKind kind);

namespace detail {

/// One node in 16 bytes. The children of a list or map are consecutive records (a map's alternate
/// key, value); an alias is a copy of the record it stands for, with its own place.
struct NodeRecord {
  std::uint32_t begin = 0;   // first child, or first byte of the text
  std::uint32_t count = 0;   // children, or bytes of text
  std::uint32_t offset = 0;  // where it stands in the source
  NodeKind kind = NodeKind::kNull;
  bool quoted = false;
  bool decoded = false;    // the text lies in `decoded_text`, not in the source
  bool marks_key = false;  // an empty value, which is shown at its key
};

/// The bytes of a quoted text from its opening to its closing quote, at most to the line's end.
[[nodiscard]] std::size_t quoted_length(std::string_view rest);

struct TreeData {
  base::SourceText source;
  std::vector<NodeRecord> records{};
  NodeRecord root{};
  std::string decoded_text{};
};

}  // namespace detail

struct Entry;
template <class Element>
class NodeRange;

/// A cheap handle on one node (two pointers); valid as long as its Tree.
class Node {
 public:
  Node(const detail::TreeData* tree, const detail::NodeRecord* record)
      : tree_(tree), record_(record) {}

  [[nodiscard]] NodeKind kind() const { return record_->kind; }
  [[nodiscard]] bool is_null() const { return kind() == NodeKind::kNull; }
  [[nodiscard]] bool is_scalar() const { return kind() == NodeKind::kScalar; }
  [[nodiscard]] bool is_sequence() const { return kind() == NodeKind::kSequence; }
  [[nodiscard]] bool is_map() const { return kind() == NodeKind::kMap; }

  /// The text of a scalar, quotes and escapes resolved; of a null what was written ("~", "null" or
  /// nothing); empty for lists and maps.
  [[nodiscard]] std::string_view text() const;
  /// True for a scalar in quotes or a block text (| or >): a text even if it looks like a number.
  [[nodiscard]] bool quoted() const { return record_->quoted; }

  /// Items of a list, entries of a map, 0 otherwise.
  [[nodiscard]] std::size_t size() const;
  /// Item i of a list, value i of a map; i < size().
  [[nodiscard]] Node operator[](std::size_t i) const;
  /// Entry i of a map; i < size().
  [[nodiscard]] Entry entry(std::size_t i) const;
  /// The value of a key; nothing if this is no map or has no such key.
  [[nodiscard]] std::optional<Node> find(std::string_view key) const;
  /// For loops: the items of a list (or values of a map), the entries of a map.
  [[nodiscard]] NodeRange<Node> items() const;
  [[nodiscard]] NodeRange<Entry> entries() const;

  /// The place of the node: a scalar's text, a list's or map's beginning, an alias itself rather
  /// than what it stands for, the key of a value that was left empty.
  [[nodiscard]] base::SourcePosition where() const;
  [[nodiscard]] const base::SourceText& source() const { return tree_->source; }

 private:
  [[nodiscard]] const detail::NodeRecord* child(std::size_t i) const {
    return tree_->records.data() + record_->begin + i;
  }

  const detail::TreeData* tree_;
  const detail::NodeRecord* record_;
};

/// A key of a map and its value; `key` is always a scalar.
struct Entry {
  Node key;
  Node value;
};

/// The elements of a list or map, for range-based loops.
template <class Element>
class NodeRange {
 public:
  class Iterator {
   public:
    Iterator(Node owner, std::size_t index) : owner_(owner), index_(index) {}
    Element operator*() const;
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    Node owner_;
    std::size_t index_;
  };

  explicit NodeRange(Node owner) : owner_(owner) {}
  [[nodiscard]] Iterator begin() const { return {owner_, 0}; }
  [[nodiscard]] Iterator end() const { return {owner_, owner_.size()}; }

 private:
  Node owner_;
};

template <>
inline Node NodeRange<Node>::Iterator::operator*() const {
  return owner_[index_];
}

template <>
inline Entry NodeRange<Entry>::Iterator::operator*() const {
  return owner_.entry(index_);
}

/// Owns the nodes and, shared, the source they point into. Copies share everything.
class Tree {
 public:
  explicit Tree(std::shared_ptr<const detail::TreeData> data) : data_(std::move(data)) {}

  /// The outermost node; parse_yaml makes sure that it is a map.
  [[nodiscard]] Node root() const { return {data_.get(), &data_->root}; }
  [[nodiscard]] const base::SourceText& source() const { return data_->source; }

 private:
  std::shared_ptr<const detail::TreeData> data_;
};

/// The path of a key in a document, as messages show it: Path{} / "friction" / 0 / "coefficient" is
/// friction[0].coefficient. A key that is no plain word is shown in quotes: parameters.'my mu'.
class Path {
 public:
  Path() = default;
  [[nodiscard]] Path operator/(std::string_view key) const;
  [[nodiscard]] Path operator/(const char* key) const { return *this / std::string_view(key); }
  [[nodiscard]] Path operator/(std::size_t index) const;
  [[nodiscard]] Path operator/(int index) const { return *this / static_cast<std::size_t>(index); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_{};
};

}  // namespace slipbench::driver::yaml
