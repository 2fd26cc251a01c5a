// SPDX-License-Identifier: Apache-2.0
// replay TARGET [--large BYTES|--numbers] FILE|FOLDER..: gives a target the files, and every file
// of the folders. With --large what grows out of them instead: each file again and again, and each
// kind of line, and of list in a line, again and again in its place, up to so many bytes: as it is,
// with numbers that count up, with those of a table whose blocks share no points, with names of
// their own. With --numbers each number of each file, one after the other, as what nobody means. An
// input that takes 2 s is a fault, and so are 256 MB at any time; a program that is not optimised,
// or has sanitizers, may take 20 s, and with sanitizers any memory. Exit code 1 for such a fault, 2
// if there is no such target, no file, or one that cannot be read; a target that breaks a promise,
// or does not end, ends the program.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/fuzz/fuzz_target.hpp"

#ifndef __has_feature
#define __has_feature(feature) 0  // g++ defines a macro for each sanitizer instead
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
#define SLIPBENCH_SANITIZED
// The scanner of UDUNITS-2 loses a word of a unit that it cannot read.
extern "C" const char* __lsan_default_suppressions() { return "leak:utlex"; }
#endif

namespace slipbench::fuzz {
namespace {

std::map<std::string_view, Target>& targets() {
  static std::map<std::string_view, Target> all;
  return all;
}

#if defined(__OPTIMIZE__) && !defined(SLIPBENCH_SANITIZED)
constexpr double kLongest = 2.0;  // s of a processor
#else
constexpr double kLongest = 20.0;
#endif
#ifndef SLIPBENCH_SANITIZED
constexpr long kMost = 256L * 1024;  // KB
#else
constexpr long kMost = std::numeric_limits<long>::max();  // what is freed stays with the sanitizer
#endif
constexpr std::size_t kShape = 10;  // characters that tell one kind of line from another

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Way in which the copies of a piece differ.
enum class Copies {
  kSame,
  kCounting,  ///< each number is one more than that of the copy before
  kBlocks,    ///< rows of a table in blocks of two that share no points, over blocks of two, ..
  kNamed      ///< the first word has the number of the copy
};

/// Returns what the number `index` of `count` of a piece is in its copy k.
double in_copy(Copies copies, double number, std::size_t k, std::size_t index, std::size_t count) {
  if (copies == Copies::kCounting) return number + static_cast<double>(k);
  if (index == 0) return 0.1 * static_cast<double>(1 + k % 7);  // what depends on the others
  const std::size_t block = k >> (index - 1);
  const bool is_last = index + 1 == count;
  return static_cast<double>(is_last ? block : block % 2) + 1e-6 * static_cast<double>(block);
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Returns the length of the number that begins at `at`, 0 if none does.
std::size_t number_at(const std::string& text, std::size_t at) {
  if (at > 0 && (is_of_word(text[at - 1]) || text[at - 1] == '.')) return 0;
  if (std::string_view("+-.0123456789").find(text[at]) == std::string_view::npos) return 0;
  char* end = nullptr;
  std::strtod(text.c_str() + at, &end);
  return static_cast<std::size_t>(end - (text.c_str() + at));
}

/// Stretches of a text: begin and length.
using Stretches = std::vector<std::pair<std::size_t, std::size_t>>;

Stretches numbers_in(const std::string& piece) {
  Stretches found;
  for (std::size_t at = 0; at < piece.size(); ++at) {
    const std::size_t length = number_at(piece, at);
    if (length > 0) found.emplace_back(at, length);
    at += length > 0 ? length - 1 : 0;
  }
  return found;
}

/// Returns copy k of a piece; a number that has room stays in its columns.
std::string copy_of(const std::string& piece, const Stretches& numbers, Copies copies,
                    std::size_t k) {
  if (copies == Copies::kNamed) {
    const auto first = std::find_if(piece.begin(), piece.end(), is_of_word);
    const auto end = std::find_if_not(first, piece.end(), is_of_word);
    return std::string(piece.begin(), end) + std::to_string(k) + std::string(end, piece.end());
  }
  std::string made;
  std::size_t done = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [at, length] = numbers[i];
    made += piece.substr(done, at - done);
    done = at + length;
    std::array<char, 32> text{};
    const double old = std::strtod(piece.c_str() + at, nullptr);
    std::snprintf(text.data(), text.size(), "%.15g", in_copy(copies, old, k, i, numbers.size()));
    const std::string number = text.data();
    for (std::size_t more = length; more < number.size(); ++more) {
      if (made.size() > 1 && made.back() == ' ' && made[made.size() - 2] == ' ') made.pop_back();
    }
    if (number.size() < length) made.append(length - number.size(), ' ');
    made += number;
  }
  return made + piece.substr(done);
}

/// Returns a text with copies of the piece from `begin` to `end`, as many as fit into `most` bytes.
std::string grown(const std::string& text, std::size_t begin, std::size_t end, std::size_t most,
                  Copies copies) {
  std::string made = text.substr(0, begin);
  const std::string piece = text.substr(begin, end - begin);
  const Stretches numbers = copies == Copies::kSame ? Stretches{} : numbers_in(piece);
  const std::size_t rest = text.size() - end;
  std::string next = copies == Copies::kBlocks ? copy_of(piece, numbers, copies, 0) : piece;
  for (std::size_t k = 1; made.size() + next.size() + rest <= most; ++k) {
    made += next;
    next = copies == Copies::kSame ? piece : copy_of(piece, numbers, copies, k);
  }
  return made + text.substr(end);
}

/// Returns the lists in a line that hold no other and are followed by a comma, with it.
Stretches lists_in(const std::string& line) {
  Stretches found;
  std::size_t open = std::string::npos;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '[' || line[at] == '{') open = at;
    if (line[at] != ']' && line[at] != '}') continue;
    if (open != std::string::npos && at + 1 < line.size() && line[at + 1] == ',') {
      found.emplace_back(open, at + 2 - open);
    }
    open = std::string::npos;
  }
  return found;
}

/// Record of the inputs that were tried.
struct Tried {
  std::set<std::string> shapes;  ///< kinds of lines that need not be tried again
  long most = kMost;             ///< KB that were in use, or may be
};

/// The input that a target has, for one that ends the program, or does not end.
std::string& now_tried() {
  static std::string what;
  return what;
}

extern "C" void tell_input(int signal) {
  const std::string& what = now_tried();
  const std::string_view end = signal == SIGALRM ? "\n  does not end\n" : "\n";
  static_cast<void>(write(STDOUT_FILENO, what.data(), what.size()) +
                    write(STDOUT_FILENO, end.data(), end.size()));
  _exit(1);
}

/// Feeds a target; returns how many faults that is, 1 if the input took too much.
/// \param what the input is, behind what it took
int feed(Target target, std::string_view input, std::string_view what, Tried* tried) {
  now_tried() = what;
  for (const int signal : {SIGALRM, SIGABRT, SIGSEGV}) std::signal(signal, tell_input);
  alarm(static_cast<unsigned>(20.0 * kLongest));
  const double before = processor_seconds();
  target(input);
  const double took = processor_seconds() - before;
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  if (took <= kLongest && used.ru_maxrss <= tried->most) return 0;
  tried->most = std::max(tried->most, used.ru_maxrss);
  std::cout << "  too much: " << took << " s, " << used.ru_maxrss / 1024 << " MB so far" << what
            << std::endl;
  return 1;
}

/// Returns what one kind of piece has in common: how it begins, and how many numbers it has.
std::string shape_of(std::string piece) {
  const std::size_t numbers = numbers_in(piece).size();
  piece.erase(0, piece.find_first_not_of(' '));
  for (char& c : piece) c = std::isdigit(static_cast<unsigned char>(c)) != 0 ? '0' : c;
  return piece.substr(0, kShape) + ' ' + std::to_string(numbers);
}

/// Returns where the lines before and behind one begin and end that are rows of its table: as many
/// entries behind the same beginning.
Stretches::value_type rows_of_table(const std::string& text, std::size_t begin, std::size_t end) {
  const auto form = [&](std::size_t from, std::size_t to) {
    const std::string line = text.substr(from, to - from);
    const std::size_t first = line.find_first_not_of(' ');
    const bool is_number = line.find_first_of("+.0123456789", first) == first;
    return std::tuple(first, is_number || first == std::string::npos ? '0' : line[first],
                      std::count(line.begin(), line.end(), ','));
  };
  const auto own = form(begin, end);
  while (begin > 0) {
    const std::size_t before = begin < 2 ? 0 : text.rfind('\n', begin - 2) + 1;
    if (form(before, begin) != own) break;
    begin = before;
  }
  while (end < text.size()) {
    const std::size_t behind = std::min(text.find('\n', end), text.size() - 1) + 1;
    if (form(end, behind) != own) break;
    end = behind;
  }
  return {begin, end};
}

/// Feeds a target with what grows out of a text; returns how many inputs took too much.
int feed_large(Target target, const std::string& text, std::size_t most, Tried* tried) {
  int faults = 0;
  const auto feed_grown = [&](std::string_view what, const std::string& made) {
    faults += feed(target, made, ", with this again and again: " + std::string(what.substr(0, 60)),
                   tried);
  };
  const auto feed_copies = [&](std::size_t begin, std::size_t end, bool is_line) {
    const std::string piece = text.substr(begin, end - begin);
    if (!tried->shapes.insert(shape_of(piece)).second) return;
    for (const Copies copies : {Copies::kSame, Copies::kCounting, Copies::kNamed}) {
      feed_grown(piece, grown(text, begin, end, most, copies));
    }
    if (!is_line || numbers_in(piece).size() < 2) return;
    // In place of the table's own rows: it would not be in order with them.
    const auto [first, last] = rows_of_table(text, begin, end);
    const std::string table = text.substr(0, first) + piece + text.substr(last);
    feed_grown(piece, grown(table, first, first + piece.size(), most, Copies::kBlocks));
  };
  if (text.empty()) return 0;
  feed_grown(text, grown(text, 0, text.size(), most, Copies::kSame));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    for (const auto& [at, length] : lists_in(text.substr(begin, end - begin))) {
      feed_copies(begin + at, begin + at + length, false);
    }
    feed_copies(begin, end, true);
    begin = end;
  }
  return faults;
}

/// Feeds a target with a text in which each number, one after the other, is one of these.
int feed_numbers(Target target, const std::string& text, Tried* tried) {
  int faults = 0;
  for (const auto& [at, length] : numbers_in(text)) {
    for (const std::string_view number : {"0", "-1", "0.3", "1e-320", "1e-30", "1e7", "2147483648",
                                          "1e20", "-1e20", "1e308", "-1e308", ".inf", "nan"}) {
      const std::string made = text.substr(0, at) + std::string(number) + text.substr(at + length);
      const std::size_t line = text.rfind('\n', at) + 1;
      faults += feed(target, made,
                     ", with " + std::string(number) +
                         " for the number at the end of: " + text.substr(line, at + length - line),
                     tried);
    }
  }
  return faults;
}

/// Source of what a target is fed with: files as they are, what grows out of them, or other
/// numbers.
enum class Mode { kPlain, kLarge, kNumbers };

/// Feeds a target with files, and with all files of folders, the inputs of each in the order of
/// their names.
/// \param most bytes of what grows out of them
int replay(const std::string& name, Mode mode, std::size_t most,
           const std::vector<std::filesystem::path>& places) {
  const auto target = targets().find(name);
  if (target == targets().end()) {
    std::cerr << "there is no target " << name << '\n';
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& place : places) {
    if (!std::filesystem::is_directory(place)) {
      files.push_back(place);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(place)) files.push_back(entry);
  }
  std::sort(files.begin(), files.end());
  for (std::filesystem::path& file : files) file = std::filesystem::absolute(file);
  int faults = 0;
  Tried tried;
  for (const std::filesystem::path& file : files) {
    std::cout << file.filename().string() << std::endl;  // the one at which it ends stands last
    std::ifstream in(file, std::ios::binary);
    if (!in) {
      std::cerr << "it cannot be read\n";
      return 2;
    }
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    switch (mode) {
      case Mode::kPlain:
        faults += feed(target->second, bytes, "", &tried);
        break;
      case Mode::kLarge:
        faults += feed_large(target->second, bytes, most, &tried);
        break;
      case Mode::kNumbers:
        faults += feed_numbers(target->second, bytes, &tried);
        break;
    }
  }
  std::cout << files.size() << (mode == Mode::kPlain ? " inputs of " : " files, changed, of ")
            << name << '\n';
  if (files.empty()) return 2;
  return faults == 0 ? 0 : 1;
}

}  // namespace

Registered::Registered(std::string_view name, Target target) { targets().emplace(name, target); }

}  // namespace slipbench::fuzz

int main(int count, char** words) {
  using slipbench::fuzz::Mode;
  const std::string_view option = count > 2 ? words[2] : "";
  const Mode mode = option == "--large"     ? Mode::kLarge
                    : option == "--numbers" ? Mode::kNumbers
                                            : Mode::kPlain;
  const int first = mode == Mode::kLarge ? 4 : mode == Mode::kNumbers ? 3 : 2;
  if (count <= first) {
    std::cerr << "usage: fuzz_replay TARGET [--large BYTES|--numbers] FILE|FOLDER..\n";
    return 2;
  }
  const std::size_t most = mode == Mode::kLarge ? std::strtoull(words[3], nullptr, 10) : 0;
  return slipbench::fuzz::replay(words[1], mode, most, {words + first, words + count});
}
