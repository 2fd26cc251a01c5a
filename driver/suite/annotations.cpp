// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/annotations.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string escaped(std::string_view text, bool property) {
  std::string result;
  for (const char c : text) {
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

std::string annotation(std::string_view level, const std::string& file, const SourcePosition& where,
                       std::string_view title, std::string_view message) {
  std::string text = fmt::format("::{} file={}", level, escaped(file, true));
  if (where.line > 0) text += fmt::format(",line={},col={}", where.line, where.column);
  text += fmt::format(",title={}::{}\n", escaped(title, true), escaped(message, false));
  return text;
}

std::string Annotations::from_root(const std::string& file) const {
  if (root_.empty()) return file;
  std::error_code error;
  const fs::path there = fs::absolute(file, error).lexically_normal();
  if (error) return file;
  const fs::path relative = there.lexically_relative(root_);
  return relative.empty() || *relative.begin() == ".." ? file : relative.generic_string();
}

void Annotations::add(const Candidate& candidate, const CaseOutcome& outcome) {
  if (outcome.kind == CaseOutcome::Kind::kNotRun && errors_++ < kMost) {
    text_ += annotation("error", from_root(outcome.fault.file), outcome.fault.where,
                        candidate.label, outcome.fault.message);
  }
  for (const CheckOutcome& check : outcome.verdicts) {
    const std::string file = from_root(candidate.path);
    const std::string title = candidate.label + ": " + check.verdict.name;
    if (!check.verdict.passed && errors_++ < kMost) {
      text_ += annotation("error", file, check.where, title, check.text);
    }
    for (const std::string& warning : check.verdict.warnings) {
      if (warnings_++ < kMost) text_ += annotation("warning", file, check.where, title, warning);
    }
  }
}

}  // namespace slipbench::driver
