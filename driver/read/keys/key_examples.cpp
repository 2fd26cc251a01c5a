// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/key_examples.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace slipbench::driver::read {
namespace {

struct Example {
  std::string_view key;  ///< the last key of a path, or its last two
  std::string_view value;
};

/// Keys whose type does not tell a value that makes sense, or none at all.
constexpr std::array kExamples{
    Example{"units.length", "mm"},
    Example{"units.force", "N"},
    Example{"units.time", "s"},
    Example{"units.temperature", "degC"},
    Example{"title", "Press fit, dry"},
    Example{"parameters", "{mu: 0.2, R: = 25/2}"},
    Example{"connector.type", "CYLINDRICAL"},
    Example{"reference", "{CP1: 0.5}"},
    Example{"initial", "{CP1: 0.5}"},
    Example{"wrap_angle", "= pi"},
    Example{"half_turns", "2"},
    Example{"lengths", "[300, 250]"},
    Example{"nodes.a", "[0, 0, 0]"},
    Example{"nodes.b", "[100, 0, 0]"},
    Example{"nodes.c", "[100, 80, 0]"},
    Example{"connector.parts", "[1, 2]"},
    Example{"friction_pairs.parts", "[1, 2, 3]"},
    Example{"pairs[].parts", "[1, 2]"},
    Example{"derived_components", "{normal: [{operator: norm, components: [2, 3]}]}"},
    Example{"components", "[2, 3]"},
    Example{"weights", "[1, 0.5]"},
    Example{"dimension", "2"},
    Example{"friction[].name", "sliding"},
    Example{"predefined", "{}"},
    Example{"hinge_factors",
            "{columns: [k_ax, t_ax, k_tw, t_tw, slenderness], rows: [[0.3, 0.2, 0.1, 0.35, 4]]}"},
    Example{"terms", "[{component: 1}, {component: 4, scale: 25}]"},
    Example{"terms[].derived", "normal"},
    Example{"contact_force", "normal"},
    Example{"columns", "[mu, slip_rate]"},
    Example{"rows", "[[0.3, 0], [0.2, 100]]"},
    Example{"csv", "rig.csv"},
    Example{"file", "rig.csv"},
    Example{"coefficient", "0.2"},
    Example{"internal_contact_force", "50"},
    Example{"internal_contact_moment", "500"},
    Example{"internal_contact_moment_1", "500"},
    Example{"internal_contact_moment_3", "500"},
    Example{"speed_unit", "mm/s"},
    Example{"direction1", "0.2"},
    Example{"direction2", "0.3"},
    Example{"forward", "0.2"},
    Example{"backward", "0.3"},
    Example{"axis", "[1, 1]"},
    Example{"stick", "{elastic_slip: 0.01}"},
    Example{"formulation", "{penalty: stiffness, K_t: 1000}"},
    Example{"filter", "{simple: 0.5}"},
    Example{"formulation.K", "1000"},
    Example{"groups", "{steel: [1, 2]}"},
    Example{"elasticity", "[{component: 1, stiffness: 100}]"},
    Example{"damping", "[{component: 1, coefficient: 0.5}]"},
    Example{"stops", "[{component: 1, upper: 2}]"},
    Example{"dead_zone[].position", "lower"},
    Example{"integration", "{method: exact}"},
    Example{"integration.tolerance", "1.0e-9"},
    Example{"integration.snap_back", "jump"},
    Example{"extrapolation", "linear"},
    Example{"history", "[{step: push, increments: 100, motion: {CP1: {to: 1}}}]"},
    Example{"history[].step", "push"},
    Example{"motion", "{CP1: {to: 1}}"},
    Example{"force", "{f2: {to: 100}}"},
    Example{"fields", "{field1: {to: 1}}"},
    Example{"temperature", "{to: 80}"},
    Example{"history[].nodes", "{c: [100, {to: 90}, 0]}"},
    Example{"temperature.csv", "rig.csv"},
    Example{"temperature.time", "t"},
    Example{"temperature.value", "oil"},
    Example{"temperature.unit", "degF"},
    Example{"time_unit", "ms"},
    Example{"begins", "2"},
    Example{"change_friction", "{sliding: {coefficient: 0.3}}"},
    Example{"NAME.amplitude", "smooth"},
    Example{"history.columns", "{CP1: stroke}"},
    Example{"history.time", "t"},
    Example{"NAME.column", "stroke"},
    Example{"NAME.unit", "in"},
    Example{"output", "{every: 10}"},
    Example{"output.columns", "[CP1, CSF1]"},
    Example{"checks",
            "[{name: limit, quantity: FLIM, against: {expression: \"= 20\"}, "
            "tolerance: {relative: 0.01}}]"},
    Example{"checks[].name", "limit"},
    Example{"checks[].quantity", "CSF1"},
    Example{"checks[].against", "{expression: \"= mu*FN\"}"},
    Example{"checks[].step", "push"},
    Example{"unit", "mm"},
    Example{"column", "stroke"},
    Example{"name", "dry"},
    Example{"quantity", "CU1"},
    Example{"expression", "= mu*FN"},
    Example{"closed_form", "coulomb_slider"},
    Example{"with", "{stiffness: 1000, limit: 20}"},
    Example{"inputs", "{motion: CU1}"},
    Example{"against.output", "force"},
    Example{"curve", "rig.csv"},
    Example{"against.abscissa", "{column: stroke, unit: in}"},
    Example{"against.column", "{column: load, unit: lbf}"},
    Example{"checks[].over", "{from: 1, to: 2}"},
    Example{"checks[].abscissa", "CU1"},
    Example{"checks[].tolerance", "{relative: 0.01}"},
    Example{"why", "the rig repeats to 1 %"},
    Example{"calibrate",
            "{experiments: [{case: pad.yaml, data: rig.csv, time: t, "
            "compare: {CSF1: load}}], vary: {mu: {start: 0.2}}}"},
    Example{"experiments", "[{case: pad.yaml, data: rig.csv, time: t, compare: {CSF1: load}}]"},
    Example{"holdout", "[{case: pad.yaml, data: rig.csv, time: t, compare: {CSF1: load}}]"},
    Example{"experiments[].case", "pad.yaml"},
    Example{"experiments[].data", "rig.csv"},
    Example{"experiments[].time", "t"},
    Example{"set", "{R: 12.5}"},
    Example{"compare", "{CSF1: load}"},
    Example{"NAME.over", "CU1"},
    Example{"dead_band.position", "CU1"},
    Example{"vary", "{mu: {start: 0.2}}"},
    Example{"bounds", "[0.05, none]"},
    Example{"tables", "{friction1: {free: mu}}"},
    Example{"tables.NAME.free", "mu"},
    Example{"loss", "{huber: 3}"},
    Example{"calibrate.date", "2024-05-17"},
};

/// Tells whether `path` is `key` or ends with it, behind a dot.
bool ends_with_key(std::string_view path, std::string_view key) {
  if (!path.ends_with(key)) return false;
  return path.size() == key.size() || path[path.size() - key.size() - 1] == '.';
}

/// A number within the bounds, not 0.
std::string number_in(const law::Bounds& bounds, bool whole) {
  const double middle = bounds.lower + (bounds.upper - bounds.lower) / 2.0;
  for (const double value : {whole ? 1.0 : 0.1, 1.0, bounds.lower, middle}) {
    if (std::isfinite(value) && bounds.contains(value)) return fmt::format("{:g}", value);
  }
  return "0";
}

/// The last word of a choice, "constant or linear"; empty for anything else.
std::string last_choice(std::string_view wanted) {
  const std::size_t at = wanted.rfind(" or ");
  const std::string_view word = at == std::string_view::npos ? "" : wanted.substr(at + 4);
  return word.find(' ') == std::string_view::npos ? std::string(word) : "";
}

/// A map of the keys below that are required, else of the first one.
std::string map_below(const yaml::KeyRow& row, std::span<const yaml::KeyRow> rows) {
  std::vector<std::string> required;
  std::string first;
  for (const yaml::KeyRow& below : rows) {
    const std::string_view path = below.path;
    if (path.size() <= row.path.size() || !path.starts_with(row.path)) continue;
    std::string_view rest = path.substr(row.path.size());
    if (rest.starts_with("[]")) rest.remove_prefix(2);
    if (rest.front() != '.' || rest.find_first_of(".[", 1) != std::string_view::npos) continue;
    const std::string entry = fmt::format("{}: {}", rest.substr(1), example_of(below, rows));
    if (first.empty()) first = entry;
    if (below.info.required) required.push_back(entry);
  }
  return fmt::format("{{{}}}",
                     required.empty() ? first : fmt::format("{}", fmt::join(required, ", ")));
}

}  // namespace

std::string example_of(const yaml::KeyRow& row, std::span<const yaml::KeyRow> rows) {
  const Example* best = nullptr;
  for (const Example& example : kExamples) {
    if (!ends_with_key(row.path, example.key)) continue;
    if (best == nullptr || best->key.size() < example.key.size()) best = &example;
  }
  if (best != nullptr) return std::string(best->value);
  const std::string_view wanted = row.wanted;
  if (wanted == "true or false") return "true";
  if (wanted.starts_with("an integer")) return number_in(row.info.bounds, true);
  if (wanted.starts_with("a number")) return number_in(row.info.bounds, false);
  if (wanted == "a map") return map_below(row, rows);
  if (wanted == "a list, each item a map") return "[" + map_below(row, rows) + "]";
  if (wanted == "a profile") return "{to: 1}";
  if (wanted == "a list, each item a profile") return "[0, {to: 1}, 0]";
  return last_choice(wanted);
}

}  // namespace slipbench::driver::read
