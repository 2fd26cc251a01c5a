// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/case_codecs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/keys/law_numbers.hpp"
#include "law/connection/connection_type.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::yaml {

using namespace read;  // specialisations belong to the namespace of their template

namespace {

Json any_of(base::json::Array alternatives) {
  Json schema;
  schema["anyOf"] = Json(std::move(alternatives));
  return schema;
}

Json map_with_one(std::string_view key, Json value) {
  Json schema;
  schema["type"] = "object";
  schema["properties"][key] = std::move(value);
  Json required = Json(base::json::Array{});
  required.push_back(key);
  schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema;
}

Json plain(std::string_view type) {
  Json schema;
  schema["type"] = type;
  return schema;
}

bool has_key(const Node& node, std::string_view key) {
  return node.is_map() && node.find(key).has_value();
}

/// Tells whether an unquoted text is meant as a number, sound or not.
bool looks_like_number(std::string_view text) {
  const char first = text.empty() ? ' ' : text.front();
  return first == '-' || first == '+' || first == '.' || (first >= '0' && first <= '9');
}

/// Reads a value that may be written in several ways as a T.
template <class T, class Value>
bool read_as(Binder& binder, const Node& node, const Path& path, const KeyInfo& info, Value& out) {
  T value{};
  if (!Codec<T>::read(binder, node, path, info, value)) return false;
  out = std::move(value);
  return true;
}

/// Reads a Number, or a Name in its place.
/// \param info of the name
template <class Number, class Name, class Text>
bool read_number_or(Binder& binder, const Node& node, const Path& path, const KeyInfo& number,
                    const KeyInfo& info, Text& out) {
  if (!node.is_scalar() || node.text().empty()) {
    binder.wrong_kind(node, path, Codec<Text>::wanted(info));
    return false;
  }
  if (Binder::is_expression(node) || (!node.quoted() && looks_like_number(node.text()))) {
    return read_as<Number>(binder, node, path, number, out.value);
  }
  return read_as<Name>(binder, node, path, info, out.value);
}

}  // namespace

// --- connector.type ---------------------------------------------------------------------------

bool Codec<TypeNames>::read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                            TypeNames& out) {
  if (node.is_scalar()) {
    At<std::string> name;
    if (!Codec<At<std::string>>::read(binder, node, path, info, name)) return false;
    out.names.push_back(std::move(name));
    return true;
  }
  if (!node.is_sequence()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  if (node.size() < 1 || node.size() > 2) {
    binder.error(node, path,
                 "wanted " + wanted(info) + ", found a list of " + std::to_string(node.size()));
    return false;
  }
  return Codec<std::vector<At<std::string>>>::read(binder, node, path, info, out.names);
}
Json Codec<TypeNames>::schema(const KeyInfo&) {
  Json names = Json(base::json::Array{});
  law::for_each_connection_type(
      [&]<class Type>(std::type_identity<Type>) { names.push_back(Type::kInfo.name); });
  Json word;
  word["enum"] = std::move(names);
  Json list;
  list["type"] = "array";
  list["items"] = word;
  list["minItems"] = 1;
  list["maxItems"] = 2;
  return any_of({std::move(word), std::move(list)});
}
std::string Codec<TypeNames>::wanted(const KeyInfo&) {
  return "a connection type, or a list of two basic ones";
}
void Codec<TypeNames>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- a number or a table ----------------------------------------------------------------------

bool Codec<NumberOrTable>::read(Binder& binder, const Node& node, const Path& path,
                                const KeyInfo& info, NumberOrTable& out) {
  if (node.is_map()) return read_as<TableText>(binder, node, path, info, out);
  if (node.is_scalar()) return read_as<double>(binder, node, path, info, out);
  binder.wrong_kind(node, path, wanted(info));
  return false;
}
Json Codec<NumberOrTable>::schema(const KeyInfo& info) {
  return any_of({Codec<double>::schema(info), struct_schema<TableText>()});
}
std::string Codec<NumberOrTable>::wanted(const KeyInfo&) { return "a number or a table"; }
void Codec<NumberOrTable>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<TableText>(path, rows);
}

bool Codec<NumberOrMatrix>::read(Binder& binder, const Node& node, const Path& path,
                                 const KeyInfo& info, NumberOrMatrix& out) {
  if (node.is_scalar()) return read_as<double>(binder, node, path, info, out);
  if (!node.is_sequence()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  KeyInfo entry = info;
  entry.bounds = {};
  return read_as<std::vector<std::vector<double>>>(binder, node, path, entry, out);
}
Json Codec<NumberOrMatrix>::schema(const KeyInfo& info) {
  return any_of({Codec<double>::schema(info), Codec<std::vector<std::vector<double>>>::schema({})});
}
std::string Codec<NumberOrMatrix>::wanted(const KeyInfo&) {
  return "a number, or a matrix as a list of its rows";
}
void Codec<NumberOrMatrix>::rows(const std::string&, std::vector<KeyRow>&) {}

bool Codec<WeightsText>::read(Binder& binder, const Node& node, const Path& path,
                              const KeyInfo& info, WeightsText& out) {
  if (node.is_map()) return read_as<TableText>(binder, node, path, info, out);
  if (node.is_sequence()) return read_as<std::vector<double>>(binder, node, path, info, out);
  binder.wrong_kind(node, path, wanted(info));
  return false;
}
Json Codec<WeightsText>::schema(const KeyInfo& info) {
  return any_of({Codec<std::vector<double>>::schema(info), struct_schema<TableText>()});
}
std::string Codec<WeightsText>::wanted(const KeyInfo&) { return "a list of numbers, or a table"; }
void Codec<WeightsText>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- friction[].coefficient -------------------------------------------------------------------

namespace {

constexpr std::string_view kOrthotropic = "orthotropic";
constexpr std::string_view kWithDirection = "direction_dependent";

/// Calls visit(std::type_identity<Law>{}) for the laws that are written by name.
template <class Visit>
void for_each_named_law(Visit&& visit) {
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    const auto one = [&]<class L>(std::type_identity<L> law) {
      if constexpr (HasFields<L> && !std::is_same_v<L, law::ConstantCoefficient>) visit(law);
    };
    (one(std::type_identity<Law>{}), ...);
  }(std::type_identity<law::LawList>{});
}

/// Reports what rules between its parameters a law breaks: as errors, or, where the law lets it
/// pass, as warnings. The numbers stand with the first of them.
template <class Law>
bool rules_hold(Binder& binder, const Law& law, const Node& node, const Path& path) {
  std::string found = " (found " + numbers(law) + ")";
  const auto broken = [&](std::string_view rule) {
    return std::string(rule) + std::exchange(found, std::string());
  };
  if constexpr (requires { law.leniences(); }) {
    const auto let_pass = law.leniences();
    const auto held = law.rules_held();
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i]) continue;
      const std::string_view rule = law.kRules[i];
      if (std::find(let_pass.begin(), let_pass.end(), rule) == let_pass.end()) {
        binder.error(node, path, broken(rule));
      } else {
        binder.warning(node, path, broken(rule) + ": let pass by 'rules: lenient'");
      }
    }
    return !law.violation();
  } else if constexpr (requires { law.violation(); }) {
    const auto rule = law.violation();
    if (rule) binder.error(node, path, broken(*rule));
    return !rule;
  } else {
    return true;
  }
}

}  // namespace

bool Codec<CoefficientText>::read(Binder& binder, const Node& node, const Path& path,
                                  const KeyInfo& info, CoefficientText& out) {
  if (node.is_scalar()) {
    double mu = 0.0;
    if (!Codec<double>::read(binder, node, path, info, mu)) return false;
    out.value = law::FrictionLaw(law::ConstantCoefficient{mu});
    return true;
  }
  if (!node.is_map()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  if (has_key(node, "columns")) {
    return read_as<TableText>(binder, node, path, info, out.value);
  }
  if (node.size() == 1 && has_key(node, kOrthotropic)) {
    auto text = std::make_shared<OrthotropicText>();
    const bool good = read_struct(binder, *node.find(kOrthotropic), path / kOrthotropic, *text);
    out.orthotropic = std::move(text);
    return good;
  }
  if (node.size() == 1 && has_key(node, kWithDirection)) {
    auto text = std::make_shared<DirectionDependentText>();
    const bool good = read_struct(binder, *node.find(kWithDirection), path / kWithDirection, *text);
    out.with_direction = std::move(text);
    return good;
  }
  std::vector<std::string_view> names;
  for_each_named_law([&]<class Law>(std::type_identity<Law>) { names.push_back(Law::kName); });
  if (node.size() != 1) {
    binder.error(node, path,
                 "wanted one law (" + base::in_words(names) +
                     ") or a table with 'columns', found " + std::to_string(node.size()) + " keys");
    return false;
  }
  const Entry entry = node.entry(0);
  const Path below = path / entry.key.text();
  bool known = false;
  bool good = false;
  for_each_named_law([&]<class Law>(std::type_identity<Law>) {
    if (entry.key.text() != Law::kName) return;
    known = true;
    Law law;
    good = read_struct(binder, entry.value, below, law);
    if (good) good = rules_hold(binder, law, entry.value, below);
    if constexpr (requires { law.fit(); }) {
      // Fitted once, and in force as what it stands for.
      if (!good) return;
      const auto fitted = law.fit();
      binder.note(entry.value, below,
                  "stands for " + std::string(fitted.kName) + ": " + numbers(fitted));
      out.value = law::FrictionLaw(fitted);
    } else {
      out.value = law::FrictionLaw(law);
    }
  });
  if (!known) {
    names.push_back(kOrthotropic);
    names.push_back(kWithDirection);
    names.push_back("columns");
    binder.unknown_key(entry.key, below, names);
  }
  return good;
}
Json Codec<DirectionText>::schema(const KeyInfo& info) {
  base::json::Array alternatives = {Codec<double>::schema(info), struct_schema<TableText>()};
  for_each_named_law([&]<class Law>(std::type_identity<Law>) {
    alternatives.push_back(map_with_one(Law::kName, struct_schema<Law>()));
  });
  return any_of(std::move(alternatives));
}
Json Codec<CoefficientText>::schema(const KeyInfo& info) {
  return any_of({Codec<DirectionText>::schema(info),
                 map_with_one(kOrthotropic, struct_schema<OrthotropicText>()),
                 map_with_one(kWithDirection, struct_schema<DirectionDependentText>())});
}
std::string Codec<CoefficientText>::wanted(const KeyInfo&) {
  return "a number, a table, or one law by name";
}
void Codec<CoefficientText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  for_each_named_law([&]<class Law>(std::type_identity<Law>) {
    const std::string here = path + "." + std::string(Law::kName);
    rows.push_back({here, "a map", KeyInfo{.text = Law::kTitle, .default_text = "-"}});
    struct_rows<Law>(here, rows);
  });
  // A change of friction leads to one coefficient: two directions are refused there.
  if (path.find(".change_friction.") != std::string::npos) return;
  const std::string here = path + "." + std::string(kOrthotropic);
  rows.push_back(
      {here, "a map",
       KeyInfo{.text = "Two coefficients at right angles (Radioss Idir 1).", .default_text = "-"}});
  struct_rows<OrthotropicText>(here, rows);
  const std::string other = path + "." + std::string(kWithDirection);
  rows.push_back({other, "a map",
                  KeyInfo{.text = "A coefficient for each sense of the slip of one component.",
                          .default_text = "-"}});
  struct_rows<DirectionDependentText>(other, rows);
}

bool Codec<DirectionText>::read(Binder& binder, const Node& node, const Path& path,
                                const KeyInfo& info, DirectionText& out) {
  if (has_key(node, kOrthotropic)) {
    binder.error(*node.find(kOrthotropic), path / kOrthotropic,
                 "a direction of an orthotropic coefficient cannot be orthotropic itself",
                 "give a number, a table, or one law by name");
    return false;
  }
  if (has_key(node, kWithDirection)) {
    binder.error(*node.find(kWithDirection), path / kWithDirection,
                 "the coefficient of one direction cannot depend on the direction itself",
                 "give a number, a table, or one law by name");
    return false;
  }
  return Codec<CoefficientText>::read(binder, node, path, info, out.coefficient);
}
std::string Codec<DirectionText>::wanted(const KeyInfo& info) {
  return Codec<CoefficientText>::wanted(info);
}
void Codec<DirectionText>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- friction[].contact_force -----------------------------------------------------------------

bool Codec<ContactForceText>::read(Binder& binder, const Node& node, const Path& path,
                                   const KeyInfo& info, ContactForceText& out) {
  const KeyInfo number{.bounds = {.lower = 1, .upper = 6}};
  return read_number_or<int, std::string>(binder, node, path, number, info, out);
}
Json Codec<ContactForceText>::schema(const KeyInfo&) {
  return any_of({Codec<int>::schema(KeyInfo{.bounds = {.lower = 1, .upper = 6}}), plain("string")});
}
std::string Codec<ContactForceText>::wanted(const KeyInfo&) {
  return "a component number 1-6 or the name of a derived component";
}
void Codec<ContactForceText>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- friction_pairs.pairs[].parts -------------------------------------------------------------

bool Codec<PartOrGroup>::read(Binder& binder, const Node& node, const Path& path,
                              const KeyInfo& info, PartOrGroup& out) {
  const KeyInfo number{.bounds = {.lower = 1}};
  return read_number_or<int, std::string>(binder, node, path, number, info, out);
}
Json Codec<PartOrGroup>::schema(const KeyInfo&) {
  return any_of({Codec<int>::schema(KeyInfo{.bounds = {.lower = 1}}), plain("string")});
}
std::string Codec<PartOrGroup>::wanted(const KeyInfo&) { return "a part id or a group's name"; }
void Codec<PartOrGroup>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- dead_zone[].position ---------------------------------------------------------------------

bool Codec<PlayPositionText>::read(Binder& binder, const Node& node, const Path& path,
                                   const KeyInfo& info, PlayPositionText& out) {
  return read_number_or<double, PlayPlace>(binder, node, path, info, info, out);
}
Json Codec<PlayPositionText>::schema(const KeyInfo& info) {
  return any_of({Codec<double>::schema(info), Codec<PlayPlace>::schema(info)});
}
std::string Codec<PlayPositionText>::wanted(const KeyInfo& info) {
  return Codec<PlayPlace>::wanted(info) + ", or a number";
}
void Codec<PlayPositionText>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- friction[].predefined --------------------------------------------------------------------

bool Codec<PredefinedText>::read(Binder& binder, const Node& node, const Path& path,
                                 const KeyInfo& info, PredefinedText& out) {
  if (!node.is_map()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  out.node = node;
  return true;
}
Json Codec<PredefinedText>::schema(const KeyInfo&) {
  base::json::Array alternatives;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (law::HasPredefinedFriction<Type>) alternatives.push_back(struct_schema<Type>());
  });
  return any_of(std::move(alternatives));
}
std::string Codec<PredefinedText>::wanted(const KeyInfo&) {
  return "a map of the connection's geometry ({} takes all defaults)";
}
void Codec<PredefinedText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (law::HasPredefinedFriction<Type>) {
      struct_rows<Type>(path + " (" + std::string(Type::kInfo.name) + ")", rows);
    }
  });
}

// --- profiles ---------------------------------------------------------------------------------

namespace {

struct ToText {
  double to = 0.0;
  static void declare(auto& key) {
    key("to", &ToText::to,
        {.required = true,
         .text = "Linear from the current value to this.",
         .unit = UnitUse::kQuantity});
  }
};
struct SmoothToText {
  double smooth_to = 0.0;
  static void declare(auto& key) {
    key("smooth_to", &SmoothToText::smooth_to,
        {.required = true,
         .text = "From the current value to this, with zero rate at both ends.",
         .unit = UnitUse::kQuantity});
  }
};
struct WaveText {
  double amplitude = 0.0;
  At<double> frequency, period;
  double mean = 0.0;
  double phase = 0.0;
  static void declare(auto& key) {
    key("amplitude", &WaveText::amplitude,
        {.required = true,
         .text = "Half the peak-to-peak value.",
         .unit = UnitUse::kQuantity,
         .difference = true});
    key("frequency", &WaveText::frequency,
        {.text = "Cycles per time.",
         .default_text = "period",
         .dimension = base::kFrequency,
         .bounds = law::kPositive});
    key("period", &WaveText::period,
        {.text = "Length of a cycle.",
         .default_text = "frequency",
         .dimension = base::kTime,
         .bounds = law::kPositive});
    key("mean", &WaveText::mean,
        {.text = "Value the wave swings about.", .default_text = "0", .unit = UnitUse::kQuantity});
    key("phase", &WaveText::phase,
        {.text = "Phase in radians: where in its cycle the wave starts.",
         .default_text = "0",
         .dimension = base::kAngle});
  }
};
struct CsvProfileText {
  At<DataSourceText> csv;
  At<std::string> time, value, unit, time_unit;
  At<double> begins = yaml::default_of(0.0);
  static void declare(auto& key) {
    key("csv", &CsvProfileText::csv, {.required = true, .text = "CSV file in the case's folder."});
    key("time", &CsvProfileText::time, {.required = true, .text = "Name of the time column."});
    key("value", &CsvProfileText::value, {.required = true, .text = "Name of the value column."});
    key("unit", &CsvProfileText::unit,
        {.text = "Unit of the value column.", .default_text = "the case's"});
    key("time_unit", &CsvProfileText::time_unit,
        {.text = "Unit of the time column.", .default_text = "the case's"});
    key("begins", &CsvProfileText::begins,
        {.text = "Time in the file at which the step begins, in the unit of the case.",
         .default_text = "0",
         .dimension = base::kTime});
  }
};

constexpr std::array<std::string_view, 4> kWaves{"sine", "triangle", "sawtooth", "square"};
constexpr std::string_view kProfileForms =
    "a profile: a number, an expression, {to: v}, {smooth_to: v}, {sine|triangle|sawtooth|square: "
    "{...}}, {columns: [value, t], rows: [...]} or {csv: ..., time: ..., value: ...}";

bool is_position(const std::string& name) { return cases::component_of_motion(name).has_value(); }

bool read_wave(Binder& binder, const Node& node, const Path& path, std::size_t shape,
               ProfileText& out) {
  WaveText wave;
  const Path below = path / kWaves[shape];
  const Node inner = *node.find(kWaves[shape]);
  if (!read_struct(binder, inner, below, wave)) return false;
  if (wave.frequency.given() == wave.period.given()) {
    binder.error(inner, below,
                 wave.period.given() ? "a wave has 'frequency' or 'period', not both"
                                     : "a wave needs 'frequency' or 'period'");
    return false;
  }
  out.profile = history::Wave{static_cast<history::WaveShape>(shape), wave.amplitude,
                              wave.period.given() ? wave.period.value : 1.0 / wave.frequency.value,
                              wave.mean, wave.phase};
  if (const auto broken = history::violation(std::get<history::Wave>(out.profile))) {
    binder.error(inner, below, *broken);
    return false;
  }
  return true;
}

/// A table over the time in the step.
/// \param what "a profile", for messages
/// \param column wanted name of the values; empty: any
std::optional<history::Tabular> read_tabular(Binder& binder, const Node& node, const Path& path,
                                             std::string_view what, std::string_view column) {
  TableText text;
  if (!read_struct(binder, node, path, text)) return std::nullopt;
  if (text.columns.value.size() != 2 || text.columns.value[1].value != "t" ||
      text.columns.value[0].value == "t" ||
      (!column.empty() && text.columns.value[0].value != column)) {
    binder.error(*text.columns.node, text.columns.path,
                 "the columns of " + std::string(what) + " are [" +
                     std::string(column.empty() ? "value" : column) + ", t]");
    return std::nullopt;
  }
  if (text.extrapolate.value != law::Extrapolation::kConstant) {
    binder.error(*text.extrapolate.node, text.extrapolate.path,
                 std::string(what) + " must cover its step; it is not extrapolated");
    return std::nullopt;
  }
  const auto built = table(binder, text, node, path, 1, 1, false, text.extrapolate.value);
  if (!built) return std::nullopt;
  history::Tabular tabular;
  for (const double t : built->knots(0)) {
    tabular.times.push_back(t);
    tabular.values.push_back(built->value(std::span(&t, 1)));
  }
  if (const auto broken = history::violation(tabular)) {
    binder.error(node, path, *broken);
    return std::nullopt;
  }
  return tabular;
}

/// Counts a formula whose compiled form stays; false, after an error, where there are too many.
bool count_formula(Binder& binder, const Node& node, const Path& path) {
  if (binder.count_formula()) return true;
  binder.error(
      node, path,
      fmt::format("the steps have more than {} formulas over the time", Binder::kMostFormulas),
      "'repeat' takes a step again, and '= ..T..' goes on through all of them");
  return false;
}

}  // namespace

bool Codec<ProfileText>::read(Binder& binder, const Node& node, const Path& path,
                              const KeyInfo& info, ProfileText& out) {
  if (node.is_scalar()) {
    if (Binder::is_expression(node)) {
      // The variables of PositionFormula, in its order; the first two are those of
      // ExpressionProfile. A parameter hides a position of its name: no name is empty.
      std::vector<std::string> variables{"t", "T"};
      for (int c = 0; c < law::kComponents; ++c) {
        variables.push_back(binder.is_parameter(cases::motion_name(c)) ? ""
                                                                       : cases::motion_name(c));
      }
      if (binder.has_too_many_formulas()) return count_formula(binder, node, path);
      if (const auto known = binder.known_number(node, path)) {
        out.profile = history::Constant{*known};
        return true;
      }
      auto compiled = binder.expression(node, path, variables);
      if (!compiled) return false;
      const auto used = compiled->used_variables();
      if (std::any_of(used.begin(), used.end(), is_position)) {
        if (!count_formula(binder, node, path)) return false;
        out.profile = history::PositionFormula{std::move(*compiled)};
        return true;
      }
      if (used.empty()) {
        const auto value = binder.number(node, path, info);
        if (value) out.profile = history::Constant{*value};
        return value.has_value();
      }
      variables.resize(2);
      compiled = binder.expression(node, path, variables);
      if (!count_formula(binder, node, path)) return false;
      out.profile = history::ExpressionProfile{std::move(*compiled)};
      return true;
    }
    double value = 0.0;
    if (!Codec<double>::read(binder, node, path, info, value)) return false;
    out.profile = history::Constant{value};
    return true;
  }
  if (!node.is_map()) {
    binder.wrong_kind(node, path, kProfileForms);
    return false;
  }
  constexpr std::array<std::string_view, 8> kForms{"to",       "smooth_to", "sine",    "triangle",
                                                   "sawtooth", "square",    "columns", "csv"};
  std::vector<std::string_view> forms;
  std::copy_if(kForms.begin(), kForms.end(), std::back_inserter(forms),
               [&](std::string_view form) { return has_key(node, form); });
  const bool table_from_csv = forms.size() == 2 && forms[0] == "columns" && forms[1] == "csv";
  if (forms.size() > 1 && !table_from_csv) {
    binder.error(node, path, "a profile has one form, found " + base::in_words(forms, "and"));
    return false;
  }
  if (has_key(node, "to")) {
    ToText to;
    if (!read_struct(binder, node, path, to)) return false;
    out.profile = history::LinearTo{to.to};
    return true;
  }
  if (has_key(node, "smooth_to")) {
    SmoothToText to;
    if (!read_struct(binder, node, path, to)) return false;
    out.profile = history::SmoothTo{to.smooth_to};
    return true;
  }
  for (std::size_t shape = 0; shape < kWaves.size(); ++shape) {
    if (!has_key(node, kWaves[shape])) continue;
    bool alone = true;
    for (const Entry entry : node.entries()) {
      if (entry.key.text() == kWaves[shape]) continue;
      binder.error(entry.key, path / entry.key.text(),
                   "stands beside '" + std::string(kWaves[shape]) + "'",
                   "what belongs to the wave goes inside its braces");
      alone = false;
    }
    return read_wave(binder, node, path, shape, out) && alone;
  }
  if (has_key(node, "columns")) {
    auto tabular = read_tabular(binder, node, path, "a profile", "");
    if (!tabular) return false;
    out.profile = std::move(*tabular);
    return true;
  }
  if (has_key(node, "csv")) {
    CsvProfileText csv;
    if (!read_struct(binder, node, path, csv)) return false;
    auto source = data_source(binder, csv.csv);
    if (!source) return false;
    out.profile = history::CsvColumn{std::move(*source), csv.time.value, {}, csv.value.value, {}};
    out.csv = std::move(csv.csv);
    out.unit = std::move(csv.unit);
    out.time_unit = std::move(csv.time_unit);
    out.begins = csv.begins.value;
    return true;
  }
  if (node.size() > 0) {
    for (const Entry entry : node.entries()) {
      binder.unknown_key(entry.key, path / entry.key.text(), kForms);
    }
  } else {
    binder.error(node, path, "wanted " + std::string(kProfileForms) + ", found an empty map");
  }
  return false;
}
Json Codec<ProfileText>::schema(const KeyInfo& info) {
  base::json::Array alternatives = {Codec<double>::schema(info), struct_schema<ToText>(),
                                    struct_schema<SmoothToText>()};
  for (const std::string_view wave : kWaves) {
    alternatives.push_back(map_with_one(wave, struct_schema<WaveText>()));
  }
  alternatives.push_back(struct_schema<TableText>());
  alternatives.push_back(struct_schema<CsvProfileText>());
  return any_of(std::move(alternatives));
}
std::string Codec<ProfileText>::wanted(const KeyInfo&) { return "a profile"; }
void Codec<ProfileText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  // The forms of a profile are the same everywhere: listed once, under the temperature.
  if (!path.ends_with("temperature")) return;
  struct_rows<ToText>(path, rows);
  struct_rows<SmoothToText>(path, rows);
  struct_rows<WaveText>(path + ".sine|triangle|sawtooth|square", rows);
  struct_rows<CsvProfileText>(path, rows);
}

// --- history[].change_friction.NAME.amplitude -------------------------------------------------

bool Codec<AmplitudeText>::read(Binder& binder, const Node& node, const Path& path,
                                const KeyInfo& info, AmplitudeText& out) {
  if (node.is_scalar()) {
    AmplitudeShape shape = AmplitudeShape::kLinear;
    if (!Codec<AmplitudeShape>::read(binder, node, path, info, shape)) return false;
    if (shape == AmplitudeShape::kSmooth) {
      out.profile = history::SmoothTo{1.0};
    } else {
      out.profile = history::LinearTo{1.0};
    }
    return true;
  }
  if (!node.is_map()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  auto tabular = read_tabular(binder, node, path, "an amplitude", "weight");
  if (!tabular) return false;
  const std::vector<double>& weights = tabular->values;
  if (weights.front() != 0.0 || weights.back() != 1.0 ||
      !std::is_sorted(weights.begin(), weights.end())) {
    std::string found;
    for (std::size_t i = 0; i < weights.size() && i < 5; ++i) {
      found += (i == 0 ? "" : ", ") + base::format_number(weights[i]);
    }
    if (weights.size() > 5) found += ", ...";
    binder.error(node, path,
                 "the weights of an amplitude go from 0 to 1 and never back, found " + found);
    return false;
  }
  out.profile = std::move(*tabular);
  return true;
}
Json Codec<AmplitudeText>::schema(const KeyInfo& info) {
  return any_of({Codec<AmplitudeShape>::schema(info), struct_schema<TableText>()});
}
std::string Codec<AmplitudeText>::wanted(const KeyInfo&) {
  return "linear, smooth, or a table {columns: [weight, t], rows: [...]}";
}
void Codec<AmplitudeText>::rows(const std::string&, std::vector<KeyRow>&) {}

// --- history ----------------------------------------------------------------------------------

namespace {

struct ColumnAndUnit {
  At<std::string> column, unit;
  static void declare(auto& key) {
    key("column", &ColumnAndUnit::column, {.required = true, .text = "Name of the column."});
    key("unit", &ColumnAndUnit::unit,
        {.text = "Unit of the column.", .default_text = "the case's"});
  }
};

}  // namespace

bool Codec<MeasuredColumnText>::read(Binder& binder, const Node& node, const Path& path,
                                     const KeyInfo& info, MeasuredColumnText& out) {
  if (node.is_scalar()) {
    return Codec<At<std::string>>::read(binder, node, path, info, out.column);
  }
  if (!node.is_map()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  ColumnAndUnit both;
  if (!read_struct(binder, node, path, both)) return false;
  out.column = std::move(both.column);
  out.unit = std::move(both.unit);
  return true;
}
Json Codec<MeasuredColumnText>::schema(const KeyInfo&) {
  return any_of({plain("string"), struct_schema<ColumnAndUnit>()});
}
std::string Codec<MeasuredColumnText>::wanted(const KeyInfo&) {
  return "a column's name, or {column: ..., unit: ...}";
}
void Codec<MeasuredColumnText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<ColumnAndUnit>(path, rows);
}

bool Codec<HistoryText>::read(Binder& binder, const Node& node, const Path& path,
                              const KeyInfo& info, HistoryText& out) {
  if (node.is_map()) {
    if (node.find("step") && !node.find("csv")) {
      binder.error(node, path, "wanted a list of steps, found one step",
                   "each step begins with '- '");
      return false;
    }
    return read_struct(binder, node, path, out.measured.emplace());
  }
  if (!node.is_sequence()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  if (node.size() == 0) {
    binder.error(node, path, "needs at least one step");
    return false;
  }
  return Codec<std::vector<At<StepText>>>::read(binder, node, path, info, out.steps);
}
Json Codec<HistoryText>::schema(const KeyInfo& info) {
  Json steps = Codec<std::vector<At<StepText>>>::schema(info);
  steps["minItems"] = 1;
  return any_of({std::move(steps), struct_schema<MeasuredText>()});
}
std::string Codec<HistoryText>::wanted(const KeyInfo&) {
  return "a list of steps, or a measured history {csv: ...}";
}
void Codec<HistoryText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  struct_rows<StepText>(path + "[]", rows);
  struct_rows<MeasuredText>(path, rows);
}

// --- checks, parameters -----------------------------------------------------------------------

bool Codec<NumberOrList>::read(Binder& binder, const Node& node, const Path& path,
                               const KeyInfo& info, NumberOrList& out) {
  if (node.is_sequence()) {
    out.list = true;
    return Codec<std::vector<double>>::read(binder, node, path, info, out.values);
  }
  double value = 0.0;
  if (!Codec<double>::read(binder, node, path, info, value)) return false;
  out.values = {value};
  return true;
}
Json Codec<NumberOrList>::schema(const KeyInfo& info) {
  return any_of({Codec<double>::schema(info), Codec<std::vector<double>>::schema(info)});
}
std::string Codec<NumberOrList>::wanted(const KeyInfo&) { return "a number or a list of numbers"; }
void Codec<NumberOrList>::rows(const std::string&, std::vector<KeyRow>&) {}

bool Codec<ParameterValue>::read(Binder&, const Node&, const Path&, const KeyInfo&,
                                 ParameterValue&) {
  return true;  // read before everything else, see read_case
}
Json Codec<ParameterValue>::schema(const KeyInfo& info) { return Codec<double>::schema(info); }
std::string Codec<ParameterValue>::wanted(const KeyInfo&) { return "a number"; }
void Codec<ParameterValue>::rows(const std::string&, std::vector<KeyRow>&) {}

}  // namespace slipbench::driver::yaml
