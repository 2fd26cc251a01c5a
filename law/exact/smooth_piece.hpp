// SPDX-License-Identifier: Apache-2.0
// Pieces of a segment whose limit is one smooth formula: between the corners of everything that
// decides on a formula (theory 11.9).
#pragma once

#include <array>
#include <limits>

#include "law/base/first_negative.hpp"
#include "law/exact/path_segment.hpp"

namespace slipbench::law {

/// A point of a segment, with what the limit there depends on besides tau.
struct LimitPoint {
  double tau = 0.0;
  double accumulated_slip = 0.0;  ///< total [L]
  double slip_rate = 0.0;         ///< [L/T], where the coefficient sees that of the slip
  double sense = 1.0;             ///< side of a belt
};

/// The smooth piece of the limit around a point: every quantity that decides on a formula, with the
/// interval between its corners. Quantities are the arguments of all tables, F_C + F_int, the force
/// against its cap, coefficient and F_int before they are held at their floor, and the forces whose
/// magnitude or sign the contact force takes. Nothing is assumed of how they move.
class SmoothPiece {
 public:
  /// Most quantities: enough for some twenty independents, all forces and four Macauley terms of
  /// six weights. If a contact force has still more weights, the rest is not looked at.
  static constexpr std::size_t kMost = 64;
  using Values = std::array<double, kMost>;

  /// \param points of the same definition and segment; kept, as the others are
  /// \param begin_slip accumulated slip at the begin [L]
  /// \param most_slip no slip of the segment is above it [L]
  /// \param contact_size |F_C| and F_int at their largest, added [F]
  SmoothPiece(const FrictionDefinition& definition, const PathSegment& segment,
              SegmentPoints& points, double begin_slip, double most_slip,
              double contact_size) noexcept;

  /// The quantities at a point.
  Values values(const LimitPoint& point) noexcept;

  /// Goes to the piece that holds `here`; what stands on a corner goes where it is `ahead`.
  /// \param rate_slack what follows the rate of the slip stands on a corner that it is so near to,
  /// as a part of its size
  void enter(const Values& here, const Values& ahead, double rate_slack = 0.0) noexcept;

  /// Tells whether no value is outside of the piece, by more than its rounding or `rate_slack`.
  bool keeps(const Values& values, double rate_slack) const noexcept;

  /// Distance to the nearest corner as a part of the size of its quantity, at most 1; negative
  /// outside of the piece, by more than rounding.
  double reserve(const Values& values) const noexcept;

  /// Returns where a way [from, to] from inside of the piece leaves it: the place just behind; `to`
  /// if it does not. The way is looked at in `samples` parts, and where a quantity turns around
  /// near a corner between them.
  /// \param point t -> LimitPoint
  template <class Way>
  double end_of(Way&& point, double from, double to, int samples) noexcept;

 private:
  enum class Kind {
    kArgument,
    kForce,
    kWeight,
    kPin,
    kContact,
    kUncapped,
    kCoefficient,
    kInternal
  };
  struct Quantity {
    Kind kind = Kind::kArgument;
    Independent independent;  ///< of kArgument; of kForce and kWeight its index
    double size = 0.0;        ///< what its rounding is measured by
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };

  template <class Visit>
  void for_each_table(Visit visit) const noexcept;
  void add(Kind kind, Independent independent = {}) noexcept;
  /// Calls visit(corner) for the corners of a quantity, or enough of them: the two on either side.
  template <class Visit>
  void for_each_corner(const Quantity& quantity, double value, Visit visit) const noexcept;
  double value(const Quantity& quantity, const LimitPoint& point, const Limit& limit) noexcept;
  double reserve(std::size_t i, double value) const noexcept;
  /// Distance from a corner within which a value stands on it.
  static double slack(const Quantity& quantity, double corner, double rate_slack) noexcept;
  bool may_turn_beyond(std::size_t i, double before, double value, double after) const noexcept;

  const FrictionDefinition& definition_;
  const PathSegment& segment_;
  SegmentPoints& points_;
  std::array<Quantity, kMost> quantities_{};
  std::size_t count_ = 0;
};

/// Place of the minimum of f in [low, high], which has one: golden section, as far as f is not
/// below `enough`.
template <class Function>
double lowest(Function&& f, double low, double high, double enough) {
  constexpr double kGolden = 0.61803398874989484820;
  double a = high - kGolden * (high - low);
  double b = low + kGolden * (high - low);
  double fa = f(a);
  double fb = f(b);
  for (int i = 0; i < 60 && fa >= enough && fb >= enough; ++i) {
    if (fa < fb) {
      high = b;
      b = a;
      fb = fa;
      a = high - kGolden * (high - low);
      fa = f(a);
    } else {
      low = a;
      a = b;
      fa = fb;
      b = low + kGolden * (high - low);
      fb = f(b);
    }
  }
  return fa < fb ? a : b;
}

/// Place at which f dips below `enough` on the way from `from` to `to`, looked for in so many parts
/// of it; `to` if there is none.
template <class Function>
double first_dip(Function&& f, double from, double to, int parts, double enough) {
  const double part = (to - from) / parts;
  double before = f(from + 0.5 * part);
  double here = f(from + part);
  for (int i = 2; i <= parts; ++i) {
    const double after = f(from + i * part);
    if (here < before && here <= after) {
      const double place = lowest(f, from + (i - 2) * part, from + i * part, enough);
      if (f(place) < enough) return place;
    }
    before = here;
    here = after;
  }
  return to;
}

template <class Way>
double SmoothPiece::end_of(Way&& point, double from, double to, int samples) noexcept {
  if (!(to > from)) return to;
  // Between a place inside and one outside: quantity by quantity, whichever is out there.
  const auto leave = [&](double low, double high) {
    for (std::size_t n = 0; n <= count_; ++n) {
      const Values there = values(point(high));
      std::size_t out = 0;
      for (std::size_t i = 1; i < count_; ++i) {
        if (reserve(i, there[i]) < reserve(out, there[out])) out = i;
      }
      const double place =
          first_negative([&](double t) { return reserve(out, values(point(t))[out]); }, low, high);
      if (!(place < high)) break;
      high = place;
    }
    return high;
  };
  double before = from;
  double t = from;
  Values at_before{};
  Values at_t = values(point(t));
  for (int k = 1; k <= samples; ++k) {
    const double next = k == samples ? to : from + (to - from) * k / samples;
    const Values at_next = values(point(next));
    if (reserve(at_next) < 0.0) return leave(t, next);
    for (std::size_t i = 0; k > 1 && i < count_; ++i) {
      if (!may_turn_beyond(i, at_before[i], at_t[i], at_next[i])) continue;
      const double turn =
          lowest([&](double x) { return reserve(i, values(point(x))[i]); }, before, next, 0.0);
      if (reserve(values(point(turn))) < 0.0) return leave(before, turn);
    }
    before = t;
    t = next;
    at_before = at_t;
    at_t = at_next;
  }
  return to;
}

}  // namespace slipbench::law
