// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/history_error.hpp"
#include "driver/case/case.hpp"
#include "driver/history/profile_cursor.hpp"
#include "law/definition/friction_definition.hpp"

namespace slipbench::driver::bench {

/// The changes of friction of the step that runs (docs/theory, section 9.2):
///   mu(t) = mu_start + A(t) (mu_end - mu_start),
/// with mu_start [1] the coefficient in force when the step began, a number, and mu_end the new law
/// at the current rate, force, temperature and fields. The force limit and a stick stiffness switch
/// when the step begins; an allowable elastic slip follows A where the change says so. All happens
/// in the first pass of a repeated step: the later ones have the new friction.
class FrictionChanges {
 public:
  /// Takes over the changes of a step that begins, and puts them in force at A = 0. Only the law,
  /// its blend, the force limit and the stick stiffness of `definitions` are touched.
  /// \param mu the coefficients in force, one a definition; in the first step of a case they do not
  ///        matter: mu_start is 0 there
  /// Errors: those of `ProfileCursor`.
  tl::expected<void, base::HistoryError> begin_step(
      const cases::Step& step, bool first, double total_time, std::span<const double> mu,
      std::vector<law::FrictionDefinition>& definitions);

  /// Tells whether something changes at all.
  bool active() const { return !running_.empty(); }

  /// The first corner of an amplitude after `t`; kNoBreakpoint if none.
  double next_breakpoint(double t) { return driver::history::next_breakpoint(amplitudes_, t); }

  /// Puts the friction of the time `t` in force. At the end of the step the new friction holds
  /// alone and nothing changes any more.
  void advance(double t, bool at_end, std::vector<law::FrictionDefinition>& definitions);

 private:
  struct Running {
    std::size_t definition = 0;
    double elastic_slip_start = 0.0;  ///< g_c at the start of the step, where it follows A
    double elastic_slip_end = 0.0;
    bool blends_elastic_slip = false;
  };
  std::vector<Running> running_;
  std::vector<history::ProfileCursor> amplitudes_;  ///< of running_, in its order
};

}  // namespace slipbench::driver::bench
