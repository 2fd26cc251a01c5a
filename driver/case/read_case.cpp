// SPDX-License-Identifier: Apache-2.0
#include "driver/case/read_case.hpp"

#include <filesystem>

#include "driver/case/case_codecs.hpp"
#include "driver/case/resolve.hpp"
#include "driver/text/number.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver {
namespace {

struct Parameters {
  NamedNumbers values;
  bool good = true;
};

/// Parameters come first: every other number of the file may be an expression over them.
Parameters read_parameters(const Node& root, const ReadOptions& options, Diagnostics& out) {
  Parameters result;
  std::vector<ParameterText> texts;
  std::vector<Entry> entries;
  const NamedNumbers none;
  Binder binder(out, none, true, {}, false);
  const Path path = Path() / "parameters";
  const auto map = root.find("parameters");
  if (map && map->is_map()) {
    for (const Entry entry : map->entries()) {
      const std::string name(entry.key.text());
      if (Binder::is_expression(entry.value)) {
        texts.push_back({name, std::string(entry.value.text())});
      } else if (const auto number = binder.number(entry.value, path / name)) {
        texts.push_back({name, *number});
      } else {
        result.good = false;
        continue;
      }
      entries.push_back(entry);
    }
  }
  auto resolved = resolve_parameters(texts, options.overrides);
  if (resolved) {
    result.values = std::move(*resolved);
    return result;
  }
  result.good = false;
  for (const ParameterError& error : resolved.error()) {
    std::vector<std::string_view> names;
    for (const ParameterText& text : texts) names.push_back(text.name);
    std::string hint;
    const std::string& unknown = error.error.unknown_name;
    if (const auto nearest = unknown.empty() ? std::nullopt : nearest_name(unknown, names)) {
      hint = "did you mean '" + std::string(*nearest) + "'?";
    }
    if (error.in_override) {
      const std::string& name = options.overrides[error.index].name;
      if (hint.empty() && !names.empty()) {
        const auto nearest = nearest_name(name, names);
        hint = nearest ? "did you mean '" + std::string(*nearest) + "'?"
                       : "parameters of this case: " + in_words(names, "and");
      }
      out.error(root.source().name(), {}, "--set " + name, error.error.message, std::move(hint));
      continue;
    }
    const Entry& entry = entries[error.index];
    const Node& at = error.concerns_name ? entry.key : entry.value;
    binder.error(at, path / entry.key.text(), error.error.message, std::move(hint));
  }
  return result;
}

UnitSystem read_units(Binder& binder, const UnitsText& text) {
  const auto read = [&](const At<std::string>& unit, const Dimension& dimension) {
    if (!unit.given()) return std::string();
    if (const auto good = check_base_unit(unit.value, dimension); !good) {
      binder.history_error(*unit.node, unit.path, good.error());
    }
    return unit.value;
  };
  return {read(text.length, kLength), read(text.force, kForce), read(text.time, kTime),
          read(text.temperature, kTemperature)};
}

}  // namespace

ReadCase read_case_text(const SourceText& source, const std::string& folder,
                        const ReadOptions& options) {
  ReadCase result;
  result.sources.push_back(source);
  auto tree = parse_yaml(source);
  if (!tree) {
    result.diagnostics = std::move(tree.error());
    return result;
  }
  const Node root = tree->root();
  Diagnostics& out = result.diagnostics;
  const Parameters parameters = read_parameters(root, options, out);
  Binder binder(out, parameters.values, parameters.good, folder, options.allow_outside);

  CaseText text;
  const bool bound = read_struct(binder, root, Path(), text);

  Case problem;
  problem.file = source.name();
  problem.title =
      text.title.empty() ? std::filesystem::path(source.name()).stem().string() : text.title;
  problem.parameters = parameters.values;
  problem.units = read_units(binder, text.units);
  if (text.connector.given()) resolve_connector(binder, text, problem);
  // What hangs on the connection is only judged once that is known; each part needs its own text.
  const bool connected =
      !(problem.connection.info.held | problem.connection.info.available).empty();
  if (connected) {
    if (text.friction.given()) resolve_friction(binder, text, problem);
    if (text.history.given()) resolve_history(binder, text, problem);
    if (bound && !out.has_errors()) resolve_output_and_checks(binder, text, problem);
  }
  result.environment_failure = binder.environment_failed();
  if (!out.has_errors()) result.value = std::move(problem);
  return result;
}

ReadCase read_case(const std::string& path, const ReadOptions& options) {
  auto source = read_source(path);
  if (!source) {
    ReadCase result;
    result.diagnostics.add(source.error().diagnostic);
    result.environment_failure = source.error().failure == ReadFailure::kEnvironment;
    return result;
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return read_case_text(*source, folder.empty() ? "." : folder, options);
}

}  // namespace slipbench::driver
