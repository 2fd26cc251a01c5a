// SPDX-License-Identifier: Apache-2.0
#include "driver/table/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include "driver/base/csv/csv_fields.hpp"

namespace slipbench::driver::table {
namespace {

constexpr std::string_view kMagic("\x93NUMPY");
constexpr std::size_t kAlignment = 64;

/// Takes a word from the front of a text, if it stands there.
bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

std::optional<std::uint64_t> take_number(std::string_view& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// Takes a text of Python, '..' or "..", in which nothing but quotes and \ is written with a \.
std::optional<std::string> take_name(std::string_view& text) {
  if (text.empty() || (text[0] != '\'' && text[0] != '"')) return std::nullopt;
  std::string name;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == text[0]) {
      text.remove_prefix(i + 1);
      return name;
    }
    constexpr std::string_view kEscaped = "'\"\\";
    if (text[i] == '\\' && (++i == text.size() || kEscaped.find(text[i]) == kEscaped.npos)) break;
    name += text[i];
  }
  return std::nullopt;
}

/// Takes the names of a record of doubles, [('a', '<f8'), ..]; none if it is no such record.
std::vector<std::string> take_record(std::string_view& text) {
  std::vector<std::string> names;
  if (!take(text, "[")) return {};
  while (take(text, "(")) {
    auto name = take_name(text);
    if (!name || !take(text, ", '<f8')")) return {};
    names.push_back(std::move(*name));
    take(text, ", ");
  }
  return take(text, "]") ? names : std::vector<std::string>();
}

/// A name as Python writes it.
std::string python_text(std::string_view name) {
  std::string text = "'";
  for (const char c : name) {
    if (c == '\'' || c == '\\') text += '\\';
    text += c;
  }
  return text + "'";
}

}  // namespace

std::string npy_columns(std::span<const std::string> columns) {
  std::string text = "{'descr': [";
  for (const std::string& column : columns)
    text += fmt::format("({}, '<f8'), ", python_text(column));
  return text + "]";
}

tl::expected<std::string, std::string> npy_head(std::span<const std::string> columns,
                                                std::uint64_t rows) {
  std::string head =
      fmt::format("{}, 'fortran_order': False, 'shape': ({},), }}", npy_columns(columns), rows);
  // Version 3 is version 1 but for names beyond ASCII and four bytes of length.
  const bool ascii = std::all_of(head.begin(), head.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  const std::size_t begin = kMagic.size() + 2 + (ascii ? 2 : 4);
  // Room for any number of rows, so that it can be put in when it is known.
  const std::size_t digits = std::numeric_limits<std::uint64_t>::digits10 + 1;
  const std::size_t least = begin + head.size() - fmt::formatted_size("{}", rows) + digits + 1;
  const std::size_t size = (least + kAlignment - 1) / kAlignment * kAlignment;
  const std::size_t length = size - begin;
  if (length > std::numeric_limits<std::uint16_t>::max()) {
    return tl::unexpected(
        fmt::format("{} columns have no room in the head of an .npy file", columns.size()));
  }
  head.append(length - head.size() - 1, ' ');
  std::string text(kMagic);
  text += ascii ? '\1' : '\3';
  text += '\0';
  for (std::size_t i = kMagic.size() + 2; i < begin; ++i) {
    const std::size_t shift = 8 * (i - kMagic.size() - 2);
    text += static_cast<char>((length >> shift) & 0xffU);
  }
  return text + head + "\n";
}

tl::expected<NpyHead, std::string> read_npy_head(std::string_view begin) {
  if (!begin.starts_with(kMagic)) return tl::unexpected<std::string>("is no .npy file");
  const auto byte = [&](std::size_t i) {
    return i < begin.size() ? static_cast<unsigned char>(begin[i]) : 0U;
  };
  const unsigned version = byte(6);
  if (version < 1 || version > 3 || byte(7) != 0) {
    return tl::unexpected<std::string>("is an .npy file of another version than 1.0, 2.0 and 3.0");
  }
  NpyHead head;
  const std::size_t start = version == 1 ? 10 : 12;
  for (std::size_t i = start; i-- > 8;) head.size = head.size << 8U | byte(i);
  head.size += start;
  if (begin.size() < head.size) {
    return tl::unexpected<std::string>("ends within its head, or has too long a one");
  }
  // Names are Latin-1 before version 3.
  const std::string text = base::as_utf8(begin.substr(start, head.size - start));
  std::string_view rest = text;
  const bool known = take(rest, "{'descr': ");
  const bool plain = known && take(rest, "'<f8'");
  if (known && !plain) head.columns = take_record(rest);
  if (!plain && head.columns.empty()) {
    return tl::unexpected<std::string>(
        "is an .npy file, but not of doubles ('<f8') or of records of them");
  }
  const bool in_order = take(rest, ", 'fortran_order': False, 'shape': (");
  const auto rows = in_order ? take_number(rest) : std::nullopt;
  std::uint64_t width = 0;
  bool shaped = rows && take(rest, ",");
  if (shaped && plain) {
    constexpr std::uint64_t kMostColumns = 1'000'000;
    width = take(rest, " ") ? take_number(rest).value_or(0) : 0;
    shaped = width >= 1 && width <= kMostColumns;
  }
  if (!shaped || !take(rest, ")")) {
    return tl::unexpected<std::string>("is an .npy file, but not of rows in C order");
  }
  head.rows = *rows;
  for (std::uint64_t i = 1; i <= width; ++i) head.columns.push_back(fmt::format("c{}", i));
  return head;
}

}  // namespace slipbench::driver::table
