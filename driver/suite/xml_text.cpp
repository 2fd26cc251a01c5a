// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/xml_text.hpp"

#include <cstdint>

#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::suite {
namespace {

bool is_xml_character(std::uint32_t c) {
  if (c < 0x20) return c == '\t' || c == '\n' || c == '\r';
  return c != 0xFFFE && c != 0xFFFF;
}

std::string escaped(std::string_view text, bool attribute) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const base::CodePoint c = base::decode_utf8(text);
    const std::string_view piece = text.substr(0, c.length);
    text.remove_prefix(c.length);
    if (!c.valid || !is_xml_character(c.value)) {
      result += "\xEF\xBF\xBD";
    } else if (c.value == '<') {
      result += "&lt;";
    } else if (c.value == '>') {
      result += "&gt;";
    } else if (c.value == '&') {
      result += "&amp;";
    } else if (c.value == '"') {
      result += "&quot;";
    } else if (c.value == '\r') {
      result += "&#13;";
    } else if (attribute && c.value == '\n') {
      result += "&#10;";
    } else if (attribute && c.value == '\t') {
      result += "&#9;";
    } else {
      result += piece;
    }
  }
  return result;
}

}  // namespace

std::string xml_text(std::string_view text) { return escaped(text, false); }

std::string xml_attribute(std::string_view text) { return escaped(text, true); }

}  // namespace slipbench::driver::suite
