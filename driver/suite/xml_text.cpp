// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/xml_text.hpp"

#include <cstdint>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::suite {
namespace {

bool is_xml_character(std::uint32_t c) { return c >= 0x20 || c == '\t' || c == '\n' || c == '\r'; }

std::string escaped(std::string_view text, bool attribute) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const base::CodePoint c = base::decode_utf8(text);
    const std::string_view piece = text.substr(0, c.length);
    text.remove_prefix(c.length);
    // XML has room for what turns the direction of writing; who reads it has a terminal, too.
    const bool harmful = c.value >= 0x7F && base::printable(piece) != piece;
    if (!c.valid || harmful || !is_xml_character(c.value)) {
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
