// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/text_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::calibrate {
namespace {

struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text;
};

std::size_t offset_of(const yaml::Node& node) {
  const base::SourceText& source = node.source();
  const base::SourcePosition where = node.where();
  std::string_view rest = source.line(where.line);
  if (rest.empty()) return 0;
  std::size_t offset = static_cast<std::size_t>(rest.data() - source.text().data());
  for (int column = 1; column < where.column && !rest.empty(); ++column) {
    const std::size_t length = base::decode_utf8(rest).length;
    rest.remove_prefix(length);
    offset += length;
  }
  return offset;
}

std::string_view rest_of(const yaml::Node& node) {
  return node.source().text().substr(offset_of(node));
}

/// A plain scalar cannot begin with a '*'.
bool is_alias(const yaml::Node& node) {
  const std::string_view rest = rest_of(node);
  return !rest.empty() && rest.front() == '*';
}

std::size_t bytes_of(std::string_view text, int code_points) {
  std::size_t bytes = 0;
  for (int i = 0; i < code_points && bytes < text.size(); ++i) {
    bytes += base::decode_utf8(text.substr(bytes)).length;
  }
  return bytes;
}

/// Bytes of a key or a value on its line; nothing if it goes on over more.
std::optional<std::size_t> scalar_length(const yaml::Node& node) {
  const std::string_view rest = rest_of(node);
  if (rest.empty()) return std::nullopt;
  const char first = rest.front();
  if (first == '"' || first == '\'') {
    const std::size_t length = yaml::detail::quoted_length(rest);
    const bool closed = length > 1 && rest[length - 1] == first;
    return closed ? std::optional(length) : std::nullopt;
  }
  const std::string_view text = node.text();
  if (node.quoted() || !rest.starts_with(text)) return std::nullopt;
  return text.size();
}

/// A value that was left empty is shown at its key: it goes behind the ':'.
Edit insertion(const yaml::Node& node, const std::string& text) {
  const std::string_view source = node.source().text();
  const std::size_t key = offset_of(node);
  const std::size_t end = key + bytes_of(source.substr(key), node.where().length);
  return {std::min(source.find(':', end), source.size() - 1) + 1, 0, " " + text};
}

/// In one line, for a place whose indentation is another one.
std::string joined_lines(std::string_view text) {
  std::string joined;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\n') {
      joined += text[i];
      continue;
    }
    joined += ' ';
    while (i + 1 < text.size() && text[i + 1] == ' ') ++i;
  }
  return joined;
}

const NodeChange* child_of(const NodeChange* change, std::size_t index) {
  if (change == nullptr) return nullptr;
  const auto found = change->children.find(index);
  return found == change->children.end() ? nullptr : &found->second;
}

void append_flow(const yaml::Node& node, const NodeChange* change, std::string& out) {
  if (change != nullptr && change->text) {
    out += joined_lines(*change->text);
  } else if (node.is_null()) {
    out += "null";
  } else if (node.is_scalar()) {
    out += yaml_scalar(node.text(), node.quoted());
  } else if (node.is_sequence()) {
    out += '[';
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i > 0) out += ", ";
      append_flow(node[i], child_of(change, i), out);
    }
    out += ']';
  } else {
    out += '{';
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i > 0) out += ", ";
      const NodeChange* below = child_of(change, i);
      const yaml::Node key = node.entry(i).key;
      out += below != nullptr && below->key ? yaml_scalar(*below->key)
                                            : yaml_scalar(key.text(), key.quoted());
      out += ": ";
      append_flow(node[i], below, out);
    }
    out += '}';
  }
}

/// Collects what is to be written over the text.
class Editor {
 public:
  explicit Editor(const yaml::Node& root)
      : may_have_aliases_(root.source().text().find('*') != std::string_view::npos) {}

  /// Collects the changes in the order of the text.
  void collect(const yaml::Node& node, const NodeChange* change) {
    if (change == nullptr && !may_have_aliases_) return;
    if (may_have_aliases_ && is_alias(node)) {
      aliases_.emplace_back(node, change);
      return;
    }
    if (change != nullptr && change->text) return replace(node, *change->text);
    for (std::size_t i = 0; i < node.size(); ++i) {
      const NodeChange* below = child_of(change, i);
      if (node.is_map() && below != nullptr && below->key) {
        replace(node.entry(i).key, yaml_scalar(*below->key));
      }
      collect(node[i], below);
    }
  }

  /// Aliases that change, or whose anchor does.
  void expand_aliases() {
    for (const auto& [node, change] : aliases_) {
      const bool changes = change != nullptr && !change->empty();
      if (!changes && (edits_.empty() || !is_touched(node, true))) continue;
      std::string text;
      append_flow(node, change, text);
      const std::size_t end = rest_of(node).find_first_of(" \t\n,[]{}");
      edits_.push_back({offset_of(node), std::min(end, rest_of(node).size()), std::move(text)});
    }
  }

  [[nodiscard]] const std::string& fault() const { return fault_; }

  [[nodiscard]] std::string apply(std::string_view text) {
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.offset < b.offset; });
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits_) {
      result.append(text.substr(at, edit.offset - at));
      result += edit.text;
      at = edit.offset + edit.length;
    }
    result.append(text.substr(at));
    return result;
  }

 private:
  void replace(const yaml::Node& node, const std::string& text) {
    if (node.is_null() && node.text().empty()) {
      edits_.push_back(insertion(node, text));
      touched_.insert(offset_of(node));
      return;
    }
    const auto length = scalar_length(node);
    if (!length) {
      if (fault_.empty()) {
        fault_ = fmt::format(
            "line {}: a value over several lines cannot be replaced; write it in one line",
            node.where().line);
      }
      return;
    }
    edits_.push_back({offset_of(node), *length, text});
    touched_.insert(offset_of(node));
  }

  /// Tells whether something that an alias stands for is replaced where its anchor is.
  [[nodiscard]] bool is_touched(const yaml::Node& node, bool outermost = false) const {
    // The alias itself has its own place: of a scalar, the anchor's is that of its text.
    if (node.is_scalar() || node.is_null()) {
      return outermost ? scalar_touched(node) : touched_.contains(offset_of(node));
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (node.is_map() && touched_.contains(offset_of(node.entry(i).key))) return true;
      if (is_touched(node[i])) return true;
    }
    return false;
  }
  [[nodiscard]] bool scalar_touched(const yaml::Node& node) const {
    const std::string_view source = node.source().text();
    const std::string_view text = node.text();
    const bool inside = text.data() >= source.data() && text.data() < source.data() + source.size();
    if (!inside) return true;  // decoded: written out to be safe
    const auto offset = static_cast<std::size_t>(text.data() - source.data());
    return touched_.contains(offset) || (offset > 0 && touched_.contains(offset - 1));
  }

  bool may_have_aliases_;
  std::vector<std::pair<yaml::Node, const NodeChange*>> aliases_;
  std::vector<Edit> edits_;
  std::set<std::size_t> touched_;
  std::string fault_;
};

bool same(const yaml::Node& old_node, const yaml::Node& new_node, const NodeChange* change) {
  if (change != nullptr && change->text) {
    if (new_node.is_scalar() && new_node.text() == *change->text) return true;
    const auto wanted =
        yaml::parse_yaml(base::SourceText("", "value: " + joined_lines(*change->text) + "\n"));
    return wanted && same((*wanted).root()[0], new_node, nullptr);
  }
  if (old_node.kind() != new_node.kind() || old_node.size() != new_node.size()) return false;
  if (old_node.is_scalar() && old_node.text() != new_node.text()) return false;
  for (std::size_t i = 0; i < old_node.size(); ++i) {
    const NodeChange* below = child_of(change, i);
    if (old_node.is_map()) {
      const std::string_view wanted =
          below != nullptr && below->key ? *below->key : old_node.entry(i).key.text();
      if (new_node.entry(i).key.text() != wanted) return false;
    }
    if (!same(old_node[i], new_node[i], below)) return false;
  }
  return true;
}

}  // namespace

std::string yaml_scalar(std::string_view text, bool quoted) {
  const bool safe = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_.+-/").find(c) != std::string_view::npos;
  });
  const bool begins_well =
      safe && (std::isalnum(static_cast<unsigned char>(text.front())) != 0 ||
               std::string_view("_./").find(text.front()) != std::string_view::npos);
  const bool signed_number =
      safe && text.size() > 1 && (text.front() == '-' || text.front() == '+') &&
      (std::isdigit(static_cast<unsigned char>(text[1])) != 0 || text[1] == '.');
  return !quoted && (begins_well || signed_number) ? std::string(text)
                                                   : base::json::Value(text).dump();
}

tl::expected<std::string, std::string> with_changes(const yaml::Tree& tree,
                                                    const NodeChange& changes) {
  Editor editor(tree.root());
  editor.collect(tree.root(), &changes);
  if (!editor.fault().empty()) return tl::unexpected(editor.fault());
  editor.expand_aliases();
  std::string text = editor.apply(tree.source().text());
  const auto again = yaml::parse_yaml(base::SourceText(tree.source().name(), text));
  if (!again || !same(tree.root(), (*again).root(), &changes)) {
    return tl::unexpected(std::string("the text with the new numbers would not read back to them"));
  }
  return text;
}

}  // namespace slipbench::driver::calibrate
