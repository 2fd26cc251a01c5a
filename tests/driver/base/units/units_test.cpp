// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/units.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>

#include "driver/base/units/unit_dimension.hpp"

namespace slipbench::driver::base {
namespace {

const UnitSystem kMillimetres{"mm", "N", "s", "degC"};

// Factors of UDUNITS-2 are decimal texts of some 15 digits, multiplied two or three times.
constexpr double kTolerance = 1e-14;

UnitConversion convert(const std::string& unit, const Dimension& dimension,
                       const UnitSystem& system = kMillimetres) {
  const auto conversion = conversion_to_case(unit, dimension, system);
  INFO(unit);
  REQUIRE(conversion);
  return *conversion;
}

std::string refusal(const std::string& unit, const Dimension& dimension,
                    const UnitSystem& system = kMillimetres) {
  const auto conversion = conversion_to_case(unit, dimension, system);
  INFO(unit);
  REQUIRE_FALSE(conversion);
  CHECK(conversion.error().kind == HistoryError::Kind::kInput);
  return conversion.error().message;
}

TEST_CASE("the case's own unit is the identity") {
  CHECK(convert("mm", kLength) == UnitConversion{});
  CHECK(convert(" N mm ", kMoment) == UnitConversion{});
  CHECK(convert("degC", kTemperature) == UnitConversion{});
  CHECK(convert("rad", kAngle) == UnitConversion{});
}

TEST_CASE("lengths, forces, moments and times convert by their factor") {
  CHECK(convert("in", kLength).scale == Approx(25.4).epsilon(kTolerance));
  CHECK(convert("m", kLength).scale == Approx(1000.0).epsilon(kTolerance));
  CHECK(convert("lbf", kForce).scale == Approx(4.4482216152605).epsilon(kTolerance));
  CHECK(convert("kN", kForce).scale == Approx(1000.0).epsilon(kTolerance));
  CHECK(convert("N m", kMoment).scale == Approx(1000.0).epsilon(kTolerance));
  CHECK(convert("lbf*in", kMoment).scale == Approx(112.984829027617).epsilon(1e-13));
  CHECK(convert("ms", kTime).scale == Approx(1e-3).epsilon(kTolerance));
  CHECK(convert("m/s", {.length = 1, .time = -1}).scale == Approx(1e3).epsilon(kTolerance));
  CHECK(convert("MPa", {.force = 1, .length = -2}).scale == Approx(1.0).epsilon(kTolerance));
  CHECK(convert("\xc2\xb5m", kLength).scale == Approx(1e-3).epsilon(kTolerance));
  CHECK(convert("in", kLength).offset == 0.0);
}

TEST_CASE("a moment is known by its everyday name") {
  CHECK(convert("Nm", kMoment).scale == Approx(1000.0).epsilon(kTolerance));
  CHECK(convert("Nmm", kMoment).scale == Approx(1.0).epsilon(kTolerance));
  CHECK(convert("kNm", kMoment).scale == Approx(1e6).epsilon(kTolerance));
}

TEST_CASE("a unit has a dimension of its own, with its angle") {
  const auto of = [](const char* unit) {
    const auto dimension = dimension_of_unit(unit);
    INFO(unit);
    REQUIRE(dimension);
    return *dimension;
  };
  CHECK(of("mm") == kLength);
  CHECK(of("kN/mm") == Dimension{.force = 1, .length = -1});
  CHECK(of("kg") == Dimension{.force = 1, .length = -1, .time = 2});
  CHECK(of("kg.m2") == Dimension{.force = 1, .length = 1, .time = 2});
  CHECK(of("Nm/rad") == Dimension{.force = 1, .length = 1, .angle = -1});
  CHECK(of("MPa") == Dimension{.force = 1, .length = -2});
  CHECK(of("deg") == kAngle);
  CHECK(of("Hz") == kFrequency);
  CHECK(of("rad/s") == Dimension{.time = -1, .angle = 1});
  CHECK(of("rpm") == Dimension{.time = -1, .angle = 1});
  CHECK(of("degF") == kTemperature);
  CHECK(of("%") == Dimension{});
  for (const char* none : {"", "zorkmid", "A", "lg(re 1 mW)", "seconds since 1970-01-01"}) {
    INFO(none);
    CHECK_FALSE(dimension_of_unit(none));
  }
}

TEST_CASE("a moment per angle may leave out the radian, a frequency is no angular speed") {
  constexpr Dimension kStiffness{.force = 1, .length = -1};
  CHECK(rotated(kStiffness) == Dimension{.force = 1, .length = 1, .angle = -1});
  CHECK(measures(kMoment, rotated(kStiffness)));
  CHECK(measures(rotated(kStiffness), rotated(kStiffness)));
  CHECK_FALSE(measures(kStiffness, rotated(kStiffness)));
  CHECK_FALSE(measures(kFrequency, rotated({.length = 1, .time = -1})));
  CHECK_FALSE(measures({}, kAngle));
}

TEST_CASE("angles are radians whatever the system") {
  CHECK(convert("deg", kAngle).scale == Approx(std::numbers::pi / 180.0).epsilon(kTolerance));
  CHECK(convert("degree", kAngle).scale == Approx(std::numbers::pi / 180.0).epsilon(kTolerance));
  CHECK(convert("deg", kAngle, {}).scale == Approx(std::numbers::pi / 180.0).epsilon(kTolerance));
  CHECK(convert("deg/s", {.time = -1, .angle = 1}).scale ==
        Approx(std::numbers::pi / 180.0).epsilon(kTolerance));
}

TEST_CASE("a temperature converts with its origin") {
  const UnitConversion kelvin = convert("K", kTemperature);
  CHECK(kelvin.scale == 1.0);
  CHECK(kelvin.offset == Approx(-273.15).epsilon(kTolerance));
  const UnitConversion fahrenheit = convert("degF", kTemperature);
  // The origin is a difference of numbers near 460; the last digits of those dominate.
  CHECK(fahrenheit(32.0) == Approx(0.0).margin(1e-12));
  CHECK(fahrenheit(212.0) == Approx(100.0).epsilon(1e-14));
  const UnitConversion celsius = convert("degC", kTemperature, {"mm", "N", "s", "K"});
  CHECK(celsius(20.0) == Approx(293.15).epsilon(kTolerance));
}

TEST_CASE("a temperature in a product has no origin") {
  const UnitConversion per_kelvin = convert("N/K", {.force = 1, .temperature = -1});
  CHECK(per_kelvin.scale == Approx(1.0).epsilon(kTolerance));
  CHECK(per_kelvin.offset == 0.0);
}

TEST_CASE("a unit of another dimension is refused") {
  CHECK(refusal("N", kLength) == "unit 'N' does not measure a length");
  CHECK(refusal("mm", kForce) == "unit 'mm' does not measure a force");
  CHECK(refusal("deg", kLength) == "unit 'deg' does not measure a length");
  CHECK(refusal("mm", kAngle) == "unit 'mm' does not measure an angle");
  CHECK(refusal("N", kMoment) == "unit 'N' does not measure a moment (force times length)");
  CHECK(refusal("lb", kForce) ==
        "unit 'lb' does not measure a force; it is a mass, the force is "
        "'lbf'");
  CHECK(refusal("C", kTemperature) ==
        "unit 'C' does not measure a temperature; the temperature is 'degC'");
  CHECK(refusal("Hz", kTime).find("no constant factor") != std::string::npos);
}

TEST_CASE("an unknown unit is refused with the nearest everyday one") {
  CHECK(refusal("furlonk", kLength) ==
        "unknown unit 'furlonk'; everyday units of length are mm, m, cm, km, um, in, ft");
  CHECK(refusal("lbff", kForce) == "unknown unit 'lbff'; did you mean 'lbf'?");
  CHECK(refusal("Nmmm", kMoment) == "unknown unit 'Nmmm'; did you mean 'Nmm'?");
  CHECK(refusal("zorkmid", kMoment) ==
        "unknown unit 'zorkmid'; a product is written 'N*mm', a power 'mm^2'");
  CHECK(refusal("", kLength).find("unknown unit ''") == 0);
  CHECK(refusal("0,5 mm", kLength).find("unknown unit") == 0);
}

TEST_CASE("a unit cannot be converted in a case that states none") {
  CHECK(refusal("in", kLength, {"", "N", "s", "K"}) ==
        "unit 'in' cannot be converted: the case does not state its unit of length (units: "
        "{length: ...})");
  CHECK(refusal("N m", kMoment, {}).find("unit of force") != std::string::npos);
}

TEST_CASE("a base unit is checked for its dimension") {
  CHECK(check_base_unit("mm", kLength));
  CHECK(check_base_unit("kip", kForce));
  CHECK(check_base_unit("degC", kTemperature));
  CHECK(check_base_unit("furlong", kLength));
  CHECK(check_base_unit("mil", kLength));
  CHECK(check_base_unit("N", kLength).error().message == "unit 'N' does not measure a length");
  CHECK(check_base_unit("second", kLength).error().message ==
        "unit 'second' does not measure a length");
  CHECK(check_base_unit("lb", kForce).error().message.find("'lbf'") != std::string::npos);
  CHECK(check_base_unit("Hz", kTime).error().message == "unit 'Hz' does not measure a time");
  CHECK(check_base_unit("secc", kTime).error().message.find("unknown unit") == 0);
  CHECK(check_base_unit("", kTime).error().message.find("unknown unit") == 0);
}

TEST_CASE("the case's unit of a dimension has a text") {
  CHECK(unit_text(kLength, kMillimetres) == "mm");
  CHECK(unit_text(kMoment, kMillimetres) == "N mm");
  CHECK(unit_text({.force = 1, .length = -2}, kMillimetres) == "N/mm^2");
  CHECK(unit_text({.time = -1, .angle = 1}, kMillimetres) == "rad/s");
  CHECK(unit_text({.time = -1}, kMillimetres) == "1/s");
  CHECK(unit_text({}, kMillimetres).empty());
  CHECK(unit_text(kMoment, {"mm", "", "s", ""}).empty());
  CHECK(unit_text(kAngle, {}) == "rad");
}

}  // namespace
}  // namespace slipbench::driver::base
