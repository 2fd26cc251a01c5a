// SPDX-License-Identifier: Apache-2.0
// Connectors of an Abaqus deck, what they are made of, and what its steps do with them.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/import/abaqus/behavior.hpp"
#include "driver/import/abaqus/keyword_deck.hpp"

namespace slipbench::driver::abaqus {

/// *AMPLITUDE.
struct Amplitude {
  enum class Kind { kTabular, kSmoothStep, kPeriodic, kEquallySpaced, kDecay, kOther };
  std::string label;
  std::string_view where;
  Kind kind = Kind::kTabular;
  bool total_time = false;
  bool absolute = false;             ///< values are not factors of the magnitude
  double interval = 0.0;             ///< FIXED INTERVAL of equally spaced values
  double begin = 0.0;                ///< BEGIN of these
  bool smoothed = false;             ///< SMOOTH rounds the corners of its polyline
  std::vector<double> numbers = {};  ///< all of the data lines
};

/// A line of *CONNECTOR MOTION or *CONNECTOR LOAD.
struct Drive {
  std::string_view where;
  std::string target = {};  ///< label of a set or an element
  int component = 0;
  double magnitude = 0.0;
  std::string amplitude;  ///< label, or empty
  std::string type = {};  ///< DISPLACEMENT, VELOCITY or ACCELERATION of a motion
  bool is_load = false;
  std::string quantity = {};  ///< "temperature", "field1" of a node's, or empty
  bool fixed = false;         ///< held where it is
  bool user = false;          ///< a subroutine gives its values
};

/// *CHANGE FRICTION.
struct FrictionChange {
  std::string_view where;
  std::string target;
  std::string amplitude;  ///< label, or empty
  bool reset = false;
  std::optional<Coefficient> coefficient = std::nullopt;
};

/// *STEP with time.
struct Step {
  std::string name;
  std::string_view where;
  double period = 1.0;
  double increment = 0.0;  ///< the first one; 0: the deck does not say
  bool is_static = true;
  std::optional<bool> at_once = std::nullopt;  ///< AMPLITUDE=STEP, or RAMP
  bool new_motions = false;                    ///< OP=NEW: those of the step before are gone
  bool new_loads = false;
  bool new_of_nodes = false;  ///< the same of forces of nodes
  std::vector<Drive> drives = {};
  std::vector<FrictionChange> changes = {};
  std::vector<Drive> of_nodes = {};  ///< forces, temperatures and fields of nodes
};

using Point = std::array<double, 3>;

/// Connector element with its section.
struct Connector {
  std::string name;                     ///< "7", or "arm-1.7" of an instance
  std::string set;                      ///< of its section, as people know it
  std::string_view where;               ///< its element
  std::set<std::string> labels = {};    ///< by which steps may name it: its number and sets
  std::vector<std::string> types = {};  ///< one, or two basic ones
  std::string_view types_where;
  std::optional<double> number_of_type = std::nullopt;  ///< third line of the section: wrap angle
  const Behavior* behavior = nullptr;                   ///< null where it has none
  /// Node b seen from node a along the axes of a, where the deck tells; and the distance.
  std::optional<Point> position = std::nullopt;
  bool turned = false;  ///< the axes of b are not those of a
  bool plane = false;   ///< CONN2D2
  /// Numbers of its nodes, where it is the only element of the deck and node a is held: loads of
  /// node b are its constraint forces then.
  std::optional<std::array<std::string, 2>> alone = std::nullopt;
};

/// Connectors, steps and amplitudes of a deck.
struct Model {
  std::vector<Behavior> behaviors;
  std::map<std::string, Amplitude> amplitudes;  ///< by their labels
  std::vector<Step> steps;
  std::vector<Connector> connectors;  ///< in the order of the deck
  std::vector<std::string> notes;     ///< sentences on what is passed over
  std::size_t passed_over = 0;        ///< keywords that are not read
};

/// Reads the connectors of a deck; what is wrong is reported to it.
Model read_model(const KeywordDeck& deck);

const Amplitude* find_amplitude(const Model& model, const std::string& label);

}  // namespace slipbench::driver::abaqus
