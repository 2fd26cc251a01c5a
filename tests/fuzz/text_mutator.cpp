// SPDX-License-Identifier: Apache-2.0
// Changes of texts that libFuzzer, which changes bytes, seldom makes: another number, a line less
// or twice. So a case stays a case, and the numbers reach the law.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::array<std::string_view, 32> kNumbers = {
    "0",          "1",          "-1",
    "0.5",        "2",          "3",
    "10",         "1e-3",       "1e3",
    "1e6",        "1e9",        "1e12",
    "1e-12",      "1e100",      "1e-100",
    "1e308",      "-1e308",     "1e-308",
    "5e-324",     "-0",         "1e15",
    "0.1",        "0.999999",   "1.0000001",
    "2147483648", "4294967296", "9007199254740993",
    "1000000",    "65536",      "255",
    "7",          "6"};

/// Range of a text, from `begin` up to `end`.
struct Piece {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; }

/// The numbers of a text, each with its sign and exponent.
std::vector<Piece> numbers_of(const std::string& text) {
  std::vector<Piece> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = std::isdigit(static_cast<unsigned char>(text[i])) != 0 &&
                        (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0);
    if (!starts) continue;
    std::size_t end = i;
    while (end < text.size() && in_number(text[end])) ++end;
    if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
      std::size_t digits = end + 1;
      if (text[digits] == '-' || text[digits] == '+') ++digits;
      while (digits < text.size() && in_number(text[digits])) ++digits;
      end = digits;
    }
    found.push_back({i > 0 && text[i - 1] == '-' ? i - 1 : i, end});
    i = end;
  }
  return found;
}

std::vector<Piece> lines_of(const std::string& text) {
  std::vector<Piece> found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    found.push_back({begin, end});
    begin = end;
  }
  return found;
}

void change(std::string& text, std::minstd_rand& dice) {
  const auto one_of = [&](std::size_t count) { return dice() / 7 % count; };
  const std::size_t what = one_of(8);
  if (what < 5) {
    const std::vector<Piece> numbers = numbers_of(text);
    if (numbers.empty()) return;
    const Piece number = numbers[one_of(numbers.size())];
    const Piece other = numbers[one_of(numbers.size())];
    const std::string put = what == 0 ? text.substr(other.begin, other.end - other.begin)
                                      : std::string(kNumbers[one_of(kNumbers.size())]);
    text.replace(number.begin, number.end - number.begin, put);
    return;
  }
  const std::vector<Piece> lines = lines_of(text);
  if (lines.empty()) return;
  const Piece line = lines[one_of(lines.size())];
  const Piece place = lines[one_of(lines.size())];
  const std::string words = text.substr(line.begin, line.end - line.begin);
  if (what == 5) text.erase(line.begin, words.size());
  if (what == 6) text.insert(place.begin, words);
  if (what == 7) text.replace(place.begin, place.end - place.begin, words);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  std::minstd_rand dice(seed);
  if (dice() / 7 % 3 == 0) return LLVMFuzzerMutate(data, size, most);
  std::string text(reinterpret_cast<const char*>(data), size);
  for (std::size_t times = 1 + dice() / 7 % 3; times > 0; --times) change(text, dice);
  const std::size_t length = std::min(text.size(), most);
  std::memcpy(data, text.data(), length);
  return length;
}
