// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/law_case.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/read/read_case.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::plot {
namespace {

bool is_of_name(char c) { return (std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '_'; }

/// The names that the expressions of a node use.
void add_names(const yaml::Node& node, std::set<std::string, std::less<>>& names) {
  if (node.is_scalar() && node.text().starts_with('=')) {
    std::string name;
    for (const char c : std::string(node.text()) + " ") {
      if (is_of_name(c)) {
        name += c;
      } else {
        names.insert(std::exchange(name, {}));
      }
    }
  }
  for (std::size_t i = 0; (node.is_map() || node.is_sequence()) && i < node.size(); ++i) {
    add_names(node[i], names);
  }
}

/// The names that everything but history, output and checks needs, parameters of parameters too.
std::set<std::string, std::less<>> needed_names(const yaml::Node& root) {
  constexpr std::array<std::string_view, 4> kOthers{"history", "output", "checks", "parameters"};
  std::set<std::string, std::less<>> names;
  if (!root.is_map()) return names;
  for (const yaml::Entry entry : root.entries()) {
    if (std::find(kOthers.begin(), kOthers.end(), entry.key.text()) == kOthers.end()) {
      add_names(entry.value, names);
    }
  }
  const auto parameters = root.find("parameters");
  if (!parameters || !parameters->is_map()) return names;
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (const yaml::Entry entry : parameters->entries()) {
      if (names.contains(entry.key.text())) add_names(entry.value, names);
    }
  }
  return names;
}

std::string text_of(const yaml::Node& map, std::string_view key) {
  const auto node = map.find(key);
  return node && node->is_scalar() ? std::string(node->text()) : std::string();
}

}  // namespace

std::optional<cases::Case> case_of_law(std::string_view name) {
  std::optional<cases::Case> found;
  const auto look = [&]<class Law>(std::type_identity<Law>) {
    if (Law::kName != name) return;
    found.emplace();
    found->title = std::string(name) + " with the parameters of its example";
    found->definitions.emplace_back();
    found->definitions.back().name = std::string(name);
    found->definitions.back().law.law = Law::example();
  };
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (look(std::type_identity<Law>{}), ...);
  }(std::type_identity<law::LawList>{});
  return found;
}

std::optional<cases::Case> case_of_friction(const PlotOptions& options) {
  const auto source = base::read_source(options.input);
  auto settings = base::parse_settings(options.settings);
  if (!source || !settings) return std::nullopt;
  const std::string folder = std::filesystem::path(options.input).parent_path().string();
  const auto parsed = read::ParsedCase::parse(*source, folder.empty() ? "." : folder);
  if (!parsed) return std::nullopt;
  const yaml::Node root = parsed->root();
  const auto needed = needed_names(root);
  if (const auto parameters = root.find("parameters"); parameters && parameters->is_map()) {
    for (const yaml::Entry entry : parameters->entries()) {
      const std::string name(entry.key.text());
      const bool set =
          std::any_of(settings->begin(), settings->end(),
                      [&](const base::ParameterText& one) { return one.name == name; });
      if (entry.value.is_null() && !set && !needed.contains(name)) {
        settings->push_back({name, std::string("1")});
      }
    }
  }
  auto definitions = parsed->resolve_friction_only({*settings, options.allow_outside});
  if (!definitions || definitions->empty()) return std::nullopt;
  cases::Case problem;
  problem.file = options.input;
  problem.title = text_of(root, "title");
  problem.definitions = std::move(*definitions);
  if (const auto units = root.find("units"); units && units->is_map()) {
    problem.units = {text_of(*units, "length"), text_of(*units, "force"), text_of(*units, "time"),
                     text_of(*units, "temperature")};
  }
  return problem;
}

}  // namespace slipbench::driver::plot
