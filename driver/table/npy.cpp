// SPDX-License-Identifier: Apache-2.0
#include "driver/table/npy.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <optional>
#include <regex>

namespace slipbench::driver::table {
namespace {

constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
constexpr std::size_t kAlignment = 64;

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc()) return std::nullopt;
  return value;
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

std::string plain_text(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size()) ++i;
    name += text[i];
  }
  return name;
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
  // Room for any number of rows, so that it can be put in when it is known.
  const std::size_t digits = std::numeric_limits<std::uint64_t>::digits10 + 1;
  const std::size_t least =
      kMagic.size() + 2 + head.size() - fmt::formatted_size("{}", rows) + digits + 1;
  const std::size_t size = (least + kAlignment - 1) / kAlignment * kAlignment;
  const std::size_t length = size - kMagic.size() - 2;
  if (length > std::numeric_limits<std::uint16_t>::max()) {
    return tl::unexpected(
        fmt::format("{} columns have no room in the head of an .npy file", columns.size()));
  }
  head.append(length - head.size() - 1, ' ');
  return std::string(kMagic) + static_cast<char>(length & 0xffU) + static_cast<char>(length >> 8U) +
         head + "\n";
}

tl::expected<NpyHead, std::string> read_npy_head(std::string_view begin) {
  if (!begin.starts_with(kMagic.substr(0, 6)))
    return tl::unexpected<std::string>("is no .npy file");
  if (begin.size() < 10 || !begin.starts_with(kMagic)) {
    return tl::unexpected<std::string>("is an .npy file of another version than 1.0");
  }
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(begin[i]); };
  NpyHead head;
  head.size = kMagic.size() + 2 + byte(8) + (std::size_t{byte(9)} << 8U);
  if (begin.size() < head.size) return tl::unexpected<std::string>("ends within its head");
  const std::string text(begin.substr(10, head.size - 10));
  static const std::regex kShape(R"re('fortran_order': False, 'shape': \((\d+),(?: (\d+))?\))re");
  std::smatch shape;
  const auto rows = std::regex_search(text, shape, kShape) ? number(shape[1].str()) : std::nullopt;
  if (!rows) return tl::unexpected<std::string>("is an .npy file, but not of rows in C order");
  head.rows = *rows;
  if (text.starts_with("{'descr': '<f8'") && shape[2].matched) {
    const auto width = number(shape[2].str());
    for (std::uint64_t i = 1; width && i <= *width; ++i)
      head.columns.push_back(fmt::format("c{}", i));
  } else {
    static const std::regex kColumn(
        R"re(^, \((?:'((?:[^'\\]|\\.)*)'|"((?:[^"\\]|\\.)*)"), '<f8'\))re");
    std::string rest = text.starts_with("{'descr': [") ? ", " + text.substr(11) : "";
    for (std::smatch column; std::regex_search(rest, column, kColumn); rest = column.suffix()) {
      head.columns.push_back(plain_text(column[1].str() + column[2].str()));
    }
    if (!rest.starts_with("]") && !rest.starts_with(", ]")) head.columns.clear();
  }
  if (head.columns.empty()) {
    return tl::unexpected<std::string>(
        "is an .npy file, but not of doubles ('<f8') or of records of them");
  }
  return head;
}

}  // namespace slipbench::driver::table
