// SPDX-License-Identifier: Apache-2.0
// The little UTF-8 that messages and readers need.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// One decoded character: `length` bytes were taken; `valid` is false for a byte that does not
/// begin a well-formed sequence (overlong forms, surrogates and values above U+10FFFF included), in
/// which case length is 1.
struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 1;
  bool valid = false;
};

/// Tells whether a byte goes on with a character that began before it.
[[nodiscard]] constexpr bool continues_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Returns the begin of a text: `most` bytes, or fewer where they would end inside a character.
[[nodiscard]] constexpr std::string_view whole_characters(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && continues_character(text[most])) --most;
  return text.substr(0, most);
}

/// Decodes the character at the front of a text that is not empty (RFC 3629).
[[nodiscard]] constexpr CodePoint decode_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {lead, 1, false};
  std::uint32_t value = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues_character(text[i])) return {lead, 1, false};
    value = (value << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (overlong || surrogate || value > 0x10FFFF) return {lead, 1, false};
  return {value, length, true};
}

/// Returns how many code points a text has; a byte that is no UTF-8 counts as one.
[[nodiscard]] constexpr std::size_t count_code_points(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    // Most text is ASCII; a long line of it must not cost a decoding for each letter.
    std::size_t ascii = 0;
    while (ascii < text.size() && static_cast<unsigned char>(text[ascii]) < 0x80) ++ascii;
    count += ascii;
    text.remove_prefix(ascii);
    if (text.empty()) break;
    text.remove_prefix(decode_utf8(text).length);
    ++count;
  }
  return count;
}

/// Makes a text of bytes: those that are no UTF-8 are taken as Latin-1, and control characters but
/// tabs and line feeds become blanks.
[[nodiscard]] inline std::string as_text(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const CodePoint one = decode_utf8(bytes);
    const bool control = (one.value < 0x20 && one.value != '\n' && one.value != '\t') ||
                         (one.value >= 0x7F && one.value < 0xA0);
    if (control) {
      text += ' ';
    } else if (one.valid) {
      text += bytes.substr(0, one.length);
    } else {
      text += static_cast<char>(0xC0U | (one.value >> 6U));
      text += static_cast<char>(0x80U | (one.value & 0x3FU));
    }
    bytes.remove_prefix(one.length);
  }
  return text;
}

}  // namespace slipbench::driver::base
