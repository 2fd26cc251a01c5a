// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/deck_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::radioss {
namespace {

constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return text.substr(0, 0);
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string in_quotes(std::string_view text) { return "'" + shortened(text, 40) + "'"; }

/// Takes the digits at the front of a text away. \return how many they were
std::size_t take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

bool take_sign(std::string_view& text) {
  if (text.empty() || (text.front() != '+' && text.front() != '-')) return false;
  text.remove_prefix(1);
  return true;
}

/// A Fortran number as C++ reads it, or nothing: without '+' in front, with 'e' before the
/// exponent.
std::optional<std::string> normalised(std::string_view text) {
  std::string_view rest = text;
  take_sign(rest);
  std::size_t digits = take_digits(rest);
  if (!rest.empty() && rest.front() == '.') {
    rest.remove_prefix(1);
    digits += take_digits(rest);
  }
  if (digits == 0) return std::nullopt;
  std::string result(text.substr(0, text.size() - rest.size()));
  if (result.front() == '+') result.erase(0, 1);
  if (rest.empty()) return result;
  const bool letter = std::string_view("eEdD").find(rest.front()) != std::string_view::npos;
  if (letter) rest.remove_prefix(1);
  const std::string_view exponent = rest;
  if (!take_sign(rest) && !letter) return std::nullopt;
  if (take_digits(rest) == 0 || !rest.empty()) return std::nullopt;
  return result + "e" + std::string(exponent);
}

tl::unexpected<DeckFault> fault(std::string message, std::string_view text) {
  return tl::make_unexpected(DeckFault{std::move(message), text});
}

/// Tells whether a text stands for a number of /PARAMETER: "&mu", "-&mu".
bool is_parameter(std::string_view text) { return text.starts_with('&') || text.starts_with("-&"); }

tl::expected<double, std::string> number_of(std::string_view text,
                                            const base::NamedNumbers& parameters) {
  if (!is_parameter(text)) return parse_fortran_number(text);
  const bool negative = text.front() == '-';
  const auto found = parameters.find(text.substr(negative ? 2 : 1));
  if (found == parameters.end()) {
    return tl::make_unexpected(in_quotes(text) +
                               " is no number that the deck states as a parameter");
  }
  return negative ? -found->second : found->second;
}

/// The number of one field.
tl::expected<double, DeckFault> value_of(const DeckField& field, std::string_view text,
                                         const base::NamedNumbers& parameters) {
  if (text.empty()) return 0.0;
  const auto number = number_of(text, parameters);
  if (!number) return fault(std::string(field.name) + ": " + number.error(), text);
  constexpr double kLargest = std::numeric_limits<int>::max();
  if (field.integer && (*number != std::trunc(*number) || std::abs(*number) > kLargest)) {
    return fault(std::string(field.name) + ": wanted an integer, found " + in_quotes(text), text);
  }
  return *number;
}

/// The text of each named field by its columns; nothing if the line cannot be in fixed format.
std::optional<std::vector<std::string_view>> fixed_texts(std::string_view line,
                                                         std::span<const DeckField> fields) {
  if (line.find('\t') != std::string_view::npos) return std::nullopt;
  std::vector<std::string_view> texts;
  std::size_t end = 0;
  for (const DeckField& field : fields) {
    const std::string_view text =
        trimmed(line.substr(std::min(field.begin, line.size()), field.width));
    end = std::max(end, field.begin + field.width);
    if (text.find(' ') != std::string_view::npos) return std::nullopt;
    if (field.name.empty()) {
      if (!text.empty()) return std::nullopt;
      continue;
    }
    if (!text.empty() && !is_parameter(text) && !normalised(text)) return std::nullopt;
    texts.push_back(text);
  }
  if (!trimmed(line.substr(std::min(end, line.size()))).empty()) return std::nullopt;
  return texts;
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    result.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return result;
}

}  // namespace

tl::expected<double, std::string> parse_fortran_number(std::string_view text) {
  const auto plain = normalised(text);
  if (!plain) return tl::make_unexpected("wanted a number, found " + in_quotes(text));
  double value = 0.0;
  const auto read = std::from_chars(plain->data(), plain->data() + plain->size(), value);
  const bool zero =
      plain->substr(0, plain->find('e')).find_first_of("123456789") == std::string::npos;
  if (zero) return plain->front() == '-' ? -0.0 : 0.0;
  if (read.ec != std::errc{} || !std::isfinite(value) || value == 0.0) {
    return tl::make_unexpected("the number " + in_quotes(text) + " is beyond what a double holds");
  }
  return value;
}

tl::expected<DeckNumbers, DeckFault> read_numbers(std::string_view line,
                                                  std::span<const DeckField> fields,
                                                  std::size_t least_free,
                                                  const base::NamedNumbers& parameters) {
  std::vector<DeckField> named;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(named),
               [](const DeckField& field) { return !field.name.empty(); });
  DeckNumbers numbers;
  if (auto fixed = fixed_texts(line, fields)) {
    numbers.texts = std::move(*fixed);
  } else {
    numbers.texts = words(line);
    numbers.free_format = true;
    const std::size_t count = numbers.texts.size();
    for (const std::string_view word : numbers.texts) {
      if (!is_parameter(word) && !normalised(word))
        return fault("wanted a number, found " + in_quotes(word), word);
    }
    if (count != named.size() && count != least_free) {
      std::string names;
      for (const DeckField& field : named)
        names += (names.empty() ? "" : ", ") + std::string(field.name);
      return fault("wanted " + names + " in their columns, found " + std::to_string(count) +
                       " numbers elsewhere",
                   trimmed(line));
    }
    numbers.texts.resize(named.size(), line.substr(line.size()));
  }
  for (std::size_t i = 0; i < named.size(); ++i) {
    const auto value = value_of(named[i], numbers.texts[i], parameters);
    if (!value) return tl::make_unexpected(value.error());
    numbers.values.push_back(*value);
  }
  return numbers;
}

tl::expected<double, DeckFault> read_field(std::string_view line, const DeckField& field,
                                           const base::NamedNumbers& parameters) {
  return value_of(field, trimmed(line.substr(std::min(field.begin, line.size()), field.width)),
                  parameters);
}

}  // namespace slipbench::driver::radioss
