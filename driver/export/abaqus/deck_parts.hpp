// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/export/loss.hpp"
#include "driver/export/number_writer.hpp"
#include "driver/export/run_range.hpp"
#include "driver/read/keys/case_text.hpp"

namespace slipbench::driver::exports {

/// Items of a data line, or of several where they are more than eight.
std::string data_lines(const std::vector<std::string>& items);

/// Parts of an Abaqus deck. All throw NotExported where Abaqus has not what the case has.
class DeckParts {
 public:
  DeckParts(const cases::Case& problem, const read::CaseText& written, const ExportOptions& options)
      : problem_(problem), written_(written), numbers_(20, options.digits), whole_(20, 0) {}

  /// Refuses what no deck can hold, and notes what is approximated or dropped.
  void judge();
  /// Nodes, element, section.
  std::string model();
  /// *CONNECTOR BEHAVIOR with all that belongs to it.
  std::string behavior();
  /// *AMPLITUDE and *STEP.
  std::string history();

  std::vector<Loss>& losses() { return losses_; }
  /// Numbers that are not what they were, and the largest relative change of one.
  std::size_t rounded() const { return numbers_.rounded() + whole_.rounded(); }
  double worst() const { return std::max(numbers_.worst(), whole_.worst()); }

 private:
  bool is_contact() const { return problem_.connection.info.name == "CONTACT"; }
  /// Returns whether a coefficient of the case depends on the slip rate.
  bool sees_slip_rate() const;
  void judge_contact();
  /// Points in place of a law that Abaqus has not.
  std::string tabulated(const law::FrictionLaw& law);
  [[noreturn]] static void refuse(const std::string& reason) { throw NotExported{reason}; }
  void note(Loss::Kind kind, std::string text) { losses_.push_back({kind, std::move(text)}); }
  /// Data lines of a table in the order of a deck's columns; empty items for those it does not see.
  std::string rows(const law::TableFunction& table, const std::vector<law::Independent>& columns);
  static int fields_of(const law::TableFunction& table);
  static std::string dependencies(int fields);
  void take_extrapolation(const law::TableFunction& table);

  std::string friction(std::size_t entry);
  std::string predefined(const cases::CaseDefinition& definition);
  std::string user_defined(const cases::CaseDefinition& definition);
  std::string derived(const std::string& name, const law::DerivedComponent& terms);
  /// A derived component as the case states it.
  law::DerivedComponent stated_component(const std::string& name) const;
  std::string potential(const cases::CaseDefinition& definition);
  std::string coefficient(const law::FrictionLaw& law, double force_limit,
                          const law::StickStiffness& stick);
  std::string springs();

  std::string supports() const;
  /// The step of a measured history.
  std::string measured();
  std::string step(std::size_t index, int pass);
  std::string drive(const cases::Drive& drive, std::size_t step_index, int pass);
  std::string changes(const cases::Step& step);
  std::string amplitude(const std::string& data, const std::string& parameters);
  std::string triangle(const history::Wave& wave, double duration, double initial);
  std::string sampled(int quantity, std::size_t step_index, int pass);

  const cases::Case& problem_;
  const read::CaseText& written_;
  NumberWriter numbers_;  ///< of the behaviour
  NumberWriter whole_;    ///< of the history, which is never rounded for people
  std::vector<Loss> losses_;
  std::optional<law::Extrapolation> extrapolation_;
  std::optional<RunRange> range_;  ///< once it is needed: it takes a run
  std::string amplitudes_;
  int amplitude_count_ = 0;
  /// Of the run, where a profile has to be sampled: [step, pass] in turn, rows of time and values.
  struct Sample {
    int step = 0;
    int pass = 0;
    double time = 0.0;
    std::vector<double> quantities;
  };
  /// Rows of a pass of a step.
  std::span<const Sample> samples_of(std::size_t step_index, int pass) const;
  std::vector<Sample> samples_;
  std::vector<double> values_;  ///< of the quantities, at the start of a step
  double start_ = 0.0;          ///< of the history
};

}  // namespace slipbench::driver::exports
