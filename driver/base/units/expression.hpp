// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace slipbench::driver::base {

/// Numbers with names: the parameters of a case.
using NamedNumbers = std::map<std::string, double, std::less<>>;

/// So many characters a formula has, at most: it is what muParser reads.
inline constexpr std::size_t kLongestFormula = 10'000;

/// Reason why an expression could not be read or evaluated.
struct ExpressionError {
  std::string message;       ///< What was found and what was wanted.
  int offset = -1;           ///< Byte in the given text, counted from 0; -1 when unknown.
  std::string unknown_name;  ///< The name that is not defined, for suggesting the nearest one.
};

/// A formula over named numbers, e.g. `2/li + 0.1*sin(2*pi*t)`: compiled once, evaluated often.
///
/// Operators, functions and their precedence are muParser's: + - * / ^, comparisons, && ||, a ? b
/// : c, and the functions of `function_names` (log is the natural logarithm, angles are radians).
/// `pi`, `_pi` and `_e` are defined. The decimal mark is '.' and the argument separator ','
/// whatever the locale. Not accepted: assignments, strings, a comma outside a function call, and
/// numbers that a case file does not accept either (010, 0x10, 1e400, 1_000).
///
/// An expression is a value: a copy has a compiled program of its own. One instance must not be
/// evaluated by two threads at once; give each thread its copy.
class Expression {
 public:
  /// Compiles `text`, in which a leading '=' (as a case file writes it) is skipped.
  ///
  /// `variables` are the names that get their values at evaluation, in this order; `constants`
  /// keep theirs. A name may hold dots (result columns do). A variable hides a constant of the
  /// same name, and both hide `pi`. Errors: an unknown name, a syntax error, an empty text.
  static tl::expected<Expression, ExpressionError> compile(std::string_view text,
                                                           std::span<const std::string> variables,
                                                           const NamedNumbers& constants = {});

  Expression(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression& other);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// The value for `values`, one for each of the variables given to `compile` and in that order.
  /// Allocates nothing when it succeeds. An error, never a NaN or an infinity: a division by zero
  /// (also one whose result a later operation would hide), a root of a negative number, a result
  /// out of a double's range.
  tl::expected<double, ExpressionError> operator()(std::span<const double> values) const;

  /// Tells whether the text mentions the variable `name`.
  bool uses(std::string_view name) const;

  /// The variables the text mentions, in the order in which they first appear.
  std::span<const std::string> used_variables() const;

  /// The text given to `compile`.
  const std::string& text() const;

 private:
  struct Program;
  explicit Expression(std::unique_ptr<Program> program);
  std::unique_ptr<Program> program_;
};

/// The functions an expression may call, sorted by name.
const std::vector<std::string>& function_names();

/// Tells whether `name` can name a parameter: a letter or '_', then letters, digits and '_'.
bool is_identifier(std::string_view name);

/// Tells whether an expression gives `name` a meaning of its own: pi, _pi, _e, t, T, a function's
/// name.
bool is_reserved_name(std::string_view name);

}  // namespace slipbench::driver::base
