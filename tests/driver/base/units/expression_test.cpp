// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/expression.hpp"

#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <string>
#include <vector>

namespace slipbench::driver::base {
namespace {

using Names = std::vector<std::string>;

const NamedNumbers kParameters = {{"li", 0.55}, {"lf", 0.10}, {"mu", 0.15}, {"zero", 0.0}};

double evaluate(const std::string& text) {
  const auto expression = Expression::compile(text, {}, kParameters);
  INFO(text);
  REQUIRE(expression);
  const auto value = (*expression)({});
  REQUIRE(value);
  return *value;
}

ExpressionError compile_error(const std::string& text) {
  const auto expression = Expression::compile(text, {}, kParameters);
  INFO(text);
  REQUIRE_FALSE(expression);
  return expression.error();
}

ExpressionError evaluation_error(const std::string& text) {
  const auto expression = Expression::compile(text, {}, kParameters);
  INFO(text);
  REQUIRE(expression);
  const auto value = (*expression)({});
  REQUIRE_FALSE(value);
  return value.error();
}

/// Writes 1.5 as 1,5.
struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("an expression computes what its operators and functions say") {
  CHECK(evaluate("2/li") == 2.0 / 0.55);
  CHECK(evaluate("= 2/li") == 2.0 / 0.55);
  CHECK(evaluate("  =2 * (1 + 3)\n - 1") == 7.0);
  CHECK(evaluate("-2^2") == -4.0);
  CHECK(evaluate("2^-1") == 0.5);
  CHECK(evaluate("min(3, 1.5, 2) + max(1, 4) + abs(-1) + sign(-3)") == 5.5);
  CHECK(evaluate("1 < 2 ? 10 : 20") == 10.0);
  CHECK(evaluate("(1 == 1) + (1 != 1) + (2 >= 2) + (1 <= 0)") == 2.0);
  CHECK(evaluate(".5 + 1. + 1.5e3 + 2E-1") == .5 + 1. + 1.5e3 + 2e-1);
  CHECK(evaluate("log(_e^2)") == Approx(2.0));  // the natural logarithm
  CHECK(evaluate("log10(1000)") == Approx(3.0));
}

TEST_CASE("pi is defined to the last digit") {
  CHECK(evaluate("pi") == std::numbers::pi);
  CHECK(evaluate("_pi") == std::numbers::pi);
  CHECK(evaluate("_e") == std::numbers::e);
}

TEST_CASE("a number in an expression is the double nearest to its text") {
  CHECK(evaluate("0.1") == 0.1);
  CHECK(evaluate("2.2250738585072014e-308") == 2.2250738585072014e-308);
  CHECK(evaluate("9007199254740993") == 9007199254740992.0);
}

TEST_CASE("variables take their values in the order in which they were named") {
  const Names variables = {"t", "T", "FLIM.sleeve"};
  const auto expression = Expression::compile("10*FLIM.sleeve + T - t", variables, kParameters);
  REQUIRE(expression);
  CHECK((*expression)(std::vector{1.0, 5.0, 2.0}).value() == 24.0);
  CHECK((*expression)(std::vector{2.0, 7.0, 3.0}).value() == 35.0);
}

TEST_CASE("an expression knows which variables it uses") {
  const Names variables = {"t", "T", "x"};
  const auto expression = Expression::compile("= x*mu + t*x", variables, kParameters);
  REQUIRE(expression);
  CHECK(expression->uses("t"));
  CHECK(expression->uses("x"));
  CHECK_FALSE(expression->uses("T"));
  CHECK_FALSE(expression->uses("mu"));
  const auto used = expression->used_variables();
  CHECK(Names(used.begin(), used.end()) == Names{"x", "t"});
  CHECK(expression->text() == "= x*mu + t*x");
}

TEST_CASE("a copy of an expression works after the original is gone") {
  const Names variables = {"x"};
  auto original = Expression::compile("x^2 + mu", variables, kParameters);
  REQUIRE(original);
  const Expression copy = *original;
  Expression assigned = *Expression::compile("1", {}, {});
  assigned = copy;
  *original = *Expression::compile("7", {}, {});
  CHECK(copy(std::vector{3.0}).value() == 9.15);
  CHECK(assigned(std::vector{2.0}).value() == 4.15);
}

TEST_CASE("an expression of very many names is compiled as fast as it is read") {
  // To compare each name with all others, 300 times, took more than ten seconds.
  Names names;
  std::string sum = "0";
  std::vector<double> values;
  const std::string letters = "abcdefghijklmnopqrsuvwxyzABCDEFGHIJKLMNOPQRSUVWXYZ";
  for (const char first : letters) {
    for (const char second : letters + "0123456789") {
      const std::string name{first, second};
      if (is_reserved_name(name) || names.size() == 2900) continue;
      names.push_back(name);
      values.push_back(1.0);
      sum += "+" + name;
    }
  }
  REQUIRE(names.size() == 2900);
  for (int i = 0; i < 300; ++i) {
    const auto expression = Expression::compile(sum, names);
    REQUIRE(expression);
    if (i > 0) continue;
    CHECK((*expression)(values).value() == 2900.0);
    CHECK(expression->used_variables().size() == 2900);
    CHECK(expression->used_variables()[2899] == names[2899]);
  }
}

TEST_CASE("an unknown name is reported with its name and position") {
  const ExpressionError error = compile_error("= 2/l1 + mu");
  CHECK(error.unknown_name == "l1");
  CHECK(error.offset == 4);
  CHECK(error.message == "unknown name 'l1'");
  const ExpressionError call = compile_error("sine(mu)");
  CHECK(call.unknown_name == "sine");
  CHECK(call.offset == 0);
  CHECK(call.message == "unknown function 'sine'");
}

TEST_CASE("a syntax error is reported at its position") {
  CHECK(compile_error("2 * * 3").offset == 4);
  CHECK(compile_error("= 2 mu").offset == 4);
  CHECK(compile_error("(1 + 2").message == "a ')' is missing");
  CHECK(compile_error("2**3").message == "a power is written '^', not '**'");
  CHECK(compile_error("1 + 2)").offset == 5);
  CHECK(compile_error("1 +").message == "the expression ends too early");
  CHECK(compile_error("min()").message.find("too few arguments") == 0);
  CHECK(compile_error("sin(1, 2)").message.find("too many arguments") == 0);
  CHECK(compile_error("2 + sin").message == "sin is a function: write sin(...)");
  CHECK(compile_error("5%").offset == 1);
  CHECK(compile_error("").message == "the expression is empty");
  CHECK(compile_error(" =  ").message == "the expression is empty");
  for (const char* text :
       {"1;2", "mu(2)", "3!", "1 2",   "mu mu", "#", "$",  "{1}", "a.b", "1?2",
        "?:",  "1 : 2", "()", "sin()", ")",     "+", "\\", "`",   "@",   "if(1,2,3)"}) {
    const ExpressionError error = compile_error(text);
    CHECK_FALSE(error.message.empty());
    CHECK(error.offset <= static_cast<int>(std::string(text).size()));
  }
}

TEST_CASE("a number that a case file would refuse is refused in an expression too") {
  for (const char* text :
       {"010", "0x10", "1_000", "1.5D3", "1.2.3", "2e", "2pi", "1e400", "1e-400", "1.5mm", "00"}) {
    const ExpressionError error = compile_error(std::string("1 + ") + text);
    CHECK(error.offset == 4);
    CHECK(error.message.find(text) != std::string::npos);
  }
  CHECK(compile_error("1e400").message == "the number 1e400 is outside the range of a double");
  CHECK(compile_error("nan").unknown_name == "nan");
  CHECK(compile_error("inf").unknown_name == "inf");
}

TEST_CASE("a comma outside a function call is refused") {
  for (const char* text : {"1,5", "(1,5)", "min(1, (2,3))", "sin(1),2"}) {
    CHECK(compile_error(text).message.find("the decimal mark is '.'") != std::string::npos);
  }
  CHECK(compile_error("1,5").offset == 1);
}

TEST_CASE("assignments, strings and control characters are refused") {
  CHECK(compile_error("mu = 1").offset == 3);
  CHECK(compile_error("mu=mu=1").offset == 2);
  CHECK(compile_error("== 1").offset >= 0);
  CHECK(compile_error("\"mu\"").message == "an expression has no strings");
  CHECK(compile_error("'mu'").message == "an expression has no strings");
  CHECK(compile_error(std::string("1\0+1", 4)).offset == 1);
  CHECK(compile_error("1 + \xc2\xb5").offset == 4);
}

TEST_CASE("a division by zero is an error, also where the result would hide it") {
  CHECK(evaluation_error("1/zero").message == "1/zero divides by zero");
  CHECK(evaluation_error("= 1/(mu - 0.15)").message == "1/(mu - 0.15) divides by zero");
  CHECK(evaluation_error("1/0").message == "1/0 divides by zero");
  CHECK(evaluation_error("min(1/0, 3)").message == "min(1/0, 3) divides by zero");
  CHECK(evaluation_error("1/(1 + 1/zero)").message == "1/(1 + 1/zero) divides by zero");
  CHECK(evaluate("zero > 0 ? 1/zero : 3") == 3.0);
}

TEST_CASE("a result that is not a finite number is an error that names the variables' values") {
  const Names variables = {"t", "T"};
  const auto expression = Expression::compile("sqrt(1 - t)", variables, {});
  REQUIRE(expression);
  CHECK((*expression)(std::vector{0.75, 0.0}).value() == 0.5);
  CHECK((*expression)(std::vector{2.0, 0.0}).error().message ==
        "sqrt(1 - t) is not defined (0/0, or a root or logarithm of a negative number) at t = 2");
  CHECK((*expression)(std::vector{0.75, 0.0}).value() == 0.5);
  CHECK(evaluation_error("10^400").message == "10^400 exceeds the range of a double");
  CHECK(evaluation_error("0/0").message.find("not defined") != std::string::npos);
  CHECK(evaluation_error("log(-1)").message.find("not defined") != std::string::npos);
  CHECK_FALSE((*expression)(std::vector{std::numeric_limits<double>::quiet_NaN(), 0.0}));
}

TEST_CASE("a decimal comma in the locale changes nothing in an expression") {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const double value = evaluate("min(1.5, 2.25) + 1234.5");
  const bool refused = !Expression::compile("1,5", {}, {});
  std::locale::global(before);
  CHECK(value == 1236.0);
  CHECK(refused);
  // Where the system has a locale of that kind, the C library's functions are tried as well.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;
    const double in_c_locale = evaluate("min(1.5, 2.25) + 1234.5");
    std::setlocale(LC_ALL, "C");
    CHECK(in_c_locale == 1236.0);
  }
}

TEST_CASE("names with a meaning of their own are reserved") {
  for (const char* name : {"pi", "t", "T", "sin", "min", "_e", "_pi"}) {
    CHECK(is_reserved_name(name));
  }
  CHECK_FALSE(is_reserved_name("mu"));
  CHECK_FALSE(is_reserved_name("Pi"));
  CHECK(is_identifier("mu_s2"));
  CHECK(is_identifier("_x"));
  for (const char* name : {"", "2a", "a b", "a.b", "a-b", "\xc2\xb5"}) {
    CHECK_FALSE(is_identifier(name));
  }
}

}  // namespace
}  // namespace slipbench::driver::base
