// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/binding.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <mutex>
#include <string>

#include "driver/base/files/data_path.hpp"
#include "driver/base/files/standard_input.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/in_quotes.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/base/units/carried_unit.hpp"

namespace slipbench::driver::yaml {
namespace {

/// "wanted a number: '010' has a leading zero; write 10", unless the reason says what is wanted.
std::string with_wanted(std::string_view wanted, const std::string& reason) {
  if (reason.find("wanted") != std::string::npos) return reason;
  return "wanted " + std::string(wanted) + ": " + reason;
}

/// An expression without its '=' and the blanks around it.
std::string_view bare(std::string_view expression) {
  const std::size_t first = expression.find_first_not_of("= ");
  if (first == std::string_view::npos) return {};
  return expression.substr(first, expression.find_last_not_of(' ') + 1 - first);
}

/// Returns whether a unit stands behind an expression: "= 2*R mm".
bool ends_with_unit(std::string_view expression) {
  const std::size_t blank = expression.find_last_of(' ');
  const std::size_t before = expression.find_last_not_of(' ', blank);
  if (blank == std::string_view::npos || before == std::string_view::npos) return false;
  const char last = expression[before];
  const bool complete = last == ')' || last == '_' || last == '.' ||
                        std::isalnum(static_cast<unsigned char>(last)) != 0;
  return complete && base::dimension_of_unit(expression.substr(blank + 1)).has_value();
}

/// The place inside a scalar that an expression's error means, if the scalar stands in one line.
base::SourcePosition inside(const Node& node, const base::ExpressionError& problem) {
  base::SourcePosition where = node.where();
  if (problem.offset < 0 || problem.offset >= where.length) return where;
  where.column += problem.offset + (node.quoted() ? 1 : 0);
  where.length = problem.unknown_name.empty() ? 1 : static_cast<int>(problem.unknown_name.size());
  return where;
}

}  // namespace

void Binder::error(const Node& at, const Path& path, std::string message, std::string hint) {
  out_.error(at.source().name(), at.where(), path.text(), std::move(message), std::move(hint));
}
void Binder::warning(const Node& at, const Path& path, std::string message, std::string hint) {
  out_.warning(at.source().name(), at.where(), path.text(), std::move(message), std::move(hint));
}
void Binder::note(const Node& at, const Path& path, std::string message, std::string hint) {
  out_.note(at.source().name(), at.where(), path.text(), std::move(message), std::move(hint));
}

void Binder::wrong_kind(const Node& node, const Path& path, std::string_view wanted) {
  std::string found(name_of(node.kind()));
  if (node.is_scalar()) found = base::in_quotes(node.text());
  std::string hint;
  if (wanted.starts_with("a list") && node.is_map()) hint = "each item of a list begins with '- '";
  const bool is_word = node.is_scalar() && !base::parse_number(node.text());
  if (wanted == "a map" && (node.is_sequence() || is_word)) hint = "a map is {key: value}";
  error(node, path, "wanted " + std::string(wanted) + ", found " + found, std::move(hint));
}

bool Binder::few_enough(const Node& items, const Path& path, std::size_t most) {
  if (items.size() <= most) return true;
  error(items, path, fmt::format("{} items, at most {} are read", items.size(), most));
  return false;
}

std::string_view default_text(double number) {
  if (number == 0.0) return "";
  static std::mutex mutex;  // cases are read side by side
  static std::map<double, std::string> texts;
  const std::lock_guard lock(mutex);
  return texts.try_emplace(number, base::format_number(number)).first->second;
}

void Binder::missing_key(const Node& map, const Path& path, std::string_view key,
                         std::string_view wanted) {
  // The first error that an empty file leads to.
  error(map, path, "missing key " + base::in_quotes(key) + " (" + std::string(wanted) + ")",
        key == "slipbench" ? "a case and a fit begin with 'slipbench: 1'" : "");
}

std::optional<std::string_view> Binder::unknown_key(const Node& key, const Path& path,
                                                    std::span<const std::string_view> allowed,
                                                    std::string_view known) {
  if (const auto later = words_.later_key(key.text())) {
    error(key, path, std::string(later->why));
    if (later->in_place_of.empty()) return std::nullopt;
    return later->in_place_of;
  }
  if (flooded()) {
    error(key, path, "unknown key");
    return std::nullopt;
  }
  std::string hint = known.empty() ? words_.other_name(key.text()) : std::string(known);
  const auto nearest = hint.empty() ? base::nearest_name(key.text(), allowed) : std::nullopt;
  if (nearest) {
    hint = "did you mean " + base::in_quotes(*nearest) + "?";
  } else if (hint.empty()) {
    const std::string places = words_.places_of_key(key.text());
    hint = places.empty() ? "known here: " + base::few_in_words(allowed)
                          : base::in_quotes(key.text()) + " belongs to " + places;
  }
  error(key, path, "unknown key", std::move(hint));
  return nearest;
}

bool Binder::is_expression(const Node& node) {
  if (!node.is_scalar()) return false;
  const std::string_view text = node.text();
  const std::size_t begin = text.find_first_not_of(' ');
  return begin != std::string_view::npos && text[begin] == '=';
}

/// Returns what to write in place of a function that is not known.
std::string Binder::known_functions(const std::string& name) const {
  if (name == "pow") return "a power is written 'a^b'";
  const std::vector<std::string_view> functions(base::function_names().begin(),
                                                base::function_names().end());
  return nearest_or(name, functions, "the functions are " + base::in_words(functions));
}

void Binder::expression_error(const Node& node, const Path& path,
                              const base::ExpressionError& problem,
                              const std::vector<std::string>& variables) {
  if (!problem.unknown_name.empty() && unknown_names_excused_) return;
  std::string hint;
  if (ends_with_unit(node.text())) {
    hint = "an expression has no unit: its result is in the case's units, angles in radians";
  } else if (problem.message.starts_with("unknown function")) {
    hint = known_functions(problem.unknown_name);
  } else if (base::is_reserved_name(problem.unknown_name)) {
    hint = "it is known in profiles and checks only, and no parameter can have its name";
  } else if (!problem.unknown_name.empty()) {
    std::vector<std::string_view> names(variables.begin(), variables.end());
    for (const auto& [name, value] : parameters_) names.push_back(name);
    names.insert(names.end(), unresolved_.begin(), unresolved_.end());
    // Only where result columns can be named.
    if (variables.size() > 1) hint = words_.origin_of_column(problem.unknown_name);
    if (hint.empty()) {
      hint = nearest_or(problem.unknown_name, names, std::string(words_.undefined_name));
    }
  }
  out_.error(node.source().name(), inside(node, problem), path.text(), problem.message,
             std::move(hint));
}

std::optional<base::Expression> Binder::expression(const Node& node, const Path& path,
                                                   const std::vector<std::string>& variables) {
  if (formulas_) {
    formulas_->push_back({path.text(), std::string(node.text()), variables.empty()});
  }
  auto compiled = base::Expression::compile(node.text(), variables, parameters_);
  if (compiled) return std::move(*compiled);
  // The fault of a parameter is reported where it stands, not where it is used.
  if (!unresolved_.contains(compiled.error().unknown_name)) {
    expression_error(node, path, compiled.error(), variables);
  }
  return std::nullopt;
}

bool Binder::is_foreign_unit(std::string_view unit) const {
  if (!units_) return false;
  bool differs = false;
  for (const base::Dimension& dimension :
       {base::kLength, base::kForce, base::kMoment, base::kTime, base::kTemperature, base::kAngle,
        base::Dimension{.length = 1, .time = -1}, base::Dimension{.time = -1, .angle = 1}}) {
    const auto found = base::conversion_to_case(unit, dimension, *units_);
    if (found && *found == base::UnitConversion{}) return false;
    differs = differs || found.has_value();
  }
  return differs;
}

const std::string& Binder::words_of(std::string key, const std::function<std::string()>& make) {
  const auto [known, is_new] = kept_words_.try_emplace(std::move(key));
  if (is_new) known->second = make();
  return known->second;
}

bool Binder::may_read(const Node& node, const Path& path, const std::filesystem::path& file,
                      std::uintmax_t effort) {
  constexpr std::uintmax_t kAlways = std::uintmax_t{64} << 20U;
  constexpr std::uintmax_t kTimes = 450;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (unknown) return true;
  read_ += effort * size;
  longest_read_ = std::max(longest_read_, size);
  if (read_ <= kAlways + kTimes * longest_read_) return true;
  error(node, path, "files of numbers are read again and again: too often for a case",
        path.text().starts_with("checks")
            ? "compare with a file in one format, and with few columns of one that lacks samples"
            : "drive the case by one 'history: {csv: ..}', or its steps by 'repeat'");
  return false;
}

std::optional<double> Binder::number_with_unit(const Node& node, const Path& path,
                                               const KeyInfo& info) {
  const bool is_declared = info.unit == UnitUse::kDeclared;
  if (is_declared && info.dimension == base::Dimension{}) {
    error(node, path, base::in_quotes(node.text()) + ": a number without a unit is wanted here");
    return std::nullopt;
  }
  if (!units_) {
    error(node, path,
          base::in_quotes(node.text()) + ": the cases of this file have different units",
          "write the number without a unit");
    return std::nullopt;
  }
  const auto read =
      base::read_with_unit(node.text(), is_declared ? std::optional(info.dimension) : std::nullopt,
                           *units_, info.difference);
  if (!read) {
    error(node, path, read.error());
    return std::nullopt;
  }
  if (info.unit == UnitUse::kAny && read->shifted) {
    note(node, path, base::shifted_in_words(node.text(), *read, *units_));
  }
  if (info.unit == UnitUse::kNone) {
    error(node, path, base::in_quotes(node.text()) + ": a number without a unit is wanted here",
          "in the case's units it is " + base::format_number(read->value));
    return std::nullopt;
  }
  if (info.unit == UnitUse::kSlip || info.unit == UnitUse::kQuantity) {
    unsettled_.emplace(path.text(), UnsettledUnit{node, path, read->dimension, info.dimension});
  }
  return read->value;
}

void Binder::settle_units(const Path& below,
                          const std::function<base::Dimension(const base::Dimension&)>& wanted) {
  const std::string& top = below.text();
  for (auto at = unsettled_.lower_bound(top);
       at != unsettled_.end() && at->first.starts_with(top);) {
    const auto& [path, one] = *at;
    if (path.size() > top.size() && path[top.size()] != '.' && path[top.size()] != '[') {
      ++at;
      continue;
    }
    const base::Dimension fitting = wanted(one.wanted);
    if (!base::measures(one.dimension, fitting)) {
      error(one.node, one.path, base::misfit(one.node.text(), one.dimension, fitting, *units_));
    }
    at = unsettled_.erase(at);
  }
}

void Binder::settle_units(const Path& below, const base::Dimension& wanted) {
  settle_units(below, [&wanted](const base::Dimension&) { return wanted; });
}

void Binder::settle_slip_units(const Path& below, bool rotation) {
  settle_units(below, [rotation](const base::Dimension& translation) {
    constexpr base::Dimension kArea{.length = 2};  // that of a contact, whatever slips
    return rotation && translation != kArea ? base::rotated(translation) : translation;
  });
}

void Binder::refuse_unsettled_units() {
  for (const auto& [written, one] : unsettled_) {
    error(one.node, one.path,
          base::in_quotes(one.node.text()) +
              ": a number in the case's units is wanted here, without a unit");
  }
  unsettled_.clear();
}

std::optional<double> Binder::known_number(const Node& node, const Path& path) {
  auto known = parameters_.find(bare(node.text()));
  if (known == parameters_.end()) {
    known = evaluated_.find(node.text());
    if (known == evaluated_.end()) return std::nullopt;
  }
  if (formulas_) formulas_->push_back({path.text(), std::string(node.text()), true});
  return known->second;
}

std::optional<double> Binder::number(const Node& node, const Path& path, const KeyInfo& info) {
  if (!node.is_scalar()) {
    wrong_kind(node, path, "a number");
    return std::nullopt;
  }
  if (is_expression(node)) {
    if (const auto known = known_number(node, path)) return known;
    const auto compiled = expression(node, path, {});
    if (!compiled) return std::nullopt;
    const auto value = (*compiled)({});
    if (!value) {
      expression_error(node, path, value.error(), {});
      return std::nullopt;
    }
    evaluated_.emplace(node.text(), *value);
    return *value;
  }
  const auto value = base::parse_number(node.text());
  if (!value && base::carries_unit(node.text())) return number_with_unit(node, path, info);
  // A decimal comma, for which some write quotes, has an error of its own.
  if (node.quoted() && (value || node.text().find(',') == std::string_view::npos)) {
    error(node, path, "wanted a number, found the text " + base::in_quotes(node.text()),
          "a number stands without quotes");
    return std::nullopt;
  }
  if (!value) {
    error(node, path, with_wanted("a number", value.error()));
    return std::nullopt;
  }
  return *value;
}

std::optional<std::filesystem::path> Binder::data_file(const Node& node, const Path& path,
                                                       std::string_view text) {
  const bool streamed = text == base::kStandardInput;
  if (streamed && node.source().name() == base::kStandardInputName) {
    error(node, path, "standard input is this text itself, and cannot be its data as well",
          "one of them must be a file");
    return std::nullopt;
  }
  if (streamed && standard_input_refused_) {
    error(node, path, "standard input is not read by a case that was found in a folder",
          "name the case to have it run");
    return std::nullopt;
  }
  auto file = streamed ? base::standard_input_file()
                       : base::resolve_data_path(case_folder_, text, allow_outside_);
  if (!file) {
    history_error(node, path, file.error());
    return std::nullopt;
  }
  if (streamed) return std::move(*file);
  data_files_.push_back(file->string());
  return std::move(*file);
}

std::optional<std::filesystem::path> Binder::case_file(const Node& node, const Path& path,
                                                       std::string_view text) {
  if (text != base::kStandardInput) return data_file(node, path, text);
  error(node, path, "standard input cannot be a case here: it is read more than once",
        "write it to a file");
  return std::nullopt;
}

void Binder::history_error(const Node& node, const Path& path, const base::HistoryError& problem,
                           std::string hint) {
  if (problem.kind == base::HistoryError::Kind::kEnvironment) environment_failed_ = true;
  std::string message = problem.message;
  if (problem.line > 0) {
    std::string place = problem.file + ":" + std::to_string(problem.line);
    if (problem.column > 0) place += ":" + std::to_string(problem.column);
    message = place + ": " + message;
  } else if (!problem.file.empty()) {
    message = problem.file + ": " + message;
  }
  error(node, path, std::move(message), std::move(hint));
}

std::string in_words(const law::Bounds& bounds) {
  const bool below = std::isfinite(bounds.lower);
  const bool above = std::isfinite(bounds.upper);
  const auto open = [](bool is_open) { return is_open ? " (exclusive)" : ""; };
  if (below && bounds.lower == bounds.upper) return base::format_number(bounds.lower);
  if (below && above) {
    return "between " + base::format_number(bounds.lower) + open(bounds.lower_open) + " and " +
           base::format_number(bounds.upper) + open(bounds.upper_open);
  }
  if (below) {
    return (bounds.lower_open ? "greater than " : "at least ") + base::format_number(bounds.lower);
  }
  if (above) {
    return (bounds.upper_open ? "less than " : "at most ") + base::format_number(bounds.upper);
  }
  return "";
}

std::string limits_in_words(const KeyInfo& info) {
  return info.most > 0 ? fmt::format("at most {}", info.most) : in_words(info.bounds);
}

std::string Binder::nearest_or(std::string_view name, std::span<const std::string_view> names,
                               std::string otherwise) const {
  if (flooded()) return {};
  const auto nearest = base::nearest_name(name, names);
  return nearest ? "did you mean " + base::in_quotes(*nearest) + "?" : std::move(otherwise);
}

bool Binder::in_bounds(double value, const Node& node, const Path& path,
                       const law::Bounds& bounds) {
  if (bounds.contains(value)) return true;
  error(node, path,
        "must be " + slipbench::driver::yaml::in_words(bounds) + ", found " +
            base::format_number(value));
  return false;
}

namespace {

Json bounded(std::string_view type, const law::Bounds& bounds) {
  Json schema;
  schema["type"] = type;
  if (std::isfinite(bounds.lower)) {
    schema[bounds.lower_open ? "exclusiveMinimum" : "minimum"] = bounds.lower;
  }
  if (std::isfinite(bounds.upper)) {
    schema[bounds.upper_open ? "exclusiveMaximum" : "maximum"] = bounds.upper;
  }
  return schema;
}

/// \param unit whether a number with its unit will do too
Json number_or_expression(std::string_view type, const law::Bounds& bounds, bool unit) {
  Json text;
  text["type"] = "string";
  text["pattern"] = unit ? R"(^ *=|^[-+]?[0-9.]+([eE][-+]?[0-9]+)? *([A-Za-z°µ]|1/))" : "^ *=";
  Json either = Json(base::json::Array{});
  either.push_back(bounded(type, bounds));
  either.push_back(std::move(text));
  Json schema;
  schema["anyOf"] = std::move(either);
  return schema;
}

}  // namespace

bool Codec<double>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                         double& out) {
  const std::optional<double> value = binder.number(node, path, info);
  if (!value || !binder.in_bounds(*value, node, path, info.bounds)) return false;
  out = *value;
  return true;
}

Json Codec<double>::schema(const KeyInfo& info) {
  const bool pure = info.unit == UnitUse::kDeclared && info.dimension == base::Dimension{};
  return number_or_expression("number", info.bounds, !pure && info.unit != UnitUse::kNone);
}

bool Codec<int>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                      int& out) {
  long long integer = 0;
  if (Binder::is_expression(node)) {
    const std::optional<double> value = binder.number(node, path, info);
    if (!value) return false;
    if (*value != std::floor(*value) || std::abs(*value) > 1e15) {
      binder.error(node, path, "wanted an integer, found " + base::format_number(*value));
      return false;
    }
    integer = static_cast<long long>(*value);
  } else {
    if (!node.is_scalar()) {
      binder.wrong_kind(node, path, "an integer");
      return false;
    }
    if (node.quoted()) {
      binder.error(node, path, "wanted an integer, found the text " + base::in_quotes(node.text()),
                   "a number stands without quotes");
      return false;
    }
    const auto value = base::parse_integer(node.text());
    if (!value) {
      binder.error(node, path, with_wanted("an integer", value.error()));
      return false;
    }
    integer = *value;
  }
  if (!binder.in_bounds(static_cast<double>(integer), node, path, info.bounds)) return false;
  if (integer > std::numeric_limits<int>::max() || integer < std::numeric_limits<int>::min()) {
    binder.error(node, path,
                 fmt::format("wanted an integer of at most {} digits, found {}",
                             std::numeric_limits<int>::digits10, integer));
    return false;
  }
  out = static_cast<int>(integer);
  return true;
}

Json Codec<int>::schema(const KeyInfo& info) {
  return number_or_expression("integer", info.bounds, false);
}

bool Codec<bool>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo&,
                       bool& out) {
  if (!node.is_scalar() || node.quoted() || (node.text() != "true" && node.text() != "false")) {
    binder.wrong_kind(node, path, "true or false");
    return false;
  }
  out = node.text() == "true";
  return true;
}

Json Codec<bool>::schema(const KeyInfo&) {
  Json schema;
  schema["type"] = "boolean";
  return schema;
}

bool Codec<std::string>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo&,
                              std::string& out) {
  if (!node.is_scalar()) {
    binder.wrong_kind(node, path, "a text");
    return false;
  }
  out = std::string(node.text());
  // Texts are shown in one line of terminals, logs and files: a second line could pass for a
  // message of the program.
  while (out.ends_with('\n')) out.pop_back();
  std::ranges::replace_if(
      out, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  for (std::string_view rest = out; !rest.empty();) {
    const base::CodePoint c = base::decode_utf8(rest);
    const std::string_view piece = rest.substr(0, c.length);
    if (base::printable(piece) != piece) {
      binder.error(node, path,
                   fmt::format("a text holds no control characters and none that turn the "
                               "direction of writing, found U+{:04X}",
                               c.value));
      return false;
    }
    rest.remove_prefix(c.length);
  }
  return true;
}

Json Codec<std::string>::schema(const KeyInfo&) {
  Json types = Json(base::json::Array{});  // a title may well be a plain 42
  types.push_back("string");
  types.push_back("number");
  Json schema;
  schema["type"] = std::move(types);
  return schema;
}

bool Codec<law::UnitName>::read(Binder& binder, const Node& node, const Path& path,
                                const KeyInfo& info, law::UnitName& out) {
  std::string text;
  if (!Codec<std::string>::read(binder, node, path, info, text)) return false;
  if (text.size() > law::UnitName::kLongest) {
    binder.error(node, path,
                 "the name of a unit has at most " + std::to_string(law::UnitName::kLongest) +
                     " characters, found " + std::to_string(text.size()));
    return false;
  }
  out = law::UnitName(text);
  return true;
}
Json Codec<law::UnitName>::schema(const KeyInfo& info) { return Codec<std::string>::schema(info); }

std::string listed(std::span<const std::string_view> words) {
  std::vector<std::string> quoted;
  for (const std::string_view word : words) {
    const bool is_mark = word.size() == 1 && std::ispunct(static_cast<unsigned char>(word[0])) != 0;
    quoted.push_back(is_mark ? base::in_quotes(word) : std::string(word));
  }
  return base::in_words(std::vector<std::string_view>(quoted.begin(), quoted.end()));
}

bool read_word(Binder& binder, const Node& node, const Path& path,
               std::span<const std::string_view> words, std::size_t& index) {
  if (!node.is_scalar()) {
    binder.wrong_kind(node, path, listed(words));
    return false;
  }
  const auto word = std::find(words.begin(), words.end(), node.text());
  if (word == words.end()) {
    binder.error(node, path, "wanted " + listed(words) + ", found " + base::in_quotes(node.text()),
                 binder.nearest_or(node.text(), words, ""));
    return false;
  }
  index = static_cast<std::size_t>(word - words.begin());
  return true;
}

}  // namespace slipbench::driver::yaml
