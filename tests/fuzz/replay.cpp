// SPDX-License-Identifier: Apache-2.0
// replay TARGET [--large BYTES] FILE|FOLDER..: gives a target the files, and every file of the
// folders. With --large what grows out of them instead: each file again and again, and each kind of
// line again and again in its place, up to so many bytes. An input that takes 2 s is a fault, and
// so are 256 MB at any time; a program that is not optimised, or has sanitizers, may take 20 s, and
// with sanitizers any memory. Exit code 1 for such a fault, 2 if there is no such target, no file,
// or one that cannot be read; a target that breaks a promise ends the program.
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
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

/// Returns a text with the piece from `begin` to `end` as often as it fits into
/// `most` bytes.
std::string grown(const std::string& text, std::size_t begin, std::size_t end, std::size_t most) {
  std::string made = text.substr(0, begin);
  const std::string piece = text.substr(begin, end - begin);
  const std::size_t rest = text.size() - end;
  while (made.size() + piece.size() + rest <= most) made += piece;
  return made + text.substr(end);
}

/// Record of the inputs that were tried.
struct Tried {
  std::set<std::string> shapes;  ///< kinds of lines that need not be tried again
  long most = kMost;             ///< KB that were in use, or may be
};

/// Feeds a target; returns how many faults that is, 1 if the input took too much.
/// \param what the input is, behind what it took
int feed(Target target, std::string_view input, std::string_view what, Tried* tried) {
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

/// Feeds a target with what grows out of a text; returns how many inputs took too much.
int feed_large(Target target, const std::string& text, std::size_t most, Tried* tried) {
  int faults = 0;
  const auto feed_grown = [&](std::size_t begin, std::size_t end) {
    const std::string piece = text.substr(begin, std::min<std::size_t>(end - begin, 60));
    faults +=
        feed(target, grown(text, begin, end, most), ", with this again and again: " + piece, tried);
  };
  if (text.empty()) return 0;
  feed_grown(0, text.size());
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    if (tried->shapes.insert(text.substr(begin, std::min(kShape, end - begin))).second)
      feed_grown(begin, end);
    begin = end;
  }
  return faults;
}

/// Feeds a target with files, and with all files of folders, the inputs of each in the order of
/// their names.
/// \param most bytes of what grows out of them, or 0: they are taken as they are
int replay(const std::string& name, std::size_t most,
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
    faults += most > 0 ? feed_large(target->second, bytes, most, &tried)
                       : feed(target->second, bytes, "", &tried);
  }
  std::cout << files.size() << (most > 0 ? " files, grown, of " : " inputs of ") << name << '\n';
  if (files.empty()) return 2;
  return faults == 0 ? 0 : 1;
}

}  // namespace

Registered::Registered(std::string_view name, Target target) { targets().emplace(name, target); }

}  // namespace slipbench::fuzz

int main(int count, char** words) {
  const bool large = count > 2 && std::string_view(words[2]) == "--large";
  const int first = large ? 4 : 2;
  if (count <= first) {
    std::cerr << "usage: fuzz_replay TARGET [--large BYTES] FILE|FOLDER..\n";
    return 2;
  }
  const std::size_t most = large ? std::strtoull(words[3], nullptr, 10) : 0;
  return slipbench::fuzz::replay(words[1], most, {words + first, words + count});
}
