// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/annotations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

/// Without what no log can show; the ends of lines stay, which are escaped.
std::string cleaned(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    result += base::printable(text.substr(0, end));
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string escaped(std::string_view text, bool property) {
  std::string result;
  for (const char c : cleaned(text)) {
    const bool special = c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','));
    if (special) {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

bool in_github_actions() {
  const char* value = std::getenv("GITHUB_ACTIONS");
  return value != nullptr && std::string_view(value) == "true";
}

std::string annotation(std::string_view level, const std::string& file,
                       const base::SourcePosition& where, std::string_view title,
                       std::string_view message) {
  std::string text = fmt::format("::{} file={}", level, escaped(file, true));
  if (where.line > 0) text += fmt::format(",line={},col={}", where.line, where.column);
  text += fmt::format(",title={}::{}\n", escaped(title, true), escaped(message, false));
  return text;
}

std::string without_commands(std::string text) {
  constexpr std::string_view kBegin = "##[";
  for (std::size_t at = 0; (at = text.find(kBegin, at)) != std::string::npos;) {
    text.replace(at, kBegin.size(), "# #[");
  }
  return text;
}

Annotations::Annotations(const std::string& root)
    : root_(root.empty() ? root : base::real_folder(root)) {}

std::string Annotations::from_root(const std::string& file) {
  if (root_.empty()) return file;
  const fs::path relative = fs::path(real_files_.of(file)).lexically_relative(root_);
  return relative.empty() || *relative.begin() == ".." ? file : relative.generic_string();
}

void Annotations::add(const Candidate& candidate, const CaseOutcome& outcome) {
  if (outcome.kind == CaseOutcome::Kind::kNotRun && errors_++ < kMost) {
    text_ += annotation("error", from_root(outcome.fault.file), outcome.fault.where,
                        candidate.label, outcome.fault.message);
  }
  for (const std::string& warning : outcome.warnings) {
    if (warnings_++ >= kMost) break;
    text_ += annotation("warning", from_root(candidate.path), {}, candidate.label, warning);
  }
  for (const CheckOutcome& check : outcome.verdicts) {
    const auto add_one = [&](const char* level, const std::string& message) {
      text_ += annotation(level, from_root(candidate.path), check.where,
                          candidate.label + ": " + check.verdict.name, message);
    };
    if (!check.verdict.passed && errors_++ < kMost) add_one("error", check.text);
    for (const std::string& warning : check.verdict.warnings) {
      if (warnings_++ < kMost) add_one("warning", warning);
    }
  }
}

}  // namespace slipbench::driver::suite
