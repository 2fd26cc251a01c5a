// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/describe_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "driver/base/text/suggestions.hpp"
#include "driver/calibrate/fit_reference.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_examples.hpp"
#include "driver/sweep/sweep_reference.hpp"

namespace slipbench::driver::commands {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A segment of a path without "[]" or "[0]", and without the type behind "predefined".
std::string_view name_of(std::string_view segment) {
  return segment.substr(0, segment.find_first_of(" ["));
}

/// Tells whether a row is meant by the segments that were typed; names of the user's may be left
/// out.
bool is_meant(const yaml::KeyRow& row, const std::vector<std::string_view>& asked) {
  std::vector<std::string_view> segments = split(row.path, '.');
  if (name_of(segments.back()) == "NAME") return false;
  std::erase_if(segments, [](std::string_view segment) { return name_of(segment) == "NAME"; });
  if (segments.size() < asked.size()) return false;
  return std::equal(asked.rbegin(), asked.rend(), segments.rbegin(),
                    [](std::string_view word, std::string_view segment) {
                      const auto ways = split(name_of(segment), '|');
                      return std::find(ways.begin(), ways.end(), name_of(word)) != ways.end();
                    });
}

/// "force/length [F L^-1], such as N/mm", from the symbols of a dimension.
std::string unit_text(const std::string& symbols) {
  struct Base {
    std::string_view symbol;
    std::string_view name;
    std::string_view unit;
  };
  static constexpr std::array<Base, 3> kBases{
      {{"F", "force", "N"}, {"L", "length", "mm"}, {"T", "time", "s"}}};
  std::array<std::string, 2> names;
  std::array<std::string, 2> units;
  for (const std::string_view token : split(symbols, ' ')) {
    const std::size_t caret = token.find('^');
    std::string_view exponent = caret == std::string_view::npos ? "" : token.substr(caret + 1);
    const bool below = exponent.starts_with('-');
    if (below) exponent.remove_prefix(1);
    const std::string power =
        exponent.empty() || exponent == "1" ? std::string() : "^" + std::string(exponent);
    for (const Base& base : kBases) {
      if (base.symbol != token.substr(0, caret)) continue;
      const auto add = [&](std::string& text, std::string_view word) {
        text += (text.empty() ? "" : " ") + std::string(word) + power;
      };
      add(names[below ? 1 : 0], base.name);
      add(units[below ? 1 : 0], base.unit);
    }
  }
  const auto quotient = [](const std::array<std::string, 2>& parts) {
    if (parts[1].empty()) return parts[0];
    const bool several = parts[1].find(' ') != std::string::npos;
    return (parts[0].empty() ? "1" : parts[0]) + "/" + (several ? "(" + parts[1] + ")" : parts[1]);
  };
  return fmt::format("{} [{}], such as {}", quotient(names), symbols, quotient(units));
}

/// Numbers without a dimension of their own that are values of a quantity, which has one.
bool is_of_quantity(const yaml::KeyRow& row) {
  static constexpr std::array<std::string_view, 26> kKeys{
      "parameters", "reference", "initial", "weights",   "shift",       "scale",  "rows",
      "lower",      "upper",     "to",      "smooth_to", "amplitude",   "mean",   "absolute",
      "abscissa",   "with",      "motion",  "force",     "temperature", "fields", "nodes",
      "set",        "start",     "bounds",  "a",         "prior"};
  const std::string_view key = name_of(split(row.path, '.').back());
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

std::string unit_of(const yaml::KeyRow& row) {
  if (const std::string symbols = read::dimension_text(row.info.dimension); !symbols.empty()) {
    return unit_text(symbols);
  }
  if (row.wanted.find("number") == std::string::npos &&
      row.wanted.find("profile") == std::string::npos) {
    return "no unit";
  }
  if (row.info.text.find("radians") != std::string_view::npos) return "radians";
  return is_of_quantity(row) ? "that of the quantity it is a value of" : "no unit";
}

/// The key at its place in a file.
std::string in_place(const std::string& path, const std::string& value) {
  std::string text;
  std::size_t indent = 4;
  bool dash = false;
  const auto segments = split(path, '.');
  for (const std::string_view& segment : segments) {
    text += std::string(indent, ' ') + (dash ? "- " : "");
    if (dash) indent += 2;
    text += std::string(split(name_of(segment), '|').front()) + ":";
    text += &segment == &segments.back() ? " " + value + "\n" : "\n";
    dash = segment.ends_with("[]");
    indent += 2;
  }
  return text;
}

/// A key, the paths of all rows that mean the same, and the kind of file.
struct Meaning {
  const yaml::KeyRow* row = nullptr;
  std::vector<std::string> places;
  std::span<const yaml::KeyRow> rows;
  const char* file = "";
};

std::string place_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "the top level" : path.substr(0, dot);
}

void add_meanings(std::string_view asked, std::span<const yaml::KeyRow> rows, const char* file,
                  std::vector<Meaning>& all) {
  const std::vector<std::string_view> segments = split(asked, '.');
  for (const yaml::KeyRow& row : rows) {
    if (!is_meant(row, segments)) continue;
    const auto known = std::find_if(all.begin(), all.end(), [&](const Meaning& meaning) {
      return meaning.row->wanted == row.wanted && meaning.row->info.text == row.info.text;
    });
    if (known == all.end()) {
      all.push_back({&row, {place_of(row.path)}, rows, file});
    } else {
      known->places.push_back(place_of(row.path));
    }
  }
}

/// The keys directly below, a line each.
std::string keys_below(const Meaning& meaning) {
  std::string text;
  const std::string& path = meaning.row->path;
  for (const yaml::KeyRow& below : meaning.rows) {
    if (!below.path.starts_with(path) || below.path.size() == path.size()) continue;
    std::string_view rest = std::string_view(below.path).substr(path.size());
    for (const std::string_view part : {"[]", ".NAME", "[]"}) {
      if (rest.starts_with(part)) rest.remove_prefix(part.size());
    }
    if (!rest.starts_with('.') || rest.find('.', 1) != std::string_view::npos) continue;
    text += fmt::format("    {:<24} {}\n", rest.substr(1), below.info.text);
  }
  return text.empty() ? text : "  keys below\n" + text;
}

std::string described(const Meaning& meaning) {
  const yaml::KeyRow& row = *meaning.row;
  const yaml::KeyInfo& info = row.info;
  std::string type = row.wanted;
  if (const std::string limits = yaml::limits_in_words(info); !limits.empty())
    type += ", " + limits;
  const std::string fallback =
      info.required
          ? "required"
          : "default: " + std::string(info.default_text.empty() ? "0" : info.default_text);
  const std::vector<std::string_view> places(meaning.places.begin(), meaning.places.end());
  return fmt::format(
      "{} (key of a {})\n  {}\n  stands in  {}\n  type       {}\n  unit       {}\n"
      "  {}\n  example\n{}{}",
      name_of(split(row.path, '.').back()), meaning.file, info.text, base::few_in_words(places),
      type, unit_of(row), fallback, in_place(row.path, read::example_of(row, meaning.rows)),
      keys_below(meaning));
}

const std::vector<yaml::KeyRow>& rows_of_cases() {
  static const std::vector<yaml::KeyRow> rows = read::case_rows();
  return rows;
}
const std::vector<yaml::KeyRow>& rows_of_fits() {
  static const std::vector<yaml::KeyRow> rows = calibrate::fit_rows();
  return rows;
}
const std::vector<yaml::KeyRow>& rows_of_sweeps() {
  static const std::vector<yaml::KeyRow> rows = sweep::sweep_rows();
  return rows;
}

}  // namespace

std::string describe_entries(std::string_view asked) {
  std::vector<Meaning> meanings;
  add_meanings(asked, rows_of_cases(), "case", meanings);
  add_meanings(asked, rows_of_fits(), "fit", meanings);
  add_meanings(asked, rows_of_sweeps(), "sweep", meanings);
  std::string text;
  for (const Meaning& meaning : meanings) text += (text.empty() ? "" : "\n") + described(meaning);
  return text;
}

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (const std::vector<yaml::KeyRow>* rows :
       {&rows_of_cases(), &rows_of_fits(), &rows_of_sweeps()}) {
    for (const yaml::KeyRow& row : *rows) {
      if (row.path.find(".coefficient.") != std::string::npos) continue;
      for (const std::string_view way : split(name_of(split(row.path, '.').back()), '|')) {
        if (std::find(names.begin(), names.end(), way) == names.end()) names.emplace_back(way);
      }
    }
  }
  return names;
}

}  // namespace slipbench::driver::commands
