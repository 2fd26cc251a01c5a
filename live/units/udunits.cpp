// SPDX-License-Identifier: Apache-2.0
// Functions of UDUNITS-2 for the bench, over the unit data base of UDUNITS-2 itself: a page has no
// files to read it from, so the build makes the table below of it. Logarithmic units and time
// stamps are no units here.
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace {

/// A word for a unit, and what it is a word for; "#meter" is a base unit.
struct Entry {
  std::string_view word;
  std::string_view definition;
  bool any_case = false;
};

struct Prefix {
  std::string_view word;
  double value = 1.0;
  bool name = false;  ///< in any case, and behind another one
};

#include <units_table.inc>

constexpr std::array<std::string_view, 8> kBasics = {"meter",  "kilogram", "second",  "ampere",
                                                     "kelvin", "mole",     "candela", "radian"};
constexpr std::size_t kRadian = 7;

/// A number in the unit, plus `origin`, times `scale` is that in powers of the base units.
struct Amount {
  double scale = 1.0;
  double origin = 0.0;
  std::array<int, kBasics.size()> powers{};
};

}  // namespace

union ut_unit {
  Amount amount{};
};
struct ut_system {
  std::map<std::string, Amount> symbols{};
};
union cv_converter {
  struct {
    double scale, offset;
    bool turned;  ///< the one is the reciprocal of the other
  } data;
};

namespace {

std::optional<Amount> unit_of(const ut_system& system, std::string_view word);

void multiply(Amount& to, const Amount& by, int power) {
  // A product has no origin.
  to.origin = 0.0;
  to.scale *= power == 1 ? by.scale : std::pow(by.scale, power);
  for (std::size_t i = 0; i < to.powers.size(); ++i) to.powers[i] += power * by.powers[i];
}

/// Reads "1e-3 kg/(m.s)", "K @ 273.15", "mm2", ..: products from the left to the right.
class Reader {
 public:
  Reader(const ut_system& system, std::string_view text) : system_(system), rest_(text) {}

  std::optional<Amount> read() {
    const auto amount = shifted();
    return rest_.empty() ? amount : std::nullopt;
  }

 private:
  static constexpr int kMostParentheses = 64;

  std::optional<Amount> shifted() {
    auto amount = product();
    skip_blanks();
    if (amount && take("@")) {
      const auto shift = number();
      if (!shift) return std::nullopt;
      amount->origin += *shift;
      skip_blanks();
    }
    return amount;
  }

  /// Reads factors with blanks between them, or "*", "." or "-" without blanks, or "/" and "per".
  std::optional<Amount> product() {
    auto amount = power();
    while (amount) {
      const bool apart = skip_blanks();
      if (rest_.empty() || rest_.front() == ')' || rest_.front() == '@') break;
      const bool divides = take("/") || take("per ") || take("PER ");
      if (divides) {
        skip_blanks();
      } else if (!apart && !is_signed_digit()) {
        // Behind blanks "-2" and ".5" are numbers.
        static_cast<void>(take("*") || take(".") || take("-") || take("\302\267"));
      }
      const auto factor = power();
      if (!factor) return std::nullopt;
      multiply(*amount, *factor, divides ? -1 : 1);
    }
    return amount;
  }

  /// A factor with its exponent: "mm^2", "mm2", "s-1", "mm\302\262".
  std::optional<Amount> power() {
    const bool counts = !rest_.empty() && is_number(rest_.front());
    auto base = factor();
    if (!base) return base;
    int exponent = 1;
    if (take("^") || take("**") ||
        (!counts && !rest_.empty() && (is_digit(rest_.front()) || is_signed_digit()))) {
      const auto [end, error] = std::from_chars(rest_.data() + (rest_.starts_with("+") ? 1 : 0),
                                                rest_.data() + rest_.size(), exponent);
      if (error != std::errc{} || std::abs(exponent) > 255) return std::nullopt;
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    } else if (take("\302\262")) {
      exponent = 2;
    } else if (take("\302\263")) {
      exponent = 3;
    }
    if (exponent == 1) return base;
    Amount raised;
    multiply(raised, *base, exponent);
    return raised;
  }

  std::optional<Amount> factor() {
    if (rest_.empty()) return std::nullopt;
    if (take("(")) {
      if (++depth_ > kMostParentheses) return std::nullopt;
      const auto inner = shifted();
      --depth_;
      return inner && take(")") ? inner : std::nullopt;
    }
    if (is_number(rest_.front())) {
      const auto value = number();
      if (!value) return std::nullopt;
      return Amount{.scale = *value};
    }
    if (!is_letter(rest_)) return std::nullopt;
    // Figures within a word are of it, those at its end are an exponent.
    std::size_t size = 0;
    while (size < rest_.size() && (is_letter(rest_.substr(size)) || is_digit(rest_[size]))) ++size;
    while (is_digit(rest_[size - 1])) --size;
    const std::string_view word = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return unit_of(system_, word);
  }

  std::optional<double> number() {
    skip_blanks();
    double value = 0.0;
    const std::size_t sign = rest_.starts_with("+") ? 1 : 0;
    const auto [end, error] =
        std::from_chars(rest_.data() + sign, rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_number(char c) { return is_digit(c) || c == '-' || c == '+' || c == '.'; }
  bool is_signed_digit() const {
    return rest_.size() > 1 && (rest_[0] == '-' || rest_[0] == '+') && is_digit(rest_[1]);
  }
  /// Letters, and what stands for angles; of two bytes all but the dot and the exponents.
  static bool is_letter(std::string_view at) {
    const char c = at.front();
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return true;
    if (c == '_' || c == '\'' || c == '"' || c == '%') return true;
    if (at.starts_with("\302\267") || at.starts_with("\302\262") || at.starts_with("\302\263")) {
      return false;
    }
    return static_cast<unsigned char>(c) >= 0x80U;
  }
  /// Tells whether there were any.
  bool skip_blanks() {
    const std::size_t blanks = std::min(rest_.find_first_not_of(' '), rest_.size());
    rest_.remove_prefix(blanks);
    return blanks > 0;
  }
  bool take(std::string_view what) {
    if (!rest_.starts_with(what)) return false;
    rest_.remove_prefix(what.size());
    return true;
  }

  const ut_system& system_;
  std::string_view rest_;
  int depth_ = 0;
};

bool same(std::string_view a, std::string_view b, bool any_case) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char one, char other) {
    return one == other || (any_case && lower(one) == lower(other));
  });
}

std::optional<Amount> known_unit(const ut_system& system, std::string_view word) {
  if (const auto own = system.symbols.find(std::string(word)); own != system.symbols.end()) {
    return own->second;
  }
  const auto entry = std::find_if(std::begin(kEntries), std::end(kEntries), [&](const Entry& one) {
    return same(one.word, word, one.any_case);
  });
  if (entry == std::end(kEntries)) return std::nullopt;
  if (entry->definition.front() != '#') return Reader(system, entry->definition).read();
  Amount basic;
  const auto at = std::find(kBasics.begin(), kBasics.end(), entry->definition.substr(1));
  basic.powers[static_cast<std::size_t>(at - kBasics.begin())] = 1;
  return basic;
}

/// Returns the longest prefix that a word begins with: of those that are names, or symbols.
const Prefix* prefix_of(std::string_view word, bool name) {
  const Prefix* longest = nullptr;
  for (const Prefix& prefix : kPrefixes) {
    if (prefix.name != name || !same(prefix.word, word.substr(0, prefix.word.size()), name)) {
      continue;
    }
    if (longest == nullptr || prefix.word.size() > longest->word.size()) longest = &prefix;
  }
  return longest;
}

/// Returns the unit of a word, behind any names of prefixes and one symbol of a prefix.
std::optional<Amount> unit_of(const ut_system& system, std::string_view word) {
  double scale = 1.0;
  bool symbol_seen = false;
  while (!word.empty()) {
    if (const auto unit = known_unit(system, word)) {
      Amount scaled = *unit;
      scaled.scale *= scale;
      scaled.origin /= scale;
      return scaled;
    }
    const Prefix* prefix = prefix_of(word, true);
    if (prefix == nullptr && !symbol_seen) {
      prefix = prefix_of(word, false);
      symbol_seen = true;
    }
    if (prefix == nullptr) break;
    scale *= prefix->value;
    word.remove_prefix(prefix->word.size());
  }
  return std::nullopt;
}

ut_system& the_system() {
  static ut_system system;
  return system;
}

ut_unit* made(const std::optional<Amount>& amount) {
  return amount ? new ut_unit{*amount} : nullptr;
}

}  // namespace

ut_error_message_handler ut_set_error_message_handler(ut_error_message_handler handler) {
  return handler;
}
int ut_ignore(const char*, va_list) { return 0; }
ut_system* ut_read_xml(const char*) { return &the_system(); }
ut_unit* ut_parse(const ut_system* system, const char* text, ut_encoding) {
  return made(Reader(*system, text).read());
}
ut_status ut_map_symbol_to_unit(const char* symbol, ut_encoding, const ut_unit* unit) {
  the_system().symbols.emplace(symbol, unit->amount);
  return UT_SUCCESS;
}
ut_unit* ut_get_dimensionless_unit_one(const ut_system*) { return new ut_unit{}; }
ut_unit* ut_get_unit_by_name(const ut_system* system, const char* name) {
  return made(unit_of(*system, name));
}
ut_unit* ut_raise(const ut_unit* unit, int power) {
  Amount raised;
  multiply(raised, unit->amount, power);
  return new ut_unit{raised};
}
ut_unit* ut_multiply(const ut_unit* one, const ut_unit* other) {
  Amount product = one->amount;
  multiply(product, other->amount, 1);
  return new ut_unit{product};
}
int ut_compare(const ut_unit* one, const ut_unit* other) {
  const Amount &a = one->amount, &b = other->amount;
  return a.powers == b.powers && a.scale == b.scale && a.origin == b.origin ? 0 : 1;
}
void ut_free(ut_unit* unit) { delete unit; }

ut_status ut_accept_visitor(const ut_unit* unit, const ut_visitor* visitor, void* argument) {
  std::array<ut_unit, kBasics.size()> basics{};
  std::array<const ut_unit*, kBasics.size()> places{};
  std::array<int, kBasics.size()> powers{};
  int count = 0;
  for (std::size_t i = 0; i < kBasics.size(); ++i) {
    if (unit->amount.powers[i] == 0) continue;
    const auto at = static_cast<std::size_t>(count++);
    basics[at].amount.powers[i] = 1;
    places[at] = &basics[at];
    powers[at] = unit->amount.powers[i];
  }
  return visitor->visit_product(unit, count, places.data(), powers.data(), argument);
}

cv_converter* ut_get_converter(ut_unit* from, ut_unit* to) {
  const Amount &a = from->amount, &b = to->amount;
  auto left = a.powers, right = b.powers, turned = a.powers;
  // An angle is a ratio of lengths.
  left[kRadian] = right[kRadian] = turned[kRadian] = 0;
  for (int& power : turned) power = -power;
  if (left != right && turned != right) return nullptr;
  // To the base units and from them, as UDUNITS-2 does: its numbers are the same, bit by bit.
  const double back = 1.0 / b.scale;
  return new cv_converter{{a.scale * back, a.origin * a.scale * back - b.origin, left != right}};
}
double cv_convert_double(const cv_converter* converter, double value) {
  const auto& [scale, offset, turned] = converter->data;
  return turned ? 1.0 / (scale * value) : scale * value + offset;
}
void cv_free(cv_converter* converter) { delete converter; }
