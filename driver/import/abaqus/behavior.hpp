// SPDX-License-Identifier: Apache-2.0
// Connector behaviours of an Abaqus deck, as they are written.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "driver/import/abaqus/keyword_deck.hpp"

namespace slipbench::driver::abaqus {

/// Row of numbers; an item that is left out has none.
using Row = std::vector<std::optional<double>>;

/// Term of *CONNECTOR DERIVED COMPONENT.
struct DerivedTerm {
  std::string_view where;
  std::string op = "NORM";  ///< NORM, SUM or MACAULEY SUM
  int sign = 1;
  bool constitutive = false;           ///< independents are motions CU, not positions CP
  std::vector<int> independents = {};  ///< components
  int fields = 0;                      ///< of DEPENDENCIES
  std::vector<int> components = {};    ///< of the forces
  std::vector<Row> rows = {};          ///< weights, independents, temperature, fields
};

/// Contribution of *CONNECTOR POTENTIAL.
struct PotentialTerm {
  std::string_view where;
  std::variant<int, std::string> of = 0;  ///< a component, or the label of a derived one
  double scale = 1.0;
  std::optional<double> exponent = std::nullopt;
  std::string use = "ABS";  ///< ABS, MACAULEY or NONE
  double shift = 0.0;
  int sign = 1;
};
struct Potential {
  bool maximum = false;
  double exponent = 2.0;
  std::vector<PotentialTerm> terms = {};
};

/// *FRICTION: mu over slip rate, contact force, temperature and fields, or a decay.
struct Coefficient {
  enum class Kind { kTable, kDecay, kTestData };
  std::string_view where;
  Kind kind = Kind::kTable;
  int fields = 0;
  std::vector<Row> rows = {};
  std::optional<double> force_limit = std::nullopt;     ///< TAUMAX
  std::optional<double> slip_tolerance = std::nullopt;  ///< SLIP TOLERANCE
  std::optional<double> elastic_slip = std::nullopt;    ///< ELASTIC SLIP
};

/// *CONNECTOR FRICTION with what belongs to it.
struct Friction {
  std::string_view where;
  std::string_view name = {};                    ///< of a comment before it, or empty
  std::optional<Row> predefined = std::nullopt;  ///< its line; empty where there is none
  std::optional<int> component = std::nullopt;
  std::optional<std::variant<int, std::string>> contact_force = std::nullopt;
  bool constitutive = false;
  std::vector<int> independents = {};
  int fields = 0;
  std::vector<Row> rows = {};  ///< F_int, independents, accumulated slip, temperature, fields
  std::optional<double> stick_stiffness = std::nullopt;
  std::optional<Potential> potential = std::nullopt;
  std::optional<Coefficient> coefficient = std::nullopt;
};

/// *CONNECTOR ELASTICITY or *CONNECTOR DAMPING.
struct Spring {
  std::string_view where;
  std::optional<int> component = std::nullopt;  ///< all of them, coupled, where there is none
  bool nonlinear = false;
  int fields = 0;
  std::vector<Row> rows = {};
};

/// *CONNECTOR STOP.
struct Stop {
  std::string_view where;
  int component = 0;
  std::optional<double> lower = std::nullopt, upper = std::nullopt;
};

/// *CONNECTOR BEHAVIOR.
struct Behavior {
  std::string name;  ///< as people know it
  std::string_view where;
  bool linear_extrapolation = false;
  std::array<std::optional<double>, 6> reference{};  ///< *CONNECTOR CONSTITUTIVE REFERENCE, degrees
  std::vector<std::pair<std::string, std::vector<DerivedTerm>>> derived = {};  ///< by label
  std::vector<Friction> frictions = {};
  std::vector<Spring> elasticity = {};
  std::vector<Spring> damping = {};
  std::vector<Stop> stops = {};
  /// Sentences on parts of the behaviour without which the rest would be another joint.
  std::vector<std::string> not_taken = {};
};

/// Reads the behaviour that begins at a block; `at` becomes the index of the block behind it.
Behavior read_behavior(const KeywordDeck& deck, std::size_t& at);

/// Reads *FRICTION.
Coefficient read_coefficient(const KeywordDeck& deck, const Block& block);

}  // namespace slipbench::driver::abaqus
