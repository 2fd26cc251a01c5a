// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "driver/base/files/data_path.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/unit_dimension.hpp"

namespace slipbench::driver::base {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// UDUNITS-2 keeps global state (its status, its parser): one caller at a time.
std::mutex& database_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Reads the unit data base: the one that comes with the program, if one does, else that of the
/// library. The library's variable goes before both.
ut_system* read_database() {
  const auto shipped = std::getenv("UDUNITS2_XML_PATH") == nullptr
                           ? shipped_path("units/udunits2.xml")
                           : std::nullopt;
  return ut_read_xml(shipped ? shipped->c_str() : nullptr);
}

/// The unit data base, or null when it cannot be read. Loading takes some milliseconds. It lives
/// as long as the process.
ut_system* database() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* loaded = read_database();
    if (loaded == nullptr) return loaded;
    // UDUNITS-2 knows the degree of angle as "degree" and "°" only.
    const Unit degree(ut_parse(loaded, "degree", UT_UTF8));
    if (degree) ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
    // Moments as they are written everywhere.
    for (const auto& [symbol, product] : {std::pair{"Nm", "N.m"}, std::pair{"Nmm", "N.mm"}}) {
      const Unit moment(ut_parse(loaded, product, UT_UTF8));
      if (moment) ut_map_symbol_to_unit(symbol, UT_ASCII, moment.get());
    }
    return loaded;
  }();
  return system;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Tells whether the library would read more into a text than a unit: an origin ("m @ 5",
/// "N from 20"), which moves every number, or an exponent that overflows.
bool is_more_than_unit(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  constexpr std::size_t kMostDigits = 3;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (is_letter(text[i])) {
      while (end < text.size() && is_letter(text[end])) ++end;
      const std::string_view word = text.substr(i, end - i);
      if (word == "from" || word == "since" || word == "after" || word == "ref") return true;
    }
    const bool power = is_letter(text[i]) || text[i] == '^';
    if (power && end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    const std::size_t digits = end;
    while (power && end < text.size() && is_digit(text[end])) ++end;
    if (end - digits > kMostDigits || text[i] == '@') return true;
    i = end;
  }
  return false;
}

Unit parse(ut_system* system, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (is_more_than_unit(word)) return nullptr;
  // The library reads an empty text as "1" and would stop at a NUL.
  if (word.empty() || word.find('\0') != std::string_view::npos) return nullptr;
  return Unit(ut_parse(system, std::string(word).c_str(), UT_UTF8));
}

tl::unexpected<HistoryError> no_database() {
  return environment_error({},
                           "the UDUNITS-2 unit data base cannot be read (is libudunits2-data "
                           "installed? UDUNITS2_XML_PATH may name its file)");
}

struct BaseUnit {
  const char* what;
  Dimension dimension;
  std::string UnitSystem::*entry;
  int Dimension::*exponent;
  const char* si;
  std::span<const std::string_view> everyday;
};

constexpr std::array<std::string_view, 7> kLengthUnits = {"mm", "m", "cm", "km", "um", "in", "ft"};
constexpr std::array<std::string_view, 8> kForceUnits = {"N",   "kN",  "MN",  "mN",
                                                         "daN", "lbf", "kip", "kgf"};
constexpr std::array<std::string_view, 5> kTimeUnits = {"s", "ms", "us", "min", "h"};
constexpr std::array<std::string_view, 4> kTemperatureUnits = {"degC", "K", "degF", "degR"};

std::span<const BaseUnit> base_units() {
  static const std::array<BaseUnit, 4> units = {{
      {"force", kForce, &UnitSystem::force, &Dimension::force, "N", kForceUnits},
      {"length", kLength, &UnitSystem::length, &Dimension::length, "m", kLengthUnits},
      {"time", kTime, &UnitSystem::time, &Dimension::time, "s", kTimeUnits},
      {"temperature", kTemperature, &UnitSystem::temperature, &Dimension::temperature, "K",
       kTemperatureUnits},
  }};
  return units;
}

constexpr Dimension kMass{.force = 1, .length = -1, .time = 2};

bool is_everyday(const BaseUnit& base, std::string_view unit) {
  return std::find(base.everyday.begin(), base.everyday.end(), unit) != base.everyday.end();
}

/// The unit of `dimension` in `system`; null when a name in it is not known.
Unit compose(ut_system* db, const Dimension& dimension, const UnitSystem& system) {
  // A temperature alone keeps its origin, which a product would drop.
  if (dimension == kTemperature) return parse(db, system.temperature);
  Unit product(ut_get_dimensionless_unit_one(db));
  const auto multiply = [&](std::string_view base, int exponent) {
    const Unit unit = parse(db, base);
    const Unit power(unit ? ut_raise(unit.get(), exponent) : nullptr);
    product.reset(product && power ? ut_multiply(product.get(), power.get()) : nullptr);
  };
  for (const BaseUnit& base : base_units()) {
    if (dimension.*base.exponent != 0) multiply(system.*base.entry, dimension.*base.exponent);
  }
  if (dimension.angle != 0) multiply("radian", dimension.angle);
  return product;
}

enum class Mismatch { kDimension, kNotLinear };

/// The factor and offset from one unit to the other. UDUNITS-2 also converts logarithmic units,
/// time stamps, and reciprocals (s to Hz): those have none.
tl::expected<UnitConversion, Mismatch> linear_conversion(ut_unit* from, ut_unit* to) {
  const Converter converter(ut_get_converter(from, to));
  if (!converter) return tl::unexpected(Mismatch::kDimension);
  // The slope over a huge, power-of-two distance: the offset's rounding does not reach it.
  constexpr double kFar = 0x1p60;
  const double offset = cv_convert_double(converter.get(), 0.0);
  const double scale = (cv_convert_double(converter.get(), kFar) - offset) / kFar;
  const double halfway = cv_convert_double(converter.get(), 0.5 * kFar);
  const bool linear = std::isfinite(offset) && std::isfinite(scale) && scale > 0.0 &&
                      std::abs(halfway - 0.5 * kFar * scale - offset) < 1e-6 * kFar * scale;
  if (!linear) return tl::unexpected(Mismatch::kNotLinear);
  return UnitConversion{scale, offset};
}

std::string unknown_unit_message(std::string_view unit, const Dimension& dimension) {
  std::string message = fmt::format("unknown unit '{}'", unit);
  for (const BaseUnit& base : base_units()) {
    if (dimension != base.dimension) continue;
    const auto nearest = nearest_name(unit, base.everyday);
    message += nearest ? fmt::format("; did you mean '{}'?", *nearest)
                       : fmt::format("; everyday units of {} are {}", base.what,
                                     fmt::join(base.everyday, ", "));
    return message;
  }
  std::vector<std::string_view> known = {"deg", "rad"};
  for (const BaseUnit& base : base_units()) {
    known.insert(known.end(), base.everyday.begin(), base.everyday.end());
  }
  known.insert(known.end(), {"Hz", "rpm", "kg", "Nm", "Nmm", "MPa"});
  if (const auto nearest = nearest_name(unit, known)) {
    return message + fmt::format("; did you mean '{}'?", *nearest);
  }
  // Units side by side need something between them: "N mm", not "Nmm".
  message += "; a product is written 'N*mm', a power 'mm^2'";
  return message;
}

std::string wrong_dimension_message(std::string_view unit, const Dimension& dimension) {
  std::string message = fmt::format("unit '{}' does not measure {}", unit, in_words(dimension));
  if (dimension == kForce && (unit == "lb" || unit == "lbs" || unit == "kg" || unit == "oz")) {
    message += fmt::format("; it is a mass, the force is '{}'",
                           unit == "kg" ? "kgf" : (unit == "oz" ? "ozf" : "lbf"));
  } else if (dimension == kTemperature && (unit == "C" || unit == "F")) {
    message += fmt::format("; the temperature is 'deg{}'", unit);
  }
  return message;
}

/// The powers of a unit's basic units, found by walking it.
struct Powers {
  ut_system* db;
  int kilogram = 0, meter = 0, second = 0, kelvin = 0, radian = 0;
  bool others = false;

  void multiply(const ut_unit* basic, int power) {
    const std::array<std::pair<const char*, int*>, 5> known = {{{"kilogram", &kilogram},
                                                                {"meter", &meter},
                                                                {"second", &second},
                                                                {"kelvin", &kelvin},
                                                                {"radian", &radian}}};
    for (const auto& [name, count] : known) {
      const Unit unit(ut_get_unit_by_name(db, name));
      if (!unit || ut_compare(unit.get(), basic) != 0) continue;
      *count += power;
      return;
    }
    others = true;
  }
};

Powers powers_of(ut_system* db, const ut_unit* unit) {
  ut_visitor visitor{};
  visitor.visit_basic = [](const ut_unit* basic, void* to) {
    static_cast<Powers*>(to)->multiply(basic, 1);
    return UT_SUCCESS;
  };
  visitor.visit_product = [](const ut_unit*, int count, const ut_unit* const* basics,
                             const int* exponents, void* to) {
    for (int i = 0; i < count; ++i) static_cast<Powers*>(to)->multiply(basics[i], exponents[i]);
    return UT_SUCCESS;
  };
  visitor.visit_galilean = [](const ut_unit*, double, const ut_unit* underlying, double, void* to) {
    auto* powers = static_cast<Powers*>(to);
    const Powers below = powers_of(powers->db, underlying);
    *powers = below;
    return UT_SUCCESS;
  };
  visitor.visit_timestamp = [](const ut_unit*, const ut_unit*, double, void* to) {
    static_cast<Powers*>(to)->others = true;
    return UT_SUCCESS;
  };
  visitor.visit_logarithmic = [](const ut_unit*, double, const ut_unit*, void* to) {
    static_cast<Powers*>(to)->others = true;
    return UT_SUCCESS;
  };
  Powers powers{.db = db};
  if (ut_accept_visitor(unit, &visitor, &powers) != UT_SUCCESS) powers.others = true;
  return powers;
}

}  // namespace

std::string in_words(const Dimension& dimension) {
  for (const BaseUnit& base : base_units()) {
    if (dimension == base.dimension) return fmt::format("a {}", base.what);
  }
  if (dimension == kAngle) return "an angle";
  if (dimension == kMoment) return "a moment (force times length)";
  if (dimension == Dimension{.length = 1, .time = -1}) return "a speed (length per time)";
  if (dimension == rotated({.length = 1, .time = -1})) return "an angular speed (angle per time)";
  if (dimension == kFrequency) return "a frequency (cycles per time)";
  if (dimension == Dimension{.force = 1, .length = -1}) return "a stiffness (force per length)";
  if (dimension == rotated({.force = 1, .length = -1})) {
    return "a stiffness of rotation (moment per angle)";
  }
  if (dimension == kMass) return "a mass";
  if (dimension == rotated(kMass)) return "a moment of inertia";
  if (dimension == Dimension{.length = 2}) return "an area";
  if (dimension == Dimension{}) return "a number without unit";
  std::string words;
  const auto add = [&words](const char* what, int exponent) {
    if (exponent == 0) return;
    if (!words.empty()) words += '*';
    words += what;
    if (exponent != 1) words += fmt::format("^{}", exponent);
  };
  for (const BaseUnit& base : base_units()) add(base.what, dimension.*base.exponent);
  add("angle", dimension.angle);
  return words;
}

std::string unit_text(const Dimension& dimension, const UnitSystem& system) {
  std::string above;
  std::string below;
  const auto add = [&](std::string_view name, int exponent) {
    if (exponent == 0) return;
    std::string& side = exponent > 0 ? above : below;
    const int power = std::abs(exponent);
    if (exponent > 0 && !side.empty()) side += ' ';
    if (exponent < 0) side += '/';
    side += name;
    if (power != 1) side += fmt::format("^{}", power);
  };
  for (const BaseUnit& base : base_units()) {
    const int exponent = dimension.*base.exponent;
    if (exponent != 0 && (system.*base.entry).empty()) return {};
    add(system.*base.entry, exponent);
  }
  add("rad", dimension.angle);
  if (above.empty() && !below.empty()) above = "1";
  return above + below;
}

tl::expected<Dimension, HistoryError> dimension_of_unit(std::string_view unit) {
  unit = trimmed(unit);
  for (const BaseUnit& base : base_units()) {
    if (is_everyday(base, unit)) return base.dimension;
  }
  const std::scoped_lock lock(database_mutex());
  ut_system* const db = database();
  if (db == nullptr) return no_database();
  const Unit parsed = parse(db, unit);
  if (!parsed) return input_error(unknown_unit_message(unit, {}));
  const Powers powers = powers_of(db, parsed.get());
  if (powers.others) {
    return input_error(fmt::format("unit '{}' measures nothing that a case has", unit));
  }
  // A mass is a force times time squared over length.
  return Dimension{.force = powers.kilogram,
                   .length = powers.meter - powers.kilogram,
                   .time = powers.second + 2 * powers.kilogram,
                   .temperature = powers.kelvin,
                   .angle = powers.radian};
}

bool measures(const Dimension& unit, const Dimension& wanted) {
  Dimension without_angle = wanted;
  without_angle.angle = 0;
  return unit == wanted || (unit == without_angle && wanted.force != 0);
}

std::string wanted_in_words(const Dimension& wanted, const UnitSystem& system) {
  const std::string unit = wanted == kMass            ? "kg"
                           : wanted == rotated(kMass) ? "kg.m2"
                                                      : unit_text(wanted, system);
  return in_words(wanted) + " is wanted" + (unit.empty() ? "" : ", such as " + unit);
}

bool is_unit(std::string_view text) {
  const std::string_view word = trimmed(text);
  return word.find_first_of("0123456789+-.") != 0 && dimension_of_unit(word).has_value();
}

tl::expected<void, HistoryError> check_base_unit(std::string_view unit,
                                                 const Dimension& dimension) {
  const std::string_view word = trimmed(unit);
  for (const BaseUnit& base : base_units()) {
    if (!is_everyday(base, word)) continue;
    if (dimension == base.dimension) return {};
    return input_error(wrong_dimension_message(word, dimension));
  }
  if (word.empty()) return input_error(unknown_unit_message(word, dimension));

  const std::scoped_lock lock(database_mutex());
  ut_system* const db = database();
  if (db == nullptr) return no_database();
  const Unit parsed = parse(db, word);
  if (!parsed) return input_error(unknown_unit_message(word, dimension));
  UnitSystem si;
  for (const BaseUnit& base : base_units()) si.*base.entry = base.si;
  const Unit wanted = compose(db, dimension, si);
  if (!wanted || !linear_conversion(parsed.get(), wanted.get())) {
    return input_error(wrong_dimension_message(word, dimension));
  }
  return {};
}

tl::expected<UnitConversion, HistoryError> conversion_to_case(std::string_view unit,
                                                              const Dimension& dimension,
                                                              const UnitSystem& system) {
  const std::string_view word = trimmed(unit);
  for (const BaseUnit& base : base_units()) {
    if (dimension.*base.exponent != 0 && (system.*base.entry).empty()) {
      return input_error(
          fmt::format("unit '{}' cannot be converted: the case does not state its unit of {} "
                      "(units: {{{}: ...}})",
                      word, base.what, base.what));
    }
  }
  if (!word.empty() && word == unit_text(dimension, system)) return UnitConversion{};

  const std::scoped_lock lock(database_mutex());
  ut_system* const db = database();
  if (db == nullptr) return no_database();
  const Unit from = parse(db, word);
  if (!from) return input_error(unknown_unit_message(word, dimension));
  const Unit to = compose(db, dimension, system);
  if (!to) {
    return input_error(
        fmt::format("the case's unit '{}' is not known", unit_text(dimension, system)));
  }
  const auto conversion = linear_conversion(from.get(), to.get());
  if (conversion) return *conversion;
  if (conversion.error() == Mismatch::kDimension) {
    return input_error(wrong_dimension_message(word, dimension));
  }
  return input_error(
      fmt::format("unit '{}' has no constant factor to '{}'", word, unit_text(dimension, system)));
}

}  // namespace slipbench::driver::base
