// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "reference/lambert_w.hpp"

/// One spring in series with one Coulomb slider whose internal contact force falls with the
/// accumulated slip: a press fit that wears. The accumulated slip is that of the present instant.
///
/// Formula   While slipping |f| = mu F_int(s). Linear: F_int = F_0 - c s, so on the first loading,
///           up to u = F_0/c, f = mu (F_0 - c u)/(1 - b), s = u - f/k, b = mu c/k. Exponential:
///           F_int = F_i + (F_z - F_i) e^(-s/l), so s = a + l W0(-(h/l) e^(-a/l)) with a = u - mu
///           F_i/k, h = mu (F_z - F_i)/k and f = k (u - s).
/// Symbols   u motion [L], f friction force [F], k stick stiffness [F/L], mu [1], s accumulated
///           slip [L], c wear rate [F/L], l wear length [L], F_0, F_z, F_i internal contact force
///           new and worn [F].
/// Sign      f has the sign of the slip it resists.
/// Source    derived in docs/theory.md; W0: Corless, Gonnet, Hare, Jeffrey and Knuth 1996.
/// Range     b < 1 and h < l, else the force snaps back at the onset of slip; F_int >= 0.
namespace slipbench::reference::wear {

struct Slip {
  double force;             ///< f [F]
  double accumulated_slip;  ///< s [L]
};

inline constexpr Slip kSnapBack{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};

struct LinearWear {
  double mu;               ///< [1]
  double stick_stiffness;  ///< k [F/L]
  double initial_force;    ///< F_0 [F]
  double wear_rate;        ///< c [F/L]
};

/// b = mu c/k [1]; b >= 1 is a snap-back, for which there is no quasi-static answer.
inline double snap_back_number(const LinearWear& wear) {
  return wear.mu * wear.wear_rate / wear.stick_stiffness;
}

/// First loading to the motion u >= 0 [L], linear wear; sticks up to u = mu F_0/k. NaN if b >= 1.
inline Slip monotone(const LinearWear& wear, double motion) {
  const double k = wear.stick_stiffness;
  if (snap_back_number(wear) >= 1.0) return kSnapBack;
  if (k * motion <= wear.mu * wear.initial_force) return {k * motion, 0.0};
  const double force =
      wear.mu * (wear.initial_force - wear.wear_rate * motion) / (1.0 - snap_back_number(wear));
  return {force, motion - force / k};
}

/// Magnitude of the force [F] at the n-th reversal after the one with magnitude F [F], full slip
/// between -A and A [L]: k A + (F - k A) ((1 + b)/(1 - b))^n. Holds while every half cycle slips
/// and wears, that is while the result is positive and below k A.
inline double cyclic_force(const LinearWear& wear, double amplitude, double first_force, int n) {
  // ((1 + b)/(1 - b))^n - 1, so that the large k A does not swallow digits
  const double growth = std::expm1(2.0 * n * std::atanh(snap_back_number(wear)));
  return first_force - (wear.stick_stiffness * amplitude - first_force) * growth;
}

/// Accumulated slip [L] that has worn the limit down to the force [F]: (F_0 - f/mu)/c.
inline double slip_at_force(const LinearWear& wear, double force) {
  return (wear.initial_force - force / wear.mu) / wear.wear_rate;
}

struct ExponentialWear {
  double mu;               ///< [1]
  double stick_stiffness;  ///< k [F/L]
  double final_force;      ///< F_i [F], fully worn
  double initial_force;    ///< F_z [F], new
  double wear_length;      ///< l [L]
};

/// h/l = mu (F_z - F_i)/(k l) [1], the steepest fall of the limit over the stick stiffness; from 1
/// on the force snaps back at the onset of slip.
inline double snap_back_number(const ExponentialWear& wear) {
  return wear.mu * (wear.initial_force - wear.final_force) /
         (wear.stick_stiffness * wear.wear_length);
}

/// First loading to the motion u >= 0 [L], exponential wear; sticks up to u = mu F_z/k. NaN if h >=
/// l.
inline Slip monotone(const ExponentialWear& wear, double motion) {
  const double k = wear.stick_stiffness;
  const double fall = snap_back_number(wear);
  if (fall >= 1.0) return kSnapBack;
  if (k * motion <= wear.mu * wear.initial_force) return {k * motion, 0.0};
  const double a = motion - wear.mu * wear.final_force / k;
  const double l = wear.wear_length;
  const double slip = a + l * lambert_w0(-fall * std::exp(-a / l));
  // k (u - s) is the same, but it cancels once u is large.
  const double worn = (wear.initial_force - wear.final_force) * std::exp(-slip / l);
  return {wear.mu * (wear.final_force + worn), slip};
}

/// Dissipation after the accumulated slip s [L]: mu [F_i s + (F_z - F_i) l (1 - e^(-s/l))] [F L].
inline double dissipation(const ExponentialWear& wear, double slip) {
  return wear.mu *
         (wear.final_force * slip - (wear.initial_force - wear.final_force) * wear.wear_length *
                                        std::expm1(-slip / wear.wear_length));
}

}  // namespace slipbench::reference::wear
