// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/text_rules.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace slipbench::architecture {
namespace {

bool is_shell(const SourceFile& file) {
  return file.path.ends_with(".sh") || file.text.starts_with("#!/usr/bin/env bash");
}

bool is_build_file(const std::string& path) {
  return path.ends_with("CMakeLists.txt") || path.ends_with(".cmake") ||
         path.ends_with(".cmake.in") || path.ends_with(".json");
}

bool is_source(const SourceFile& file) {
  const bool cmake = is_build_file(file.path) && !file.path.ends_with(".json");
  return is_cpp(file.path) || cmake || is_shell(file) || file.path.ends_with(".py");
}

/// Every line of `text` in which `pattern` is found.
std::vector<Violation> find_lines(const std::string& path, const std::string& text,
                                  const std::regex& pattern, const std::string& message) {
  std::vector<Violation> violations;
  int number = 0;
  for (const std::string& line : lines(text)) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      violations.push_back({path, number, "'" + match.str() + "': " + message});
    }
  }
  return violations;
}

/// Tells whether `relative`, seen from the folder of `path`, leaves the repository.
bool climbs_out(const std::string& path, const std::string& relative) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return (folder / relative).lexically_normal().generic_string().starts_with("..");
}

}  // namespace

std::vector<Violation> law_violations(const SourceFile& file) {
  static const std::regex kForbidden(
      R"(\bthrow\b|\btry\b|\bstd::string\b|\bto_string\b|\bstd::\w*stream\b)"
      R"(|<(string|iostream|sstream|fstream|ostream|istream|cstdio)>|\bstd::c(out|err|log)\b)"
      R"(|\bprintf\b|\bfmt::|\bstd::format\b)");
  if (!file.path.starts_with("law/") || !is_cpp(file.path)) return {};
  return find_lines(file.path, without_comments(file.text, Strings::kBlank), kForbidden,
                    "the law builds no strings, writes nothing and throws nothing");
}

std::vector<Violation> clock_violations(const SourceFile& file) {
  static const std::regex kForbidden(
      R"(\b(system_clock|high_resolution_clock|gettimeofday|CLOCK_REALTIME|last_write_time)\b)"
      R"(|\btime\s*\(\s*(0|NULL|nullptr|&\w+)\s*\))");
  static const std::regex kRooms("(law|reference|driver|c|python|live)/.*");
  if (!std::regex_match(file.path, kRooms) || !is_cpp(file.path)) return {};
  return find_lines(file.path, without_comments(file.text, Strings::kBlank), kForbidden,
                    "the clock on the wall may go back: use std::chrono::steady_clock");
}

std::vector<Violation> plot_violations(const SourceFile& file) {
  static const std::regex kForbidden(R"(\.ya?ml\b|\bcases/|\bsystem\s*\(|["']\s*<)");
  if (!file.path.starts_with("plots/") || file.path.ends_with(".md") ||
      file.path.ends_with(".html")) {
    return {};
  }
  return find_lines(file.path, file.text, kForbidden,
                    "a plot template reads result files and nothing else");
}

std::vector<Violation> test_case_violations(const SourceFile& file) {
  static const std::regex kTestCase(R"(^\s*((TEMPLATE_)?TEST_CASE|SCENARIO)\w*\s*\()");
  if (!is_cpp(file.path) || file.path.ends_with("_test.cpp")) return {};
  return find_lines(file.path, file.text, kTestCase, "a test case stands in a file *_test.cpp");
}

std::vector<Violation> comment_violations(const SourceFile& file) {
  static const std::regex kQuestion(R"(^\s*/// (What|Who|Whether|Why|How|Which)\b)");
  if (!is_cpp(file.path)) return {};
  std::vector<Violation> violations = find_lines(
      file.path, file.text, kQuestion, "a comment begins with a verb (function) or a noun (type)");
  const std::vector<std::string> text = lines(file.text);
  std::erase_if(violations, [&](const Violation& one) {  // a sentence goes on
    return one.line > 1 &&
           text[static_cast<std::size_t>(one.line) - 2].find("///") != std::string::npos;
  });
  return violations;
}

std::vector<Violation> licence_violations(const SourceFile& file) {
  // In two parts, so that this line is not taken for a licence line itself.
  static const std::string kLicence = std::string("SPDX-License-") + "Identifier: Apache-2.0";
  if (!is_source(file)) return {};
  const std::vector<std::string> text = lines(file.text);
  const std::size_t at = !text.empty() && text[0].starts_with("#!") ? 1 : 0;
  const std::string wanted = (is_cpp(file.path) ? "// " : "# ") + kLicence;
  if (text.size() > at && text[at] == wanted) return {};
  return {{file.path, static_cast<int>(at) + 1, "wanted '" + wanted + "'"}};
}

std::vector<Violation> outside_violations(const SourceFile& file, const std::string& checkout) {
  static const std::regex kHome(R"((^|[^\w.])/(home|Users)/\w+|(^|[^\w.])/roo[t]/|[A-Z]:\\+Users)");
  static const std::regex kClimbing(R"((\.\./)+[\w.-]*)");
  const std::string stands_alone = "a place outside of the repository";

  std::vector<Violation> violations = find_lines(file.path, file.text, kHome, stands_alone);
  int number = 0;
  const bool relative_paths =
      is_shell(file) || is_build_file(file.path) || file.path.ends_with(".md");
  for (const std::string& line : lines(file.text)) {
    ++number;
    if (line.find(checkout) != std::string::npos) {
      violations.push_back({file.path, number, "'" + checkout + "': " + stands_alone});
    }
    if (!relative_paths) continue;
    for (auto it = std::sregex_iterator(line.begin(), line.end(), kClimbing);
         it != std::sregex_iterator(); ++it) {
      if (climbs_out(file.path, it->str())) {
        violations.push_back({file.path, number, "'" + it->str() + "': " + stands_alone});
      }
    }
  }
  return violations;
}

}  // namespace slipbench::architecture
