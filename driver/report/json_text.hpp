// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace slipbench::driver::report {

/// Writes JSON (RFC 8259) piece by piece and without blanks, to be embedded in a page: '<' and the
/// line separators of Unicode are escaped, so that no text ends a script element. Numbers have ten
/// significant digits, or as many as told; what is not finite is null.
class JsonText {
 public:
  void begin_object() { open('{'); }
  void end_object() { close('}'); }
  void begin_array() { open('['); }
  void end_array() { close(']'); }
  /// The name of the next value, in an object.
  void key(std::string_view name);

  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(double number) { value(number, kDigits); }
  void value(double number, int digits);
  void value(std::int64_t number);
  /// A number with as many digits as tell it from any other.
  void exact(double number);
  void value(bool flag);
  void null();
  /// An array of numbers, with the digits that keep its shape (SeriesDigits).
  void series(std::span<const double> numbers);

  template <class Value>
  void member(std::string_view name, const Value& what) {
    key(name);
    value(what);
  }
  /// A member that is an array of texts.
  template <class Texts>
  void member_texts(std::string_view name, const Texts& texts) {
    key(name);
    begin_array();
    for (const auto& text : texts) value(text);
    end_array();
  }
  /// A member whose text is left out when it is empty.
  void member_if(std::string_view name, std::string_view text) {
    if (!text.empty()) member(name, text);
  }

  static constexpr int kDigits = 10;

  std::string take() { return std::move(text_); }

 private:
  void open(char bracket);
  void close(char bracket);
  void separate();
  std::string text_;
  bool first_ = true;  ///< nothing stands yet behind the last bracket or key
};

}  // namespace slipbench::driver::report
