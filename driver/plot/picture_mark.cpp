// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/picture_mark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "driver/base/text/standard_input.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

/// A name as it can stand in any comment, also in one of XML, where "--" may not.
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool kept = byte < 0x80 && (std::isalnum(byte) != 0 || c == '_' || c == '.' || c == ' ');
    text += kept ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return text;
}

/// Four bytes, the highest first.
std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(number >> shift);
  return bytes;
}

/// The check sum of a PNG's chunks (CRC-32, polynomial 0xEDB88320).
std::uint32_t check_sum(std::string_view bytes) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

std::string png_chunk(const std::string& kind_and_data) {
  return big_endian(static_cast<std::uint32_t>(kind_and_data.size() - 4)) + kind_and_data +
         big_endian(check_sum(kind_and_data));
}

/// Tells whether a file ends with a text, blanks behind it left aside.
bool ends_with(const fs::path& file, std::string_view text) {
  constexpr std::streamoff kBlanks = 8;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  const std::streamoff begin = size - static_cast<std::streamoff>(text.size()) - kBlanks;
  in.seekg(std::max<std::streamoff>(begin, 0));
  std::string end{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  while (!end.empty() && (end.back() == '\n' || end.back() == ' ')) end.pop_back();
  return end.ends_with(text);
}

}  // namespace

base::FileMark picture_mark(const std::string& input) {
  const std::string name = fs::path(base::source_name(input)).stem().string();
  return {"a picture of " + name, "", "slipbench picture (" + plain(name) + ")"};
}

bool write_mark(const fs::path& picture, std::string_view ending, const std::string& text) {
  const std::string last = png_chunk("IEND");
  if (!ends_with(picture, ending == ".svg" ? "</svg>" : ending == ".pdf" ? "%%EOF" : last)) {
    return false;
  }
  std::string end;
  if (ending == ".svg") end = "<!-- " + text + " -->\n";
  if (ending == ".pdf") end = "% " + text + "\n";
  if (ending == ".png") {
    using namespace std::string_literals;
    fs::resize_file(picture, fs::file_size(picture) - last.size());
    end = png_chunk("tEXtSoftware\0"s + text) + last;
  }
  std::ofstream out(picture, std::ios::binary | std::ios::app);
  out << end;
  out.close();
  return out.good();
}

}  // namespace slipbench::driver::plot
