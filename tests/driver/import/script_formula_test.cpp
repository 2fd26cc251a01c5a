// SPDX-License-Identifier: Apache-2.0
#include "driver/import/script_formula.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

namespace slipbench::driver::import {
namespace {

using Language = FormulaLanguage;

double value(const std::string& text, Language language = Language::kTcl) {
  const ScriptNumbers numbers{{"a", {2.0, true}}, {"b", {0.5, false}}, {"x.y", {7.0, true}}};
  const auto found = evaluate_formula(text, numbers, language);
  INFO(text << (found ? "" : ": " + found.error().message));
  REQUIRE(found);
  return found->value;
}

std::string fault(const std::string& text, Language language = Language::kTcl) {
  const auto found = evaluate_formula(text, {}, language);
  return found ? "none" : std::to_string(found.error().offset) + ": " + found.error().message;
}

TEST_CASE("Whole numbers divide as those of the language") {
  CHECK(value("1/4") == 0.0);
  CHECK(value("-7/2") == -4.0);
  CHECK(value("-7/2", Language::kFortran) == -3.0);
  CHECK(value("-7/2", Language::kPython) == -3.5);
  CHECK(value("-7//2", Language::kPython) == -4.0);
  CHECK(value("1/4.") == 0.25);
  CHECK(value("$a/4") == 0.0);
  CHECK(value("double($a)/4") == 0.5);
  CHECK(value("int(4.7)/3") == 1.0);
  CHECK(value("-7 % 3") == 2.0);
  CHECK(value("1.5d1", Language::kFortran) == 15.0);
}

TEST_CASE("Operators bind as strongly as in the language") {
  CHECK(value("1 + 2*3 - 4") == 3.0);
  CHECK(value("2**3**2") == 512.0);
  CHECK(value("-2**2") == 4.0);
  CHECK(value("-2**2", Language::kPython) == -4.0);
  CHECK(value("2**-1.0") == 0.5);
  CHECK(value("1 < 2 && !(3 <= 2) ? $a : $b") == 2.0);
  CHECK(value("pow(b, 2) + max(1, a, b) + math.sqrt(4) + x.y", Language::kPython) ==
        Approx(0.25 + 2 + 2 + 7));
  CHECK(value("2*acos(-1)") == Approx(2 * std::acos(-1.0)));
}

TEST_CASE("Functions and powers are whole where those of the language are") {
  CHECK(value("2**-1") == 0.0);
  CHECK(value("(-1)**-1") == -1.0);
  CHECK(value("2**(-1)*4.0", Language::kFortran) == 0.0);
  CHECK(value("2**-1", Language::kPython) == 0.5);
  CHECK(value("fmod(3,2)/2") == 0.5);
  CHECK(value("max(1,0.5)/2") == 0.0);
  CHECK(value("max(1,2.5)/2") == 1.25);
  CHECK(value("round(2.5)/2") == 1.0);
  CHECK(value("round(0.5)", Language::kPython) == 0.0);
  CHECK(value("round(-1.5)", Language::kPython) == -2.0);
  CHECK(value("mod(3,2)/2", Language::kFortran) == 0.0);
  CHECK(value("010", Language::kFortran) == 10.0);
}

TEST_CASE("What programs of a language may take otherwise is refused where it stands") {
  CHECK(fault("1 + 010").starts_with("4: an integer that begins with 0"));
  CHECK(fault("1 < 2 < 3").find("compares more than two") != std::string::npos);
  CHECK(fault("max(1, 1.0)/2").find("not certain") != std::string::npos);
  CHECK(fault("max(1, 0.5)/2", Language::kFortran).find("not certain") != std::string::npos);
  CHECK(fault("pow(2, 2)/3", Language::kFortran).find("not certain") != std::string::npos);
  CHECK(fault("3000000*3000", Language::kFortran).find("too large") != std::string::npos);
  CHECK(fault("9007199254740993").find("too large") != std::string::npos);
  for (const char* text :
       {"mu", "pi", "5//2", "7.5 % 2", "ln(2)", "fabs(1.)", "nint(1.)", "0**-1"}) {
    INFO(text);
    CHECK(fault(text) != "none");
  }
  CHECK(fault("1 // 0 ** -4.", Language::kPython).find("is no number") != std::string::npos);
  for (const char* text : {"pi", "!1", "1 && 2", "1 ? 2 : 3", "a.sqrt(4)", "010", "ln(2)"}) {
    INFO(text);
    CHECK(fault(text, Language::kPython) != "none");
  }
}

TEST_CASE("A formula without a value tells why and where") {
  CHECK(fault("1 + $c") == "5: unknown name 'c'");
  CHECK(fault("1 +") == "3: a number is missing");
  CHECK(fault("(1") == "2: wanted ')'");
  CHECK(fault("1 2") == "2: '2' is not understood");
  CHECK(fault("f(1)") == "0: there is no function 'f' of 1 number");
  CHECK(fault("1/0").find("division by zero") != std::string::npos);
  CHECK(fault("sqrt(-1)").find("the result is no number") != std::string::npos);
  CHECK(fault(std::string(5000, '(')).find("is nested too deeply") != std::string::npos);
  CHECK(fault(std::string(5000, '-')).find("is nested too deeply") != std::string::npos);
  CHECK(fault("").find("a number is missing") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::import
