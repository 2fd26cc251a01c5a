// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>

#include "driver/base/text/number.hpp"

namespace slipbench::driver::base {
namespace {

enum class Progress { kUntouched, kOpen, kDone, kFailed };

/// One parameter on its way to a value.
struct Entry {
  const ParameterText* source = nullptr;  ///< The definition that counts: the last override.
  std::size_t index = 0;
  bool in_override = false;
  bool misnamed = false;  ///< So that it has no value for others.
  Progress progress = Progress::kUntouched;
  double value = 0.0;
  std::optional<Expression> expression;
  std::vector<std::size_t> uses;  ///< The entries its expression mentions.
};

/// Places of parameters among all, by their names.
using IndexByName = std::unordered_map<std::string_view, std::size_t>;

/// Depth-first evaluation on a stack of its own, so that a chain of any length is no danger.
class Resolver {
 public:
  Resolver(std::vector<Entry> entries, const std::vector<std::string>& names,
           const IndexByName& places, std::vector<ParameterError>& errors)
      : entries_(std::move(entries)), names_(names), places_(places), errors_(errors) {}

  void resolve_all() {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].progress == Progress::kUntouched) resolve(i);
    }
  }

  const std::vector<Entry>& entries() const { return entries_; }
  static bool has_value(const Entry& entry) {
    return entry.progress == Progress::kDone && !entry.misnamed;
  }

 private:
  struct Frame {
    std::size_t entry;
    std::size_t next_use = 0;
  };

  void resolve(std::size_t root) {
    open(root);
    while (!stack_.empty()) {
      Frame& frame = stack_.back();
      Entry& entry = entries_[frame.entry];
      if (entry.progress == Progress::kOpen && frame.next_use < entry.uses.size()) {
        const std::size_t used = entry.uses[frame.next_use++];
        if (entries_[used].progress == Progress::kUntouched) {
          open(used);
        } else if (entries_[used].progress == Progress::kOpen) {
          report_circle(used);
        }
        continue;
      }
      if (entry.progress == Progress::kOpen) evaluate(entry);
      stack_.pop_back();
    }
  }

  void open(std::size_t index) {
    stack_.push_back({index});
    Entry& entry = entries_[index];
    entry.progress = Progress::kOpen;
    if (const double* number = std::get_if<double>(&entry.source->value)) {
      if (std::isfinite(*number)) {
        entry.value = *number;
        entry.progress = Progress::kDone;
      } else {
        fail(entry,
             {fmt::format("the value of '{}' is not a finite number", entry.source->name), -1, {}});
      }
      return;
    }
    auto expression = Expression::compile(std::get<std::string>(entry.source->value), names_);
    if (!expression) {
      fail(entry, std::move(expression.error()));
      return;
    }
    for (const std::string& name : expression->used_variables()) {
      entry.uses.push_back(places_.at(name));
    }
    entry.expression = std::move(*expression);
  }

  void evaluate(Entry& entry) {
    values_.assign(names_.size(), 0.0);
    for (const std::size_t used : entry.uses) {
      if (!has_value(entries_[used])) {
        entry.progress = Progress::kFailed;
        return;
      }
      values_[used] = entries_[used].value;
    }
    auto value = (*entry.expression)(values_);
    if (!value) {
      fail(entry, std::move(value.error()));
      return;
    }
    entry.value = *value;
    entry.progress = Progress::kDone;
  }

  /// The circle is the part of the stack from `first` to its top.
  void report_circle(std::size_t first) {
    const auto begin = std::find_if(stack_.begin(), stack_.end(),
                                    [&](const Frame& frame) { return frame.entry == first; });
    std::string circle;
    for (auto it = begin; it != stack_.end(); ++it) {
      circle += entries_[it->entry].source->name + " -> ";
      entries_[it->entry].progress = Progress::kFailed;
    }
    circle += entries_[first].source->name;
    fail(entries_[first], {fmt::format("parameters define each other: {}", circle), -1, {}});
  }

  void fail(Entry& entry, ExpressionError error) {
    entry.progress = Progress::kFailed;
    errors_.push_back({entry.index, entry.in_override, false, std::move(error)});
  }

  std::vector<Entry> entries_;
  const std::vector<std::string>& names_;
  const IndexByName& places_;
  std::vector<ParameterError>& errors_;
  std::vector<Frame> stack_;
  std::vector<double> values_;
};

std::optional<ExpressionError> name_violation(const std::string& name) {
  if (!is_identifier(name)) {
    return ExpressionError{
        fmt::format("'{}' cannot name a parameter: a name is a letter or '_', then letters, digits "
                    "and '_'",
                    name),
        -1,
        {}};
  }
  if (is_reserved_name(name)) {
    return ExpressionError{
        fmt::format("'{}' cannot name a parameter: expressions give it a meaning of its own", name),
        -1,
        {}};
  }
  return std::nullopt;
}

}  // namespace

ResolvedParameters resolve_parameters(std::span<const ParameterText> parameters,
                                      std::span<const ParameterText> overrides) {
  ResolvedParameters resolved;
  std::vector<ParameterError>& errors = resolved.errors;
  std::vector<std::string> names;
  IndexByName places;
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name;
    // A badly named parameter is still known, so that its users are not reported as well.
    Entry entry;
    if (auto violation = name_violation(name)) {
      errors.push_back({i, false, true, std::move(*violation)});
      entry.misnamed = true;
    } else if (const auto first = places.find(name); first != places.end()) {
      entries[first->second].misnamed = true;
      errors.push_back(
          {i, false, true, {fmt::format("parameter '{}' is defined twice", name), -1, {}}});
      continue;
    }
    entry.source = &parameters[i];
    entry.index = i;
    places.try_emplace(name, names.size());
    names.push_back(name);
    entries.push_back(std::move(entry));
  }
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const auto it = places.find(overrides[i].name);
    if (it == places.end()) {
      errors.push_back(
          {i,
           true,
           true,
           {fmt::format("there is no parameter '{}'", overrides[i].name), -1, overrides[i].name}});
      continue;
    }
    Entry& entry = entries[it->second];
    entry.source = &overrides[i];
    entry.index = i;
    entry.in_override = true;
  }

  Resolver resolver(std::move(entries), names, places, errors);
  resolver.resolve_all();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Entry& entry = resolver.entries()[i];
    if (Resolver::has_value(entry)) resolved.values.emplace(names[i], entry.value);
  }
  return resolved;
}

tl::expected<std::vector<ParameterText>, std::string> parse_settings(
    std::span<const std::string> settings) {
  std::vector<ParameterText> all;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size()) {
      return tl::unexpected(
          fmt::format("--set {}: wanted name=value, for example --set mu=0.2", setting));
    }
    ParameterText text{setting.substr(0, equals), setting.substr(equals + 1)};
    if (const auto number = parse_number(std::get<std::string>(text.value))) text.value = *number;
    all.push_back(std::move(text));
  }
  return all;
}

}  // namespace slipbench::driver::base
