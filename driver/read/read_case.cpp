// SPDX-License-Identifier: Apache-2.0
#include "driver/read/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <type_traits>
#include <utility>

#include "driver/base/text/suggestions.hpp"
#include "driver/base/units/carried_unit.hpp"
#include "driver/read/file_kind.hpp"
#include "driver/read/foreign_file.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/case_units.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/read/resolve/resolve_formulation.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::read {
namespace {

struct Parameters {
  base::NamedNumbers values;
  std::vector<std::string> unresolved;  ///< names that have no value because something is faulty
};

/// A parameter or override, and where it was written.
struct Definition {
  base::ParameterText text;
  std::optional<yaml::Entry> entry;  ///< nothing for --set
};

void report(yaml::Binder& binder, const yaml::Node& root, base::Diagnostics& out,
            const Definition& definition, const base::ParameterError& error,
            std::span<const std::string> names) {
  if (definition.entry) {
    const yaml::Path path = yaml::Path() / "parameters" / definition.text.name;
    if (error.concerns_name) {
      binder.error(definition.entry->key, path, error.error.message);
    } else {
      binder.expression_error(definition.entry->value, path, error.error, {});
    }
    return;
  }
  const std::string& wanted = error.error.unknown_name;
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::string hint;
  if (!wanted.empty()) {
    hint =
        binder.nearest_or(wanted, known,
                          known.empty() ? "this case has no parameters"
                                        : "parameters of this case: " + base::few_in_words(known));
  }
  out.error(root.source().name(), {}, "--set " + definition.text.name, error.error.message,
            std::move(hint));
}

/// Resolves what can be resolved: parameters that are faulty, or use a faulty one, are left out.
void resolve(yaml::Binder& binder, const yaml::Node& root, base::Diagnostics& out,
             const std::vector<Definition>& parameters, const std::vector<Definition>& overrides,
             std::span<const std::string> names, Parameters& result) {
  const auto texts = [](const std::vector<Definition>& definitions) {
    std::vector<base::ParameterText> list;
    list.reserve(definitions.size());
    for (const Definition& definition : definitions) list.push_back(definition.text);
    return list;
  };
  base::ResolvedParameters resolved = base::resolve_parameters(texts(parameters), texts(overrides));
  for (const base::ParameterError& error : resolved.errors) {
    // The fault of a parameter that could not be read is reported already.
    const bool consequence = std::find(result.unresolved.begin(), result.unresolved.end(),
                                       error.error.unknown_name) != result.unresolved.end();
    const std::vector<Definition>& list = error.in_override ? overrides : parameters;
    if (!consequence) report(binder, root, out, list[error.index], error, names);
  }
  result.values = std::move(resolved.values);
  for (const Definition& parameter : parameters) {
    if (!result.values.contains(parameter.text.name)) {
      result.unresolved.push_back(parameter.text.name);
    }
  }
}

/// A setting that carries its unit, as a number of the case's system.
base::ParameterText in_case_units(base::ParameterText setting, const base::UnitSystem& units,
                                  const yaml::Node& root, base::Diagnostics& out) {
  const auto* text = std::get_if<std::string>(&setting.value);
  if (text == nullptr || !base::carries_unit(*text)) return setting;
  const auto number = base::read_with_unit(*text, std::nullopt, units);
  const std::string place = "--set " + setting.name;
  if (!number) {
    out.error(root.source().name(), {}, place, number.error());
  } else if (number->shifted) {
    out.note(root.source().name(), {}, place, base::shifted_in_words(*text, *number, units));
  }
  setting.value = number ? number->value : 0.0;
  return setting;
}

/// Parameters come first: every other number of the file may be an expression over them.
Parameters read_parameters(const yaml::Node& root, const base::UnitSystem& units,
                           const ReadOptions& options, base::Diagnostics& out) {
  Parameters result;
  const auto map = root.find("parameters");
  std::vector<std::string> names;
  if (map && map->is_map()) {
    for (const yaml::Entry entry : map->entries()) names.emplace_back(entry.key.text());
  }
  if (names.size() > base::kMostParameters) {
    // Reported with the key; no number that uses one is a fault of its own.
    result.unresolved = std::move(names);
    return result;
  }
  const base::NamedNumbers none;
  // Knows the names only, for suggestions.
  yaml::Binder binder(out, none, names, {}, false, kCaseWords);
  binder.set_units(units);
  const yaml::KeyInfo any_unit{.unit = yaml::UnitUse::kAny};
  std::vector<Definition> parameters;
  if (map && map->is_map()) {
    for (const yaml::Entry entry : map->entries()) {
      const std::string name(entry.key.text());
      const bool overridden = std::any_of(options.overrides.begin(), options.overrides.end(),
                                          [&](const auto& set) { return set.name == name; });
      if (entry.value.is_null()) {
        // A parameter without a value waits for one: so does the skeleton of a case.
        if (overridden) {
          parameters.push_back({{name, 0.0}, entry});
        } else {
          binder.error(entry.value, yaml::Path() / "parameters" / name,
                       "wanted a number, found nothing",
                       "give it one here, or with --set " + name + "=VALUE");
          result.unresolved.push_back(name);
        }
      } else if (yaml::Binder::is_expression(entry.value)) {
        parameters.push_back({{name, std::string(entry.value.text())}, entry});
      } else if (const auto number =
                     binder.number(entry.value, yaml::Path() / "parameters" / name, any_unit)) {
        parameters.push_back({{name, *number}, entry});
      } else if (overridden) {
        parameters.push_back({{name, 0.0}, entry});
      } else {
        result.unresolved.push_back(name);
      }
    }
  }
  std::vector<Definition> overrides;
  for (const base::ParameterText& text : options.overrides) {
    overrides.push_back({in_case_units(text, units, root, out), std::nullopt});
  }
  resolve(binder, root, out, parameters, overrides, names, result);
  return result;
}

/// Means of making values of the text of a case: parameters, and a binder that knows them.
struct Reading {
  Reading(const yaml::Node& root, const std::string& folder, const ReadOptions& options,
          base::Diagnostics& out)
      : units(units_of(root)),
        parameters(read_parameters(root, units, options, out)),
        binder(out, parameters.values, parameters.unresolved, folder, options.allow_outside,
               kCaseWords) {
    binder.set_units(units);
    binder.note_formulas(options.formulas);
    if (!options.standard_input) binder.refuse_standard_input();
    // Without parameters, every name in an expression would be unknown.
    const auto map = root.find("parameters");
    binder.excuse_unknown_names((map && !map->is_map()) ||
                                yaml::is_misspelt<CaseText>(root, "parameters"));
  }

  base::UnitSystem units;
  Parameters parameters;
  yaml::Binder binder;
};

/// Resolves what goes before the friction. Faults do not hide one another: each part is judged as
/// far as it was understood.
/// \return the text with the coefficients of the parts that meet
CaseText resolve_connection(Reading& reading, const yaml::Node& root, CaseText text,
                            cases::Case& problem) {
  yaml::Binder& binder = reading.binder;
  problem.file = root.source().name();
  problem.title =
      text.title.empty() ? std::filesystem::path(problem.file).stem().string() : text.title;
  problem.parameters = reading.parameters.values;
  problem.units = read_units(binder, text.units);
  if (text.extrapolation.sound) binder.set_extrapolation(text.extrapolation.value);
  resolve_connector(binder, text, problem);
  resolve_belt(binder, text, problem);
  return with_friction_of_parts(binder, std::move(text),
                                !yaml::is_misspelt<CaseText>(root, "friction_pairs"), problem);
}

/// Resolves the friction, and the units that follow from what it slips in.
/// \return whether it is known which result columns there are
bool resolve_friction_and_units(yaml::Binder& binder, const yaml::Node& root, const CaseText& text,
                                cases::Case& problem) {
  const bool derived_known = !yaml::is_misspelt<CaseText>(root, "derived_components");
  const bool columns_known = resolve_friction(binder, text, derived_known, problem);
  if (text.friction_pairs.given() && !problem.definitions.empty()) {
    binder.settle_slip_units(text.friction_pairs.path,
                             law::is_rotational(problem.definitions.front().law.slip));
  }
  return columns_known && !is_any_connection(problem.connection);
}

/// Tells whether a key of a case has a say in its friction definitions.
bool is_about_friction(std::string_view key) {
  constexpr std::array<std::string_view, 3> kOthers{"history", "output", "checks"};
  return std::find(kOthers.begin(), kOthers.end(), key) == kOthers.end();
}

}  // namespace

tl::expected<ParsedCase, base::Diagnostics> ParsedCase::parse(const base::SourceText& source,
                                                              std::string folder) {
  auto tree = yaml::parse_yaml(source);
  if (!tree) {
    // Faults of YAML say nothing about another kind of file.
    if (auto foreign = foreign_file(source)) {
      tree.error() = {};
      tree.error().add(std::move(*foreign));
    }
    return tl::unexpected(std::move(tree.error()));
  }
  return ParsedCase(std::move(*tree), std::move(folder));
}

ReadCase ParsedCase::resolve(const ReadOptions& options) const {
  ReadCase result;
  const yaml::Node root = tree_.root();
  result.sources.push_back(root.source());
  base::Diagnostics& out = result.diagnostics;
  if (const auto other = other_kind(root, FileKind::kCase)) {
    out.error(root.source().name(), other->key.where(), std::string(other->key.text()),
              other->sentence);
    return result;
  }
  Reading reading(root, folder_, options, out);
  yaml::Binder& binder = reading.binder;

  CaseText written;
  const bool bound = yaml::read_struct(binder, root, yaml::Path(), written);

  cases::Case problem;
  const CaseText text = resolve_connection(reading, root, std::move(written), problem);
  const bool columns_known = resolve_friction_and_units(binder, root, text, problem);
  const std::size_t errors = binder.errors();
  resolve_forces(binder, text, problem);
  resolve_history(binder, text, problem);
  finish_belt(binder, text, problem);
  finish_forces(binder, text, problem);
  finish_contact_forces(binder, text, problem);
  tell_oscillator(binder, text, problem);
  check_formulations(binder, text, problem);
  resolve_bench_options(binder, text, problem);
  const bool history_known = text.history.sound && binder.errors() == errors;
  resolve_friction_changes(binder, text, columns_known, problem);
  resolve_integration(binder, text, problem);
  resolve_output_and_checks(binder, text, problem, columns_known, history_known,
                            options.curves_may_be_missing);
  if (bound && !out.has_errors()) binder.refuse_unsettled_units();
  result.environment_failure = binder.environment_failed();
  result.data_files = binder.data_files();
  problem.data_files = binder.data_files();
  if (bound && !out.has_errors()) explain_table_arguments(binder, text, problem);
  if (options.text != nullptr) *options.text = text;
  if (bound && !out.has_errors()) result.value = std::move(problem);
  return result;
}

tl::expected<std::vector<cases::CaseDefinition>, base::Diagnostics>
ParsedCase::resolve_friction_only(const ReadOptions& options) const {
  base::Diagnostics out;
  const yaml::Node root = tree_.root();
  Reading reading(root, folder_, options, out);
  CaseText text;
  yaml::for_each_key<CaseText>([&](std::string_view key, auto member, const yaml::KeyInfo& info) {
    using Member = std::remove_reference_t<decltype(text.*member)>;
    if (!is_about_friction(key)) return;
    if (const auto value = root.find(key)) {
      yaml::Codec<Member>::read(reading.binder, *value, yaml::Path() / key, info, text.*member);
    }
  });
  cases::Case problem;
  text = resolve_connection(reading, root, std::move(text), problem);
  resolve_friction_and_units(reading.binder, root, text, problem);
  if (out.has_errors()) return tl::unexpected(std::move(out));
  return std::move(problem.definitions);
}

tl::expected<base::NamedNumbers, base::Diagnostics> ParsedCase::resolve_parameters_only(
    const ReadOptions& options) const {
  base::Diagnostics out;
  Parameters parameters = read_parameters(tree_.root(), units_of(tree_.root()), options, out);
  if (out.has_errors()) return tl::unexpected(std::move(out));
  return std::move(parameters.values);
}

ReadCase read_case_text(const base::SourceText& source, const std::string& folder,
                        const ReadOptions& options) {
  auto parsed = ParsedCase::parse(source, folder);
  if (parsed) return parsed->resolve(options);
  ReadCase result;
  result.sources.push_back(source);
  result.diagnostics = std::move(parsed.error());
  return result;
}

ReadCase read_case(const std::string& path, const ReadOptions& options) {
  auto source = base::read_source(path);
  if (!source) {
    ReadCase result;
    result.diagnostics.add(source.error().diagnostic);
    result.environment_failure = source.error().failure == base::ReadFailure::kEnvironment;
    return result;
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return read_case_text(*source, folder.empty() ? "." : folder, options);
}

}  // namespace slipbench::driver::read
