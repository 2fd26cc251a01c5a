// SPDX-License-Identifier: Apache-2.0
// A case as it is written: the structs beside whose members every key of the format is declared.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/case/integration.hpp"
#include "driver/check/criteria/criteria.hpp"
#include "driver/history/profile.hpp"
#include "driver/read/keys/choices.hpp"
#include "driver/read/keys/data_source_text.hpp"
#include "driver/yaml/binding.hpp"
#include "law/definition/formulation.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/potential_terms.hpp"
#include "law/table/table.hpp"

namespace slipbench::driver::read {

struct UnitsText {
  yaml::At<std::string> length, force, time, temperature;

  static void declare(auto& key) {
    key("length", &UnitsText::length,
        {.text = "Unit of length, e.g. mm.", .default_text = "not stated"});
    key("force", &UnitsText::force,
        {.text = "Unit of force, e.g. N.", .default_text = "not stated"});
    key("time", &UnitsText::time, {.text = "Unit of time, e.g. s.", .default_text = "not stated"});
    key("temperature", &UnitsText::temperature,
        {.text = "Unit of temperature, e.g. degC.", .default_text = "not stated"});
  }
};

/// One connection type, or two basic ones.
struct TypeNames {
  std::vector<yaml::At<std::string>> names;
};

/// One number or a list of numbers.
struct NumberOrList {
  std::vector<double> values;
  bool list = false;
};

/// Nodes of a belt.
struct NodesText {
  yaml::At<std::vector<double>> a, b, c;

  static void declare(auto& key) {
    key("a", &NodesText::a,
        {.required = true,
         .text = "Position [x, y, z] of node a, where the belt comes from.",
         .dimension = base::kLength});
    key("b", &NodesText::b,
        {.required = true,
         .text = "Position [x, y, z] of node b, the ring.",
         .dimension = base::kLength});
    key("c", &NodesText::c,
        {.required = true,
         .text = "Position [x, y, z] of node c, where the belt goes to.",
         .dimension = base::kLength});
  }
};

struct ConnectorText {
  yaml::At<TypeNames> type;
  yaml::At<int> dimension = yaml::default_of(3);
  yaml::NamedMap<double> reference;
  yaml::NamedMap<double> initial;
  yaml::At<NumberOrList> wrap_angle;
  yaml::At<NodesText> nodes;
  yaml::At<int> half_turns;
  yaml::At<std::vector<double>> lengths;
  yaml::At<double> initial_strain = yaml::default_of(0.0);
  yaml::At<double> area;
  yaml::At<double> friction_radius;
  yaml::At<std::vector<yaml::At<int>>> parts;

  static void declare(auto& key) {
    key("type", &ConnectorText::type,
        {.required = true, .text = "Connection type, or a list of two basic types."});
    key("dimension", &ConnectorText::dimension,
        {.text = "Dimension of space; 2 exists for SLOT and CONTACT only.",
         .default_text = "3",
         .bounds = {.lower = 2, .upper = 3}});
    key("reference", &ConnectorText::reference,
        {.text = "Constitutive reference positions, {CP1: ..}; angles in radians.",
         .default_text = "the initial position",
         .unit = yaml::UnitUse::kQuantity});
    key("initial", &ConnectorText::initial,
        {.text = "Initial relative position, {CP1: ..}; angles in radians.",
         .default_text = "0",
         .unit = yaml::UnitUse::kQuantity});
    key("wrap_angle", &ConnectorText::wrap_angle,
        {.text = "SLIPRING: angle the belt turns by on its ring, in radians, of any size; "
                 "a list for a belt that runs over ring after ring.",
         .default_text = "from nodes",
         .dimension = base::kAngle,
         .bounds = law::kNotNegative});
    key("nodes", &ConnectorText::nodes,
        {.text = "SLIPRING: positions of the nodes: the distance CP1 follows from them, and the "
                 "wrap angle where it is not given.",
         .default_text = "none: initial CP1, wrap_angle"});
    key("half_turns", &ConnectorText::half_turns,
        {.text = "SLIPRING with nodes: whole half turns of the belt on its ring at the "
                 "start; its angle follows the nodes from there, of any size.",
         .default_text = "the angle stays within half a turn",
         .bounds = {.lower = 0, .upper = 1000}});
    key("lengths", &ConnectorText::lengths,
        {.text = "SLIPRING: length of the segment behind each ring, in the belt's order; "
                 "flows and strains of these segments then follow.",
         .default_text = "not modelled: all rings share one flow",
         .dimension = base::kLength,
         .bounds = law::kPositive});
    key("initial_strain", &ConnectorText::initial_strain,
        {.text = "SLIPRING: strain of the belt between a and b at the start.",
         .default_text = "0",
         .bounds = {.lower = -1.0, .lower_open = true}});
    key("area", &ConnectorText::area,
        {.text = "Area A of the contact, for coefficients that see the pressure p = F_N/A.",
         .default_text = "that of each coefficient",
         .dimension = {0, 2, 0},
         .bounds = law::kPositive});
    key("friction_radius", &ConnectorText::friction_radius,
        {.text = "R at which a coefficient that sliding and spinning share sees the "
                 "spinning: at the speed R w and the force M_N/R.",
         .default_text = "none: w and M_N as they are",
         .dimension = base::kLength,
         .bounds = law::kPositive});
    key("parts", &ConnectorText::parts,
        {.text = "Ids of the two parts that meet here: pick a record of friction_pairs.",
         .default_text = "none",
         .bounds = {.lower = 1}});
  }
};

/// The keys that all tables share, whatever their columns are.
template <class Text, class V>
void declare_rows(V& key) {
  key("rows", &Text::rows,
      {.text = "Rows of numbers; the first independent varies fastest, ascending.",
       .default_text = "from csv",
       .unit = yaml::UnitUse::kNone});
  key("csv", &Text::csv,
      {.text = "A CSV file with these columns, in place of rows.", .default_text = "from rows"});
  key("extrapolate", &Text::extrapolate,
      {.text = "Outside the table: the end value, or the end slope.",
       .default_text = "constant, or 'extrapolation' for the tables it is for"});
}

/// A table: `columns` names the dependents first, then the independents.
struct TableText {
  yaml::At<std::vector<yaml::At<std::string>>> columns;
  yaml::At<std::vector<std::vector<double>>> rows;
  yaml::At<DataSourceText> csv;
  yaml::At<law::Extrapolation> extrapolate = yaml::default_of(law::Extrapolation::kConstant);

  static void declare(auto& key) {
    key("columns", &TableText::columns,
        {.required = true,
         .text = "Names of the columns: the dependent quantities first, then the independents."});
    declare_rows<TableText>(key);
  }
};

using NumberOrTable = std::variant<double, TableText>;
using NumberOrMatrix = std::variant<double, std::vector<std::vector<double>>>;
using WeightsText = std::variant<std::vector<double>, TableText>;

struct DerivedTermText {
  yaml::At<law::TermOperator> combine;
  yaml::At<int> sign = yaml::default_of(1);
  yaml::At<std::vector<yaml::At<int>>> components;
  yaml::At<WeightsText> weights;

  static void declare(auto& key) {
    key("operator", &DerivedTermText::combine,
        {.text = "How the weighted forces are combined.", .default_text = "norm"});
    key("sign", &DerivedTermText::sign,
        {.text = "1 or -1.", .default_text = "1", .bounds = {.lower = -1, .upper = 1}});
    key("components", &DerivedTermText::components,
        {.required = true,
         .text = "Component numbers 1-6 of the forces and moments.",
         .bounds = {.lower = 1, .upper = 6}});
    key("weights", &DerivedTermText::weights,
        {.text = "A weight for each component: numbers, or a table over motions CP, CU, "
                 "temperature and fields.",
         .default_text = "1 each",
         .unit = yaml::UnitUse::kNone});
  }
};

struct PotentialTermText {
  yaml::At<int> component;
  yaml::At<std::string> derived;
  yaml::At<double> scale = yaml::default_of(1.0);
  yaml::At<double> shift = yaml::default_of(0.0);
  yaml::At<law::ContributionFunction> of;
  yaml::At<double> exponent;
  yaml::At<int> sign = yaml::default_of(1);

  static void declare(auto& key) {
    key("component", &PotentialTermText::component,
        {.text = "E: number 1-6 of a free component.",
         .default_text = "derived",
         .bounds = {.lower = 1, .upper = 6}});
    key("derived", &PotentialTermText::derived,
        {.text = "E: name of a derived component of free components.",
         .default_text = "component"});
    key("scale", &PotentialTermText::scale,
        {.text = "R of the contribution X = (E - a)/R; a radius turns a moment into a force.",
         .default_text = "1",
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kQuantity});
    key("shift", &PotentialTermText::shift,
        {.text = "a of the contribution, in the unit of E.",
         .default_text = "0",
         .unit = yaml::UnitUse::kQuantity});
    key("of", &PotentialTermText::of,
        {.text = "What of X counts: its absolute value, its positive part (macauley), or X "
                 "itself (none).",
         .default_text = "abs"});
    key("exponent", &PotentialTermText::exponent,
        {.text = "Exponent of this contribution; friction needs that of the potential.",
         .default_text = "the potential's",
         .bounds = {.lower = 1.0}});
    key("sign", &PotentialTermText::sign,
        {.text = "Sign of the contribution; friction needs 1.",
         .default_text = "1",
         .bounds = {.lower = -1, .upper = 1}});
  }
};

struct PotentialText {
  law::PotentialOperator combine = law::PotentialOperator::kSum;
  yaml::At<double> exponent = yaml::default_of(2.0);
  yaml::At<std::vector<yaml::At<PotentialTermText>>> terms;

  static void declare(auto& key) {
    key("operator", &PotentialText::combine,
        {.text = "sum: P = (sum of X^exponent)^(1/exponent); max: P is the largest X.",
         .default_text = "sum"});
    key("exponent", &PotentialText::exponent,
        {.text = "Exponent of the sum; for one beyond the range take operator max.",
         .default_text = "2",
         .bounds = {.lower = 1.0, .upper = 1.0e4}});
    key("terms", &PotentialText::terms, {.required = true, .text = "The contributions."});
  }
};

struct StickText {
  yaml::At<double> slip_tolerance, characteristic_length, elastic_slip, stiffness;

  static void declare(auto& key) {
    key("slip_tolerance", &StickText::slip_tolerance,
        {.text = "F_f: elastic slip as a part of the characteristic length.",
         .default_text = "1e-4",
         .bounds = law::kPositive});
    key("characteristic_length", &StickText::characteristic_length,
        {.text = "Length (angle for rotations) the slip tolerance refers to.",
         .default_text = "1, with a note",
         .dimension = base::kLength,
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("elastic_slip", &StickText::elastic_slip,
        {.text = "Allowable elastic slip g_c, in place of the slip tolerance.",
         .default_text = "slip_tolerance * characteristic_length",
         .dimension = base::kLength,
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("stiffness", &StickText::stiffness,
        {.text = "Constant stick stiffness kappa in the slip space, in place of an elastic slip.",
         .default_text = "limit / elastic slip",
         .dimension = {1, -1, 0},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
  }
};

struct OrthotropicText;
struct DirectionDependentText;

/// A number, a table, or a map with the name of one law of law::FrictionLaw; or two of these.
struct CoefficientText {
  std::variant<law::FrictionLaw, TableText> value;
  std::shared_ptr<const OrthotropicText> orthotropic;            ///< in place of the value
  std::shared_ptr<const DirectionDependentText> with_direction;  ///< in place of the value
};

/// The coefficient along one direction: everything a coefficient may be but two of them.
struct DirectionText {
  CoefficientText coefficient;
};

/// Two coefficients at right angles.
struct OrthotropicText {
  yaml::At<DirectionText> direction1, direction2;
  law::Orthotropy::Speed speed = law::Orthotropy::Speed::kComponent;
  yaml::At<std::vector<double>> axis;

  static void declare(auto& key) {
    key("direction1", &OrthotropicText::direction1,
        {.required = true, .text = "Coefficient along direction 1.", .bounds = law::kNotNegative});
    key("direction2", &OrthotropicText::direction2,
        {.required = true,
         .text = "Coefficient along direction 2, at right angles to direction 1.",
         .bounds = law::kNotNegative});
    key("speed", &OrthotropicText::speed,
        {.text = "Speed that each coefficient sees: the component of the motion along its "
                 "direction, or the total.",
         .default_text = "component"});
    key("axis", &OrthotropicText::axis,
        {.text = "Direction 1 in the two components that slip, of any length; direction 2 "
                 "is turned by 90 degrees from it.",
         .default_text = "[1, 0]"});
  }
};

/// One coefficient for each sense of the slip of one component.
struct DirectionDependentText {
  yaml::At<DirectionText> forward, backward;

  static void declare(auto& key) {
    key("forward", &DirectionDependentText::forward,
        {.required = true,
         .text = "Coefficient where the connector would slip towards larger positions, "
                 "under a positive friction force.",
         .bounds = law::kNotNegative});
    key("backward", &DirectionDependentText::backward,
        {.required = true,
         .text = "Coefficient where it would slip towards smaller positions, under a "
                 "negative friction force.",
         .bounds = law::kNotNegative});
  }
};

/// A contact penalty in place of the connector's return mapping.
struct FormulationText {
  yaml::At<PenaltyKind> penalty;
  yaml::At<double> visf;
  yaml::At<NumberOrTable> normal_stiffness;
  yaml::At<double> mass;
  yaml::At<double> viscous_coefficient;
  yaml::At<double> tangential_stiffness;
  law::Convention convention = law::Convention::kDocumented;

  static void declare(auto& key) {
    key("penalty", &FormulationText::penalty,
        {.required = true, .text = "viscous (Radioss Iform 1) or stiffness (Iform 2)."});
    key("VISF", &FormulationText::visf,
        {.text = "viscous: factor of the viscous coefficient C; 0 means 1.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("K", &FormulationText::normal_stiffness,
        {.text = "viscous: stiffness of the normal penalty, a number or a table over "
                 "contact_force, temperature, fields; C = VISF sqrt(2 K m).",
         .default_text = "C",
         .dimension = {1, -1, 0},
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("m", &FormulationText::mass,
        {.text = "viscous: mass of the contact point.",
         .default_text = "C",
         .dimension = {1, -1, 2},
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("C", &FormulationText::viscous_coefficient,
        {.text = "viscous: the coefficient itself, in place of VISF, K and m.",
         .default_text = "VISF sqrt(2 K m)",
         .dimension = {1, -1, 1},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("K_t", &FormulationText::tangential_stiffness,
        {.text = "stiffness: tangential stiffness of the contact.",
         .default_text = "-",
         .dimension = {1, -1, 0},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("convention", &FormulationText::convention,
        {.text = "Where the published page and the program differ: as the page promises, or "
                 "as OpenRadioss (2026) computes.",
         .default_text = "documented"});
  }
};

/// First-order filter of the friction force of a formulation.
struct FilterText {
  yaml::At<double> simple, period, frequency, xfreq;
  yaml::At<XfreqConvention> xfreq_convention;
  bool clip = false;

  static void declare(auto& key) {
    key("simple", &FilterText::simple,
        {.text = "alpha of F_k = alpha F + (1 - alpha) F_{k-1} (Radioss Ifiltr 1), up to 1; "
                 "0 is no filter.",
         .default_text = "another of the four",
         .bounds = {.lower = 0.0, .upper = 1.0}});
    key("period", &FilterText::period,
        {.text = "Time T of alpha = 2 pi dt/T (Ifiltr 2); increments longer than T/(2 pi) "
                 "are refused.",
         .default_text = "another of the four",
         .dimension = base::kTime,
         .bounds = law::kPositive});
    key("frequency", &FilterText::frequency,
        {.text = "Cut-off frequency f of alpha = min(1, 2 pi f dt) (Ifiltr 3); 0 is no "
                 "filter.",
         .default_text = "another of the four",
         .dimension = {0, 0, -1},
         .bounds = law::kNotNegative});
    key("Xfreq", &FilterText::xfreq,
        {.text = "The number of Ifiltr 2 as a deck has it, read as xfreq_convention says; "
                 "0 is no filter.",
         .default_text = "another of the four",
         .bounds = law::kNotNegative});
    key("xfreq_convention", &FilterText::xfreq_convention,
        {.text = "steps: Xfreq = T/dt, as OpenRadioss (2026) computes; ratio: Xfreq = dt/T, "
                 "as the page says.",
         .default_text = "required with Xfreq"});
    key("clip", &FilterText::clip,
        {.text = "true: a filtered force above the limit is taken back to it, which neither "
                 "the page nor the program does.",
         .default_text = "false"});
  }
};

/// A component number or the name of a derived component.
struct ContactForceText {
  std::variant<int, std::string> value;
};

/// The parameters of predefined friction; which they are is known with the connection type.
struct PredefinedText {
  std::optional<yaml::Node> node;
};

struct FrictionText {
  yaml::At<std::string> name;
  yaml::At<PredefinedText> predefined;
  yaml::At<int> component;
  yaml::At<PotentialText> potential;
  yaml::At<ContactForceText> contact_force;
  yaml::At<NumberOrTable> internal_contact_force;
  yaml::At<CoefficientText> coefficient;
  yaml::At<double> force_limit;
  yaml::At<StickText> stick;
  yaml::At<FormulationText> formulation;
  yaml::At<FilterText> filter;

  static void declare(auto& key) {
    key("name", &FrictionText::name,
        {.text = "Name used in result columns where there are several definitions.",
         .default_text = "friction1, ..."});
    key("predefined", &FrictionText::predefined,
        {.text = "Predefined friction of the connection type, with its geometry.",
         .default_text = "component or potential"});
    key("component", &FrictionText::component,
        {.text = "Free component 1-6 that slips: P = abs(f_i).",
         .default_text = "predefined or potential",
         .bounds = {.lower = 1, .upper = 6}});
    key("potential", &FrictionText::potential,
        {.text = "Several free components that slip together.",
         .default_text = "predefined or component"});
    key("contact_force", &FrictionText::contact_force,
        {.text = "F_C: the name of a derived component, or a component number 1-6 (signed). "
                 "Of a held component the constraint force counts, of a free one its "
                 "spring, damper, stop and load, CEF + CVF + CRF - CCF.",
         .default_text = "none"});
    key("internal_contact_force", &FrictionText::internal_contact_force,
        {.text = "F_int: a number, or a table over accumulated_slip, temperature, fields, "
                 "CP and CU.",
         .default_text = "0",
         .dimension = base::kForce,
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("coefficient", &FrictionText::coefficient,
        {.text = "Coefficient of friction: a number, a table, or a law by name.",
         .default_text = "0: no friction",
         .bounds = law::kNotNegative});
    key("force_limit", &FrictionText::force_limit,
        {.text = "Cap f_t^max of the limiting friction force; 0 means none.",
         .default_text = "none",
         .dimension = base::kForce,
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("stick", &FrictionText::stick,
        {.text = "How stiff the connector is while it sticks.",
         .default_text = "slip tolerance 1e-4"});
    key("formulation", &FrictionText::formulation,
        {.text = "The penalty of a Radioss contact in place of 'stick'.",
         .default_text = "the connector's stick and return mapping"});
    key("filter", &FrictionText::filter,
        {.text = "Smooths the friction force of a formulation over the increments.",
         .default_text = "none"});
  }
};

/// One side of a pair of parts: the id of a part, or the name of a group.
struct PartOrGroup {
  std::variant<int, std::string> value = 0;
};

/// Friction of a record of a table of part pairs.
struct PairDefaultText {
  yaml::At<CoefficientText> coefficient;
  yaml::At<double> visf, force_limit;

  static void declare(auto& key) { declare_friction<PairDefaultText>(key); }

  /// The keys that the default and the records share.
  template <class Text, class V>
  static void declare_friction(V& key) {
    key("coefficient", &Text::coefficient,
        {.required = true,
         .text = "Coefficient of friction: a number, a table, or a law by name.",
         .bounds = law::kNotNegative});
    key("VISF", &Text::visf,
        {.text = "VISF of a viscous penalty, in place of that under 'formulation:'; 0 means "
                 "1.",
         .default_text = "that of the formulation",
         .bounds = law::kNotNegative});
    key("force_limit", &Text::force_limit,
        {.text = "Cap f_t^max of the limiting friction force, in place of the definition's; 0 "
                 "means none.",
         .default_text = "that of the definition",
         .dimension = base::kForce,
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
  }
};

/// A record of a table of part pairs.
struct PartPairText {
  yaml::At<std::vector<yaml::At<PartOrGroup>>> parts;
  yaml::At<CoefficientText> coefficient;
  yaml::At<double> visf, force_limit;

  static void declare(auto& key) {
    key("parts", &PartPairText::parts,
        {.required = true, .text = "The two sides, each a part or a group."});
    PairDefaultText::declare_friction<PartPairText>(key);
  }
};

/// Friction by the parts that meet: `connector.parts` picks the record.
struct FrictionPairsText {
  yaml::At<std::vector<yaml::At<int>>> parts;
  yaml::NamedMap<std::vector<yaml::At<int>>> groups;
  yaml::At<PairDefaultText> otherwise;
  yaml::At<std::vector<yaml::At<PartPairText>>> pairs;

  static void declare(auto& key) {
    key("parts", &FrictionPairsText::parts,
        {.text = "Ids of all parts there are, so that a mistyped one is found.",
         .default_text = "any id will do",
         .bounds = {.lower = 1}});
    key("groups", &FrictionPairsText::groups,
        {.text = "Named lists of part ids.", .default_text = "none", .bounds = {.lower = 1}});
    key("default", &FrictionPairsText::otherwise,
        {.text = "Friction of the parts that no pair joins.",
         .default_text = "none: such parts are an error"});
    key("pairs", &FrictionPairsText::pairs,
        {.text = "Records in order, each symmetric; of those that join the two parts the "
                 "last one holds.",
         .default_text = "none"});
  }
};

struct IntegrationText {
  yaml::At<cases::IntegrationMethod> method =
      yaml::default_of(cases::IntegrationMethod::kBackwardEuler);
  yaml::At<double> tolerance = yaml::default_of(cases::Integration{}.tolerance);
  yaml::At<law::AccumulatedSlipTiming> accumulated_slip =
      yaml::default_of(law::AccumulatedSlipTiming::kEnd);
  yaml::At<law::SlipRateMeasure> slip_rate = yaml::default_of(law::SlipRateMeasure::kSlip);
  yaml::At<cases::SnapBackAction> snap_back = yaml::default_of(cases::SnapBackAction::kStop);

  static void declare(auto& key) {
    key("method", &IntegrationText::method,
        {.text = "Integration over an increment: one implicit step, as solvers do, or the "
                 "continuous solution between the rows.",
         .default_text = "backward_euler"});
    key("tolerance", &IntegrationText::tolerance,
        {.text = "Of exact integration, as a part of the limit, where there is no closed "
                 "solution.",
         .default_text = "1e-10",
         .bounds = {.lower = 1e-13, .upper = 1e-3}});
    key("accumulated_slip", &IntegrationText::accumulated_slip,
        {.text = "Accumulated slip that the internal contact force sees: of the end of the "
                 "increment (implicit) or of its start.",
         .default_text = "end"});
    key("slip_rate", &IntegrationText::slip_rate,
        {.text = "Rate that the coefficient sees: of the slip, or of the whole motion.",
         .default_text = "slip"});
    key("snap_back", &IntegrationText::snap_back,
        {.text = "Where wear takes the limit away faster than the stick spring follows: end "
                 "the run, or jump to the next equilibrium and book the energy lost.",
         .default_text = "stop"});
  }
};

/// A profile of a step, compiled.
struct ProfileText {
  history::Profile profile;
  yaml::At<DataSourceText> csv;           ///< of a CsvColumn
  yaml::At<std::string> unit, time_unit;  ///< of a CsvColumn
  double begins = 0.0;                    ///< time in its file [T]
};

/// Motion of the nodes of a belt in a step.
struct NodeMotionText {
  yaml::At<std::vector<yaml::At<ProfileText>>> a, b, c;

  static void declare(auto& key) {
    constexpr std::string_view kText =
        "Profiles [x, y, z] of the node's coordinates; a number is one that stays.";
    key("a", &NodeMotionText::a,
        {.text = kText, .default_text = "unchanged", .unit = yaml::UnitUse::kQuantity});
    key("b", &NodeMotionText::b,
        {.text = kText, .default_text = "unchanged", .unit = yaml::UnitUse::kQuantity});
    key("c", &NodeMotionText::c,
        {.text = kText, .default_text = "unchanged", .unit = yaml::UnitUse::kQuantity});
  }
};

/// Course of a change of friction: by a word, or by a table of weights over the time in the step.
struct AmplitudeText {
  history::Profile profile = history::LinearTo{1.0};  ///< from 0 to 1
};

/// New friction of one definition, in force at the end of the step.
struct FrictionChangeText {
  yaml::At<CoefficientText> coefficient;
  yaml::At<AmplitudeText> amplitude;
  yaml::At<double> force_limit;
  yaml::At<StickText> stick;
  yaml::At<bool> reset;

  static void declare(auto& key) {
    key("coefficient", &FrictionChangeText::coefficient,
        {.text = "The new coefficient: a number, a table, or a law by name.",
         .default_text = "required but with reset",
         .bounds = law::kNotNegative});
    key("amplitude", &FrictionChangeText::amplitude,
        {.text = "How the coefficient goes over: mu = mu_start + A(t) (mu_end - mu_start).",
         .default_text = "linear"});
    key("force_limit", &FrictionChangeText::force_limit,
        {.text = "New cap of the limiting friction force from the start of the step; 0 "
                 "means none.",
         .default_text = "unchanged",
         .dimension = base::kForce,
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("stick", &FrictionChangeText::stick,
        {.text = "New stick stiffness of the same kind.", .default_text = "unchanged"});
    key("reset", &FrictionChangeText::reset,
        {.text = "true: back to the friction under 'friction:', in place of a coefficient.",
         .default_text = "false"});
  }
};

struct StepText {
  yaml::At<std::string> step;
  yaml::At<double> duration = yaml::default_of(1.0);
  int increments = 1;
  int repeat = 1;
  yaml::NamedMap<ProfileText> motion;
  yaml::At<NodeMotionText> nodes;
  yaml::NamedMap<ProfileText> force;
  yaml::At<ProfileText> temperature;
  yaml::NamedMap<ProfileText> fields;
  yaml::NamedMap<FrictionChangeText> change_friction;

  static void declare(auto& key) {
    key("step", &StepText::step, {.required = true, .text = "Name of the step."});
    key("duration", &StepText::duration,
        {.text = "Length of the step in time.",
         .default_text = "1",
         .dimension = base::kTime,
         .bounds = law::kPositive});
    key("increments", &StepText::increments,
        {.required = true,
         .text = "Number of equal increments; breakpoints of the profiles are added.",
         .bounds = {.lower = 1}});
    key("repeat", &StepText::repeat,
        {.text = "How often the step runs, one run after the other.",
         .default_text = "1",
         .bounds = {.lower = 1}});
    key("motion", &StepText::motion,
        {.text = "Profiles of free components, {CP1: ..., CPR1: ...}.",
         .default_text = "unchanged",
         .unit = yaml::UnitUse::kQuantity});
    key("nodes", &StepText::nodes,
        {.text = "SLIPRING with nodes: how they move, {c: [profile, profile, profile]}.",
         .default_text = "unchanged"});
    key("force", &StepText::force,
        {.text = "Profiles of constraint forces and moments, {f2: ..., m3: ...}.",
         .default_text = "unchanged",
         .unit = yaml::UnitUse::kQuantity});
    key("temperature", &StepText::temperature,
        {.text = "Profile of the temperature.",
         .default_text = "unchanged, at first 0",
         .unit = yaml::UnitUse::kQuantity});
    key("fields", &StepText::fields,
        {.text = "Profiles of field variables, {field1: ...}.",
         .default_text = "unchanged, at first 0",
         .unit = yaml::UnitUse::kQuantity});
    key("change_friction", &StepText::change_friction,
        {.text = "New friction of definitions by name, {sleeve: {coefficient: 0.12}}.",
         .default_text = "unchanged"});
  }
};

/// A column of a CSV file: its name, or its name and unit.
struct MeasuredColumnText {
  yaml::At<std::string> column;
  yaml::At<std::string> unit;
};

struct MeasuredText {
  yaml::At<DataSourceText> csv;
  yaml::At<std::string> time;
  yaml::At<std::string> time_unit;
  yaml::At<yaml::NamedMap<MeasuredColumnText>> columns;
  bool hold = false;

  static void declare(auto& key) {
    key("csv", &MeasuredText::csv,
        {.required = true, .text = "CSV file whose rows drive the case, one increment a row."});
    key("time", &MeasuredText::time, {.required = true, .text = "Name of the time column."});
    key("unit", &MeasuredText::time_unit,
        {.text = "Unit of the time column.", .default_text = "the case's"});
    key("columns", &MeasuredText::columns,
        {.required = true,
         .text = "Which quantity each column drives: {CP1: disp, f2: {column: load, unit: lbf}}."});
    key("hold", &MeasuredText::hold,
        {.text = "true: a value holds until the next row; false: linear between rows.",
         .default_text = "false"});
  }
};

/// Steps, or one measured history.
struct HistoryText {
  std::vector<yaml::At<StepText>> steps;
  std::optional<MeasuredText> measured;
};

struct OutputText {
  int every = 1;
  yaml::At<std::vector<yaml::At<std::string>>> columns;

  static void declare(auto& key) {
    key("every", &OutputText::every,
        {.text = "Write every n-th increment, and the last of the run.",
         .default_text = "1",
         .bounds = {.lower = 1}});
    key("columns", &OutputText::columns,
        {.text = "Result columns to write; t is always the first.", .default_text = "all"});
  }
};

struct AgainstText {
  yaml::At<std::string> expression;
  yaml::At<std::string> closed_form;
  yaml::At<yaml::NamedMap<NumberOrList>> with;
  yaml::NamedMap<std::string> inputs;
  yaml::At<std::string> output;
  yaml::At<DataSourceText> curve;
  yaml::At<MeasuredColumnText> abscissa;
  yaml::At<MeasuredColumnText> column;

  static void declare(auto& key) {
    key("expression", &AgainstText::expression,
        {.text = "Expression over t, T, parameters and result columns.",
         .default_text = "closed_form or curve"});
    key("closed_form", &AgainstText::closed_form,
        {.text = "Name of a closed form (slipbench list closed-forms).",
         .default_text = "expression or curve"});
    key("with", &AgainstText::with,
        {.text = "Parameters of the closed form.",
         .default_text = "its defaults",
         .unit = yaml::UnitUse::kNone});
    key("inputs", &AgainstText::inputs,
        {.text = "Result columns or expressions over them that drive the closed form, "
                 "{motion: CU1} or {phase: = 2*pi*T}.",
         .default_text = "the columns of the same meaning"});
    key("output", &AgainstText::output,
        {.text = "Which result of the closed form is compared.",
         .default_text = "what the quantity is"});
    key("curve", &AgainstText::curve,
        {.text = "CSV file of a reference curve, or the name of a shipped one (slipbench "
                 "list curves).",
         .default_text = "expression or closed_form"});
    key("abscissa", &AgainstText::abscissa,
        {.text = "Column of the curve that holds the abscissa, with its unit if it is "
                 "another: {column: stroke, unit: in}.",
         .default_text = "that of the abscissa's name"});
    key("column", &AgainstText::column,
        {.text = "Column of the curve that is compared, with its unit if it is another: "
                 "{column: load, unit: lbf}.",
         .default_text = "that of the quantity's name"});
  }
};

struct OverText {
  yaml::At<double> from, to;

  static void declare(auto& key) {
    key("from", &OverText::from,
        {.text = "First total time.", .default_text = "the start", .dimension = base::kTime});
    key("to", &OverText::to,
        {.text = "Last total time.", .default_text = "the end", .dimension = base::kTime});
  }
};

struct ToleranceText {
  yaml::At<double> absolute, relative, abscissa;
  std::string why;

  static void declare(auto& key) {
    key("absolute", &ToleranceText::absolute,
        {.text = "Admissible deviation in the quantity's unit.",
         .default_text = "relative",
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kQuantity,
         .difference = true});
    key("relative", &ToleranceText::relative,
        {.text = "Admissible deviation as a part of the reference's range.",
         .default_text = "absolute",
         .bounds = law::kNotNegative});
    key("abscissa", &ToleranceText::abscissa,
        {.text = "Admissible shift along the abscissa, in its unit, of the points that "
                 "breakaway and reversals compare.",
         .default_text = "relative, of the abscissa's range",
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kNone});
    key("why", &ToleranceText::why,
        {.text = "Which error this tolerance allows for.", .default_text = "none"});
  }
};

struct CheckText {
  yaml::At<std::string> name;
  yaml::At<std::string> quantity;
  yaml::At<AgainstText> against;
  yaml::At<std::string> step;
  yaml::At<OverText> over;
  yaml::At<cases::Criterion> criterion;
  yaml::At<std::string> abscissa;
  yaml::At<ToleranceText> tolerance;

  static void declare(auto& key) {
    key("name", &CheckText::name, {.required = true, .text = "What the check shows."});
    key("quantity", &CheckText::quantity,
        {.required = true,
         .text = "A result column, or an expression over t, T, parameters and columns."});
    key("against", &CheckText::against,
        {.required = true, .text = "What the quantity is compared with."});
    key("step", &CheckText::step,
        {.text = "Compare the rows of this step only.", .default_text = "all steps"});
    key("over", &CheckText::over,
        {.text = "Compare the rows within these total times only.",
         .default_text = "the whole run"});
    key("criterion", &CheckText::criterion,
        {.text = "How the two are compared.", .default_text = "pointwise"});
    key("abscissa", &CheckText::abscissa,
        {.text = "What the two are compared over: time, accumulated_slip, a result column, "
                 "or an expression over t, T, parameters and columns.",
         .default_text = "time, or what 'against: {abscissa: ..}' names"});
    key("tolerance", &CheckText::tolerance,
        {.required = true, .text = "How far they may be apart; the larger of the two counts."});
  }
};

/// A spring along a component: linear, or a table whose keys stand beside the component; or linear
/// springs that join several components.
struct ElasticityText {
  yaml::At<int> component;
  yaml::At<std::vector<yaml::At<int>>> components;
  yaml::At<NumberOrMatrix> stiffness;
  yaml::At<std::vector<yaml::At<std::string>>> columns;
  yaml::At<std::vector<std::vector<double>>> rows;
  yaml::At<DataSourceText> csv;
  yaml::At<law::Extrapolation> extrapolate = yaml::default_of(law::Extrapolation::kConstant);

  static void declare(auto& key) {
    key("component", &ElasticityText::component,
        {.text = "Number 1-6 of a free component.",
         .default_text = "components",
         .bounds = {.lower = 1, .upper = 6}});
    key("components", &ElasticityText::components,
        {.text = "Numbers 1-6 of two or more free components that a stiffness matrix joins.",
         .default_text = "component",
         .bounds = {.lower = 1, .upper = 6}});
    key("stiffness", &ElasticityText::stiffness,
        {.text = "k of the force k u along the component, u its constitutive displacement; "
                 "of several components the matrix K of the forces K u, row by row, "
                 "symmetric and positive semidefinite.",
         .default_text = "a table",
         .dimension = {1, -1, 0},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("columns", &ElasticityText::columns,
        {.text = "Columns of a table in place of the stiffness: a name for the force, then "
                 "displacement, temperature, fields.",
         .default_text = "a stiffness"});
    declare_rows<ElasticityText>(key);
  }
};

/// A damper along a component: linear, or a table whose keys stand beside the component.
struct DampingText {
  yaml::At<int> component;
  yaml::At<double> coefficient;
  yaml::At<std::vector<yaml::At<std::string>>> columns;
  yaml::At<std::vector<std::vector<double>>> rows;
  yaml::At<DataSourceText> csv;
  yaml::At<law::Extrapolation> extrapolate = yaml::default_of(law::Extrapolation::kConstant);

  static void declare(auto& key) {
    key("component", &DampingText::component,
        {.required = true,
         .text = "Number 1-6 of a free component.",
         .bounds = {.lower = 1, .upper = 6}});
    key("coefficient", &DampingText::coefficient,
        {.text = "c of the force c v along the component, v its velocity.",
         .default_text = "a table",
         .dimension = {1, -1, 1},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("columns", &DampingText::columns,
        {.text = "Columns of a table in place of the coefficient: a name for the force, then "
                 "velocity, temperature, fields.",
         .default_text = "a coefficient"});
    declare_rows<DampingText>(key);
  }
};

struct StopText {
  yaml::At<int> component;
  yaml::At<double> lower, upper;

  static void declare(auto& key) {
    key("component", &StopText::component,
        {.required = true,
         .text = "Number 1-6 of a free component.",
         .bounds = {.lower = 1, .upper = 6}});
    key("lower", &StopText::lower,
        {.text = "Lowest position CP of the component.",
         .default_text = "no stop below",
         .dimension = base::kLength,
         .unit = yaml::UnitUse::kSlip});
    key("upper", &StopText::upper,
        {.text = "Highest position CP of the component.",
         .default_text = "no stop above",
         .dimension = base::kLength,
         .unit = yaml::UnitUse::kSlip});
  }
};

struct PlayPositionText {
  std::variant<PlayPlace, double> value = PlayPlace::kCentred;
};

/// Backlash between the connector and the friction of one component.
struct DeadZoneText {
  yaml::At<int> component;
  yaml::At<double> width;
  yaml::At<PlayPositionText> position;

  static void declare(auto& key) {
    key("component", &DeadZoneText::component,
        {.required = true,
         .text = "Number 1-6 of a free component that slips alone in its definition.",
         .bounds = {.lower = 1, .upper = 6}});
    key("width", &DeadZoneText::width,
        {.required = true,
         .text = "g: free travel without force at every reversal; 0 is none.",
         .dimension = base::kLength,
         .bounds = law::kNotNegative,
         .unit = yaml::UnitUse::kSlip});
    key("position", &DeadZoneText::position,
        {.text = "Play at the start: centred, lower (motion to smaller positions meets "
                 "friction at once), upper, or a number from -width/2 to width/2.",
         .default_text = "centred",
         .dimension = base::kLength,
         .unit = yaml::UnitUse::kSlip});
  }
};

/// The second mass of a clutch or brake.
struct DriverText {
  yaml::At<double> mass;
  yaml::At<double> velocity = yaml::default_of(0.0);

  static void declare(auto& key) {
    key("mass", &DriverText::mass,
        {.required = true,
         .text = "Mass of the driver, or its moment of inertia.",
         .dimension = {1, -1, 2},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("velocity", &DriverText::velocity,
        {.text = "Velocity of the driver at the start.",
         .default_text = "0",
         .dimension = {0, 1, -1},
         .unit = yaml::UnitUse::kSlip});
  }
};

/// One free component as a mass on a belt, or on a driver.
struct DynamicsText {
  yaml::At<int> component;
  yaml::At<double> mass;
  yaml::At<double> belt_velocity = yaml::default_of(0.0);
  yaml::At<double> initial_velocity = yaml::default_of(0.0);
  yaml::At<double> static_coefficient;
  yaml::At<DriverText> driver;

  static void declare(auto& key) {
    key("component", &DynamicsText::component,
        {.text = "Number 1-6 of the free component that moves.",
         .default_text = "the only free one",
         .bounds = {.lower = 1, .upper = 6}});
    key("mass", &DynamicsText::mass,
        {.required = true,
         .text = "Mass, or moment of inertia of a rotation.",
         .dimension = {1, -1, 2},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kSlip});
    key("belt_velocity", &DynamicsText::belt_velocity,
        {.text = "Constant velocity of the belt the mass rubs on.",
         .default_text = "0",
         .dimension = {0, 1, -1},
         .unit = yaml::UnitUse::kSlip});
    key("initial_velocity", &DynamicsText::initial_velocity,
        {.text = "Velocity of the mass at the start.",
         .default_text = "0",
         .dimension = {0, 1, -1},
         .unit = yaml::UnitUse::kSlip});
    key("static_coefficient", &DynamicsText::static_coefficient,
        {.text = "Coefficient that holds while the mass sticks.",
         .default_text = "the coefficient at rate 0",
         .bounds = law::kNotNegative});
    key("driver", &DynamicsText::driver,
        {.text = "A second mass to rub on, free as the first: a clutch.",
         .default_text = "none: the mass rubs on the belt"});
  }
};

/// The value of a parameter; expressions are resolved before the rest of the case is read.
struct ParameterValue {};

struct CaseText {
  yaml::At<int> slipbench;
  std::string title;
  UnitsText units;
  yaml::NamedMap<ParameterValue> parameters;
  yaml::At<ConnectorText> connector;
  yaml::At<yaml::NamedMap<std::vector<yaml::At<DerivedTermText>>>> derived_components;
  yaml::At<std::vector<yaml::At<FrictionText>>> friction;
  yaml::At<FrictionPairsText> friction_pairs;
  yaml::At<law::Extrapolation> extrapolation = yaml::default_of(law::Extrapolation::kConstant);
  yaml::At<std::vector<yaml::At<ElasticityText>>> elasticity;
  yaml::At<std::vector<yaml::At<DampingText>>> damping;
  yaml::At<std::vector<yaml::At<StopText>>> stops;
  yaml::At<std::vector<yaml::At<DeadZoneText>>> dead_zone;
  yaml::At<DynamicsText> dynamics;
  IntegrationText integration;
  yaml::At<HistoryText> history;
  OutputText output;
  yaml::At<std::vector<yaml::At<CheckText>>> checks;

  static void declare(auto& key) {
    key("slipbench", &CaseText::slipbench,
        {.required = true,
         .text = "Version of the case format: 1.",
         .bounds = {.lower = 1, .upper = 1}});
    key("title", &CaseText::title,
        {.text = "One line for results and plots.", .default_text = "the file's name"});
    key("units", &CaseText::units,
        {.text = "The one consistent system of units; angles are radians.",
         .default_text = "none"});
    key("parameters", &CaseText::parameters,
        {.text = "Named numbers for expressions, --set, sweeps and fits.",
         .default_text = "none",
         .unit = yaml::UnitUse::kAny,
         .most = base::kMostParameters});
    key("connector", &CaseText::connector, {.required = true, .text = "The connector."});
    key("derived_components", &CaseText::derived_components,
        {.text = "Named contact forces g(f); the terms of a name are added.",
         .default_text = "none"});
    key("friction", &CaseText::friction,
        {.required = true, .text = "Friction definitions, each a stick-slip check of its own."});
    key("friction_pairs", &CaseText::friction_pairs,
        {.text = "Coefficients by the parts that meet; connector.parts picks one.",
         .default_text = "none: each definition has its own coefficient"});
    key("extrapolation", &CaseText::extrapolation,
        {.text = "Of the tables of elasticity, damping, weights and internal contact force "
                 "that have no 'extrapolate': the end value, or the end slope. Coefficients "
                 "have their own.",
         .default_text = "constant"});
    key("elasticity", &CaseText::elasticity,
        {.text = "Springs along free components, in parallel with friction.",
         .default_text = "none"});
    key("damping", &CaseText::damping,
        {.text = "Dampers along free components, in parallel with friction.",
         .default_text = "none"});
    key("stops", &CaseText::stops,
        {.text = "Rigid stops of free components.", .default_text = "none"});
    key("dead_zone", &CaseText::dead_zone,
        {.text = "Backlash in series with the friction of single components.",
         .default_text = "none"});
    key("dynamics", &CaseText::dynamics,
        {.text = "One free component as a mass with rigid stick, stepped in time.",
         .default_text = "none: motions and forces are quasi-static"});
    key("integration", &CaseText::integration,
        {.text = "How an increment is integrated.", .default_text = "as below"});
    key("history", &CaseText::history,
        {.required = true, .text = "Steps in order, or a measured history."});
    key("output", &CaseText::output,
        {.text = "What the result file holds.", .default_text = "everything"});
    key("checks", &CaseText::checks,
        {.text = "What the run is held against.", .default_text = "none", .most = 1000});
  }
};

}  // namespace slipbench::driver::read
