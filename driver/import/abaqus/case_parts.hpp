// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/import/abaqus/case_writer.hpp"
#include "driver/import/abaqus/keyword_deck.hpp"
#include "driver/import/abaqus/model.hpp"
#include "driver/import/abaqus/profile_text.hpp"
#include "law/connection/connection_type.hpp"

namespace slipbench::driver::abaqus {

/// Reason why a connector is not taken over; thrown by a part of its case.
struct PassedOver {
  std::string reason;
};

/// Text as YAML takes it, in quotes.
std::string quoted(const std::string& text);
/// Returns a name that YAML and expressions take: "CONTACT-FORCE" is contact_force.
std::string name_of(const std::string& label);
/// Joins texts with ", ".
std::string join(const std::vector<std::string>& parts);
/// CP1 or CU1, of a component from 1 on.
std::string motion_column(int component, bool constitutive);

/// Parts of a case that is made of a connector: each is a text, and what it asks for is collected.
/// All throw PassedOver where the bench cannot take something over.
class CaseParts {
 public:
  CaseParts(const KeywordDeck& deck, const Model& model, const Connector& connector,
            const CaseOptions& options)
      : deck_(deck), model_(model), connector_(connector), options_(options) {}

  WrittenCase write();

 private:
  // case_writer.cpp
  void find_connection();
  /// Reads what was written, with numbers in place of what is asked for.
  cases::Case resolved(const std::string& text) const;
  static law::ComponentSet used_forces(const cases::Case& problem);
  std::string text();
  std::string connector_text();
  double distance() const;
  double position(int component) const;

  // case_parts.cpp
  /// Names a parameter without a value; returns the expression.
  std::string ask(const std::string& name, const std::string& why);
  /// A table of rows whose leading items are dependents; nothing but these where it depends on
  /// nothing.
  std::string table(const std::vector<std::string>& dependents,
                    const std::vector<std::string>& independents, const std::vector<Row>& rows,
                    const std::string& extrapolate);
  static std::vector<std::string> ambient_columns(std::vector<std::string> first, int fields);
  std::string line_of(std::string_view where) const;
  [[noreturn]] void pass(const std::string& reason) const;

  // friction_text.cpp
  std::string derived_text();
  std::string coefficient_text(const std::optional<Coefficient>& coefficient);
  std::string stick_text(const std::optional<double>& stiffness,
                         const std::optional<Coefficient>& coefficient);
  std::string predefined_text(const Row& row);
  std::string potential_text(const Potential& potential);
  std::string friction_text();
  std::string friction_name(std::size_t index) const;

  // spring_text.cpp
  /// Springs or dampers.
  std::string spring_text(const Spring& spring, bool damper);
  /// 21 constants of a symmetric matrix, column by column above the diagonal.
  std::string coupled_text(const Spring& spring);
  std::string springs_text();

  // history_text.cpp
  bool is_mine(const std::string& target) const;
  std::string history_text();
  std::string step_text(const Step& step, bool first, bool last, double begin);
  /// The last one of the lines that state the same quantity of a component, which holds, then what
  /// steps before have set going and the step does not state again.
  std::vector<Drive> in_effect(const Step& step, const std::vector<Drive>& stated,
                               const std::vector<Drive>& going);
  /// Notes that a drive goes on behind its step: a velocity, or an amplitude over the total time.
  void go_on(const Drive& drive, const DriveProfile& profile, std::vector<Drive>& going) const;
  /// Ends motions and loads that OP=NEW takes away and the step does not state again.
  void let_go(const Step& step, const std::vector<Drive>& drives, std::vector<std::string>& force);
  void take_nodes(const Step& step, double begin, std::vector<std::string>& force,
                  std::vector<std::string>& ambient, std::vector<std::string>& fields);
  /// The profile of a column of the recorded history, of the first name that it has; or nothing.
  std::optional<std::string> recorded(const std::vector<std::string>& names, double begin) const;
  std::string changes_text(const Step& step, double begin, long increments);
  std::string blend_text(const Step& step, const FrictionChange& change, double begin);
  /// The stick of a friction that changes; empty: as it was.
  std::string changed_stick(const Friction& friction, const FrictionChange& change);

  const KeywordDeck& deck_;
  const Model& model_;
  const Connector& connector_;
  const CaseOptions& options_;
  law::Connection connection_;
  bool belt_ = false;
  law::ComponentSet forces_;  ///< constraint forces that the case has
  std::vector<std::string> asked_, asked_why_, notes_;
  std::optional<bool> changes_stick_;  ///< some change of the deck states an elastic slip
  std::set<std::string> ambient_;      ///< temperature and fields that tables see
  std::array<double, law::kComponents> initial_{}, values_{}, loads_{};
  law::ComponentSet driven_;
  std::array<bool, law::kComponents> moved_{},
      loaded_{};                                  ///< by a motion, by a load that is in effect
  std::vector<Drive> going_, going_of_nodes_;     ///< what changes on without being stated again
  std::set<std::string> of_nodes_;                ///< forces of nodes in effect
  std::map<std::string, double> ambient_values_;  ///< at the start of a step
};

}  // namespace slipbench::driver::abaqus
