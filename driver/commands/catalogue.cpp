// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/catalogue.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/calibrate/fit_reference.hpp"
#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "driver/check/criteria/criteria.hpp"
#include "driver/check/curves/curve_library.hpp"
#include "driver/commands/describe_key.hpp"
#include "driver/commands/describe_law.hpp"
#include "driver/commands/minimal_case.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/results/columns.hpp"
#include "driver/sweep/sweep_reference.hpp"
#include "driver/terminal/print.hpp"
#include "law/friction/law_list.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver::commands {
namespace {

template <class... Argument>
void tell(fmt::format_string<Argument...> text, Argument&&... arguments) {
  terminal::print(fmt::format(text, std::forward<Argument>(arguments)...));
}

constexpr std::array<std::string_view, 7> kLists{
    "connections", "laws", "keys", "closed-forms", "curves", "criteria", "quantities"};

template <class Visit>
void for_each_law(Visit&& visit) {
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (visit(std::type_identity<Law>{}), ...);
  }(std::type_identity<law::LawList>{});
}

void list_connections() {
  tell("connections (type, made of, constraint forces, free motions)\n");
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    const law::ConnectionInfo& info = Type::kInfo;
    tell("  {:<12} {:<24} {:<22} {:<18} {}\n", info.name, info.assembly,
         read::force_names(info.held), read::motion_names(info.available),
         law::HasPredefinedFriction<Type> ? "predefined friction" : "");
  });
}

void list_laws() {
  tell("laws of the coefficient of friction\n");
  for_each_law(
      [&]<class Law>(std::type_identity<Law>) { tell("  {:<20} {}\n", Law::kName, Law::kTitle); });
}

void list_keys() {
  tell("keys of a case at its top level; 'slipbench describe' tells of each and of those below\n");
  yaml::for_each_key<read::CaseText>([&](std::string_view key, auto, const yaml::KeyInfo& info) {
    tell("  {:<20} {}\n", key, info.text);
  });
  tell("keys of Radioss friction and of backlash\n");
  for (const DescribedKey& key : described_keys()) tell("  {:<20} {}\n", key.name, key.title);
}

void list_closed_forms() {
  tell("closed forms to check against\n");
  for (const reference::ClosedForm& form : reference::catalogue()) {
    tell("  {:<30} {}\n", form.name, form.title);
  }
}

void list_curves() {
  tell("reference curves to check against\n");
  for (const check::ShippedCurve& curve : check::shipped_curves())
    tell("  {:<30} {}\n", curve.name, curve.text);
}

void list_criteria() {
  tell("criteria that checks compare by\n");
  for (const check::CriterionInfo& info : check::kCriteria)
    tell("  {:<20} {}\n", info.word, info.text);
}

/// Definitions that have all columns of a formulation between them.
void add_formulations(law::FrictionDefinition definition,
                      std::vector<law::FrictionDefinition>& all) {
  definition.law = law::GeneralizedViscous::example();
  definition.formulation = law::Formulation{.penalty = law::ViscousPenalty{}};
  definition.formulation->filter.kind = law::Filter::Kind::kSimple;
  all.push_back(definition);
  definition.formulation->orthotropy = law::Orthotropy{.second = definition.law};
  all.push_back(definition);
}

/// All result columns that some connection with predefined friction has, each meaning once.
std::vector<results::Column> all_columns() {
  std::vector<results::Column> columns;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (law::HasPredefinedFriction<Type>) {
      cases::Case problem;
      problem.connection = {Type::kInfo, Type{}};
      const auto checks = Type{}.predefined();
      // One definition at a time, so that no name carries a definition's suffix.
      for (const law::PredefinedFriction& check : checks) {
        law::FrictionDefinition definition;
        definition.slip = check.slip;
        definition.criterion = check.criterion;
        std::vector<law::FrictionDefinition> forms = {definition};
        if constexpr (std::is_same_v<Type, law::Contact>) add_formulations(definition, forms);
        for (const law::FrictionDefinition& form : forms) {
          problem.definitions = {{"", check.slip.dimension > 1, form}};
          if constexpr (std::is_same_v<Type, law::Slot>)
            problem.definitions[0].dead_zone = cases::DeadZone{};
          for (results::Column& column : results::result_columns(problem)) {
            const bool known =
                std::any_of(columns.begin(), columns.end(), [&](const results::Column& c) {
                  return c.name == column.name && c.text == column.text;
                });
            if (!known) columns.push_back(std::move(column));
          }
        }
      }
    }
  });
  return columns;
}

void list_quantities() {
  tell("quantities a case prescribes\n");
  tell("  {:<18} {}\n", "CP1..3, CPR1..3",
       "relative position of a free component, under 'motion:'");
  tell("  {:<18} {}\n", "f1..3, m1..3",
       "constraint force or moment of a held component, under 'force:'");
  tell("  {:<18} {}\n", "driver", "load on the driver of a dynamic case, under 'force:'");
  tell("  {:<18} {}\n", "f1, f_bc", "tensions of a belt (SLIPRING), under 'force:'");
  tell("  {:<18} {}\n", "temperature", "temperature of the connector");
  tell("  {:<18} field variables, under 'fields:'\n", fmt::format("field1..{}", law::kMaxFields));
  tell("quantities a result has, as far as the connection does\n");
  for (const results::Column& column : all_columns())
    tell("  {:<18} {}\n", column.name, column.text);
}

template <class Struct>
void describe_fields(int indent) {
  yaml::for_each_key<Struct>([&](std::string_view key, auto member, const yaml::KeyInfo& info) {
    using Member = std::remove_reference_t<decltype(std::declval<Struct&>().*member)>;
    std::string wanted = yaml::Codec<Member>::wanted(info);
    if (const std::string bounds = yaml::in_words(info.bounds); !bounds.empty())
      wanted += ", " + bounds;
    wanted += info.required ? ", required" : ", default 0";
    if constexpr (std::is_same_v<Member, std::optional<law::Table>>) {
      wanted = "a table, default: built-in";
    } else if constexpr (std::is_same_v<Member, std::optional<double>>) {
      wanted = "a number, " + yaml::in_words(info.bounds) + ", optional";
    }
    tell("{:{}}{:<28} {}\n{:{}}{:<28} ({})\n", "", indent, key, info.text, "", indent, "", wanted);
  });
}

/// Each line after two blanks.
std::string indented(const std::string& lines) {
  std::string text;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    text += "  " + lines.substr(begin, end - begin) + "\n";
    begin = end == std::string::npos ? lines.size() : end + 1;
  }
  return text;
}

bool describe_connection(std::string_view name) {
  bool found = false;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    const law::ConnectionInfo& info = Type::kInfo;
    if (info.name != name) return;
    found = true;
    tell("{} (connection type, {})\n  {}\n\n{}\n", info.name, info.assembly, info.text,
         indented(std::string(connection_sketch(info.name))));
    tell("  holds, forces under 'force:'    {}\n", read::force_names(info.held));
    tell("  frees, motions under 'motion:'  {}\n", read::motion_names(info.available));
    tell("  contact force; the limit is mu times it\n{}",
         indented(indented(contact_force_formulas(info.name))));
    if constexpr (law::HasPredefinedFriction<Type>) {
      if (yaml::keys_of<Type>().empty()) {
        tell("  predefined friction without parameters: 'predefined: {{}}'\n");
      } else {
        tell("  predefined friction, parameters under 'predefined:'\n");
      }
      describe_fields<Type>(4);
    } else {
      tell("  no predefined friction: give 'component' or 'potential'\n");
    }
    tell("\n  a minimal case, as 'slipbench new {}' writes it\n\n{}", info.name,
         minimal_case(info.name));
  });
  return found;
}

/// Describes a connection type that is known by name and cannot be run; false for other names.
bool describe_known_type(std::string_view name) {
  // Types alone are written in capitals.
  const auto known = read::later_key(name);
  if (!known || std::islower(static_cast<unsigned char>(name[0])) != 0) return false;
  tell("{} (connection type, known by name)\n  {}\n", name, known->why);
  return true;
}

/// Prints a text if there is one.
bool told(const std::string& text) {
  terminal::print(text);
  return !text.empty();
}

template <class List>
void describe_signals(std::string_view title, const List& list) {
  tell("  {}\n", title);
  for (const auto& item : list) tell("    {:<20} [{}] {}\n", item.name, item.dimension, item.text);
}

bool describe_closed_form(std::string_view name) {
  const reference::ClosedForm* form = reference::find(name);
  if (form == nullptr) return false;
  tell("{} (closed form)\n  {}\n  {}\n  source: {}\n  admissible: {}\n", form->name, form->title,
       form->formula, form->source, form->range);
  describe_signals("parameters, under 'with:'", form->parameters);
  describe_signals("inputs, result columns under 'inputs:'", form->inputs);
  describe_signals("outputs, one of them under 'output:'", form->outputs);
  return true;
}

bool describe_criterion(std::string_view name) {
  for (const check::CriterionInfo& info : check::kCriteria) {
    if (info.word != name) continue;
    tell("{} (criterion of a check)\n  {}\n", info.word, info.text);
    return true;
  }
  return false;
}

bool describe_quantity(std::string_view name) {
  if (const auto c = cases::component_of_force(name)) {
    tell(
        "{} (prescribed quantity)\n  {} {} of a held component, under 'force:'; result column {}\n",
        name, law::is_rotation(*c) ? "Constraint moment" : "Constraint force", *c % 3 + 1,
        cases::force_column("CRF", *c));
    return true;
  }
  bool found = false;
  for (const results::Column& column : all_columns()) {
    if (column.name != name) continue;
    // A name may have another meaning with another connection.
    if (!found) tell("{} (result column)\n", column.name);
    tell("  {}\n", column.text);
    found = true;
  }
  return found;
}

int unknown(std::string_view what, std::string_view name, std::span<const std::string_view> known) {
  terminal::print_error(
      fmt::format("slipbench: no {} '{}'; {}\n", what, base::printable(name),
                  base::did_you_mean(name, known, "'slipbench list' shows what there is")));
  return base::kExitBadInput;
}

}  // namespace

int list_command(const std::string& what) {
  if (!what.empty() && std::find(kLists.begin(), kLists.end(), what) == kLists.end()) {
    return unknown("list", what, kLists);
  }
  if (what.empty() || what == "connections") list_connections();
  if (what.empty() || what == "laws") list_laws();
  if (what.empty() || what == "keys") list_keys();
  if (what.empty() || what == "closed-forms") list_closed_forms();
  if (what.empty() || what == "curves") list_curves();
  if (what.empty() || what == "criteria") list_criteria();
  if (what.empty() || what == "quantities") list_quantities();
  return base::kExitOk;
}

int describe_command(const std::string& name) {
  if (describe_connection(name) || describe_known_type(name) || told(describe_law(name)))
    return base::kExitOk;
  // Other names may be those of several things.
  bool known_name = describe_closed_form(name);
  known_name = describe_quantity(name) || known_name;
  known_name = told(describe_key(name)) || known_name;
  known_name = told(describe_entries(name)) || known_name;
  known_name = describe_criterion(name) || known_name;
  known_name = told(check::curve_description(name)) || known_name;
  if (known_name) return base::kExitOk;
  std::vector<std::string_view> known;
  law::for_each_connection_type(
      [&]<class Type>(std::type_identity<Type>) { known.push_back(Type::kInfo.name); });
  for_each_law([&]<class Law>(std::type_identity<Law>) { known.push_back(Law::kName); });
  for (const reference::ClosedForm& form : reference::catalogue()) known.push_back(form.name);
  const std::vector<results::Column> columns = all_columns();
  for (const results::Column& column : columns) known.push_back(column.name);
  const std::vector<std::string> keys = key_names();
  known.insert(known.end(), keys.begin(), keys.end());
  for (const check::CriterionInfo& info : check::kCriteria) known.push_back(info.word);
  const std::vector<check::ShippedCurve> curves = check::shipped_curves();
  for (const check::ShippedCurve& curve : curves) known.push_back(curve.name);
  return unknown("connection, law, closed form, quantity, key, criterion or curve", name, known);
}

int schema_command(bool markdown, read::FileKind kind) {
  if (markdown) {
    terminal::print(read::case_reference_markdown() + calibrate::fit_reference_markdown() +
                    sweep::sweep_reference_markdown());
    return base::kExitOk;
  }
  const yaml::Json schema = kind == read::FileKind::kFit     ? calibrate::fit_schema()
                            : kind == read::FileKind::kSweep ? sweep::sweep_schema()
                                                             : read::case_schema();
  terminal::print(schema.dump(2) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
