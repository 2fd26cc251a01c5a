// SPDX-License-Identifier: Apache-2.0
#include "driver/results/reproducer.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/json.hpp"
#include "driver/results/provenance.hpp"
#include "driver/yaml/node.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::results {
namespace {

constexpr const char* kStart = "# Fails as ";
constexpr const char* kEndOfName = " did:\n";

/// A text that YAML reads back as it is, wherever it stands.
std::string scalar(std::string_view text, bool quoted) {
  const bool plain = !quoted && !text.empty() && text.front() != '-' &&
                     std::all_of(text.begin(), text.end(), [](char c) {
                       return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                              std::string_view("_.+-").find(c) != std::string_view::npos;
                     });
  const bool negative = !quoted && text.size() > 1 && text.front() == '-' &&
                        (std::isdigit(static_cast<unsigned char>(text[1])) != 0 || text[1] == '.');
  return plain || negative ? std::string(text) : base::json::Value(text).dump();
}

void flow(const yaml::Node& node, std::string& out) {
  if (node.is_null()) {
    out += "null";
  } else if (node.is_scalar()) {
    out += scalar(node.text(), node.quoted());
  } else if (node.is_sequence()) {
    out += '[';
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i > 0) out += ", ";
      flow(node[i], out);
    }
    out += ']';
  } else {
    out += '{';
    bool first = true;
    for (const yaml::Entry entry : node.entries()) {
      if (!first) out += ", ";
      first = false;
      out += scalar(entry.key.text(), entry.key.quoted()) + ": ";
      flow(entry.value, out);
    }
    out += '}';
  }
}

/// A list, an item a line.
void list(const yaml::Node& node, std::size_t count, std::string& out) {
  out += '\n';
  for (std::size_t i = 0; i < count; ++i) {
    out += "  - ";
    flow(node[i], out);
    out += '\n';
  }
}

}  // namespace

std::string reproducer(const base::SourceText& source, const cases::Case& problem,
                       const bench::SimulationFailure& failure) {
  const auto tree = yaml::parse_yaml(source);
  if (!tree) return {};
  std::string out = kStart + problem.file + kEndOfName + "# " + failure.message + "\n";
  for (const yaml::Entry entry : tree->root().entries()) {
    const std::string_view key = entry.key.text();
    if (key == "checks" || key == "output") continue;
    out += std::string(key) + ":";
    if (key == "parameters") {
      std::string numbers;
      for (const auto& [name, value] : problem.parameters) {
        numbers += (numbers.empty() ? "" : ", ") + name + ": " + base::format_number(value);
      }
      out += " {" + numbers + "}\n";
    } else if (entry.value.is_sequence() && entry.value.size() > 0) {
      std::size_t count = entry.value.size();
      if (key == "history" && failure.step >= 0) {
        count = std::min(count, static_cast<std::size_t>(failure.step) + 1);
      }
      list(entry.value, count, out);
    } else {
      out += ' ';
      flow(entry.value, out);
      out += '\n';
    }
  }
  return out;
}

base::FileMark reproducer_mark(const cases::Case& problem) {
  return {.owner = "an unchanged case that fails as " + case_name(problem) + " did",
          .start = kStart,
          .text = case_name(problem) + kEndOfName,
          .sealed = true};
}

}  // namespace slipbench::driver::results
