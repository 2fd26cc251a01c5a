// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace slipbench::driver::base::json {

class Value;

/// A JSON array.
using Array = std::vector<Value>;
/// A JSON object; its members keep the order in which they were written.
using Object = std::vector<std::pair<std::string, Value>>;

/// A JSON value, to be built and written (RFC 8259); nothing here reads JSON.
class Value {
 public:
  Value() = default;
  Value(std::nullptr_t) {}
  Value(bool value) : data_(value) {}
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) Value(Number value)
      : data_(static_cast<double>(value)) {}
  Value(std::string value) : data_(std::move(value)) {}
  Value(std::string_view value) : data_(std::string(value)) {}
  Value(const char* value) : data_(std::string(value)) {}
  Value(Array value) : data_(std::move(value)) {}
  Value(Object value) : data_(std::move(value)) {}

  /// The member of that name of an object; it is appended as null if there is none. A null becomes
  /// an object. Anything else must not be asked for a member.
  Value& operator[](std::string_view name);
  /// Appends to an array; a null becomes an array.
  void push_back(Value value);

  /// The text, with a line feed and `indent` blanks for each level; in one line if `indent` is
  /// negative. Numbers are the shortest text that reads back to the same double. What JSON has no
  /// number for (infinities, not-a-number) becomes null; bytes that are no UTF-8 become U+FFFD.
  std::string dump(int indent = -1) const;

 private:
  void append(std::string& text, int indent, int level) const;

  std::variant<std::monostate, bool, double, std::string, Array, Object> data_;
};

}  // namespace slipbench::driver::base::json
