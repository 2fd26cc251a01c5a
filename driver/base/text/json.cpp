// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::base::json {
namespace {

void append_string(std::string& text, std::string_view value) {
  text += '"';
  while (!value.empty()) {
    const CodePoint point = decode_utf8(value);
    const std::string_view bytes = value.substr(0, point.length);
    value.remove_prefix(point.length);
    if (!point.valid) {
      text += "\xEF\xBF\xBD";
    } else if (point.value == '"' || point.value == '\\') {
      text += '\\';
      text += bytes;
    } else if (point.value == '\n') {
      text += "\\n";
    } else if (point.value == '\t') {
      text += "\\t";
    } else if (point.value < 0x20 || point.value == 0x7F) {
      text += fmt::format("\\u{:04x}", point.value);
    } else {
      text += bytes;
    }
  }
  text += '"';
}

void append_line(std::string& text, int indent, int level) {
  if (indent < 0) return;
  text += '\n';
  text.append(static_cast<std::size_t>(indent) * static_cast<std::size_t>(level), ' ');
}

}  // namespace

Value& Value::operator[](std::string_view name) {
  if (std::holds_alternative<std::monostate>(data_)) data_ = Object{};
  auto& object = std::get<Object>(data_);
  const auto found = std::find_if(object.begin(), object.end(),
                                  [&](const auto& member) { return member.first == name; });
  if (found != object.end()) return found->second;
  return object.emplace_back(std::string(name), Value()).second;
}

void Value::push_back(Value value) {
  if (std::holds_alternative<std::monostate>(data_)) data_ = Array{};
  std::get<Array>(data_).push_back(std::move(value));
}

std::string Value::dump(int indent) const {
  std::string text;
  append(text, indent, 0);
  return text;
}

void Value::append(std::string& text, int indent, int level) const {
  const std::string_view separator = indent < 0 ? ", " : ",";
  if (const auto* flag = std::get_if<bool>(&data_)) {
    text += *flag ? "true" : "false";
  } else if (const auto* number = std::get_if<double>(&data_)) {
    if (std::isfinite(*number)) {
      append_number(text, *number);
    } else {
      text += "null";
    }
  } else if (const auto* string = std::get_if<std::string>(&data_)) {
    append_string(text, *string);
  } else if (const auto* array = std::get_if<Array>(&data_)) {
    text += '[';
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (i > 0) text += separator;
      append_line(text, indent, level + 1);
      (*array)[i].append(text, indent, level + 1);
    }
    if (!array->empty()) append_line(text, indent, level);
    text += ']';
  } else if (const auto* object = std::get_if<Object>(&data_)) {
    text += '{';
    for (std::size_t i = 0; i < object->size(); ++i) {
      if (i > 0) text += separator;
      append_line(text, indent, level + 1);
      append_string(text, (*object)[i].first);
      text += ": ";
      (*object)[i].second.append(text, indent, level + 1);
    }
    if (!object->empty()) append_line(text, indent, level);
    text += '}';
  } else {
    text += "null";
  }
}

}  // namespace slipbench::driver::base::json
