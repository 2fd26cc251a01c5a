// SPDX-License-Identifier: Apache-2.0
// Exact integration over increments of any size and unit, random ones and those that once went
// wrong: the results depend neither on the tolerance nor on the number of increments, in which both
// numbers of the difference test may go the same wrong way.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

#include "law/definition/motion.hpp"
#include "law/exact/continuous_update.hpp"
#include "tests/difference/any_case.hpp"
#include "tests/difference/law_increment.hpp"
#include "tests/difference/one_step.hpp"
#include "tests/support/dice.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::test;
using End = PlainIncrement<double>::End;

/// An increment of a seed, counted from 1.
struct Kept {
  std::uint64_t seed;
  std::size_t increment;
};

End between(const End& a, const End& b, double part) {
  End end;
  for (std::size_t i = 0; i < 6; ++i) {
    end.position[i] = std::lerp(a.position[i], b.position[i], part);
    end.motion[i] = std::lerp(a.motion[i], b.motion[i], part);
    end.force[i] = std::lerp(a.force[i], b.force[i], part);
  }
  end.temperature = std::lerp(a.temperature, b.temperature, part);
  for (std::size_t i = 0; i < end.fields.size(); ++i) {
    end.fields[i] = std::lerp(a.fields[i], b.fields[i], part);
  }
  return end;
}

/// Work and end of an increment gone through in parts.
struct Result {
  law::FrictionState state;
  double slip = 0.0;  ///< of the increment [L]
  double work = 0.0;  ///< [F L]
  bool converged = true;
};

/// \param definition of the end of the increment
/// \param ends of the parts, in [0, 1]
Result in_parts(const law::FrictionDefinition& definition, const PlainIncrement<double>& whole,
                const law::FrictionState& old, const std::vector<double>& ends = {1.0},
                double tolerance = kExactness) {
  Result result{old};
  PlainIncrement<double> from = whole;
  law::FrictionDefinition here = definition;
  auto* belt = std::get_if<law::Capstan>(&here.criterion);
  const double wrap_angle = belt != nullptr ? belt->wrap_angle : 0.0;
  double begin = 0.0;
  for (const double end : ends) {
    from.duration = whole.duration * (end - begin);
    from.begin = between(whole.begin, whole.end, begin);
    from.end = between(whole.begin, whole.end, end);
    from.begin_blend = std::lerp(whole.begin_blend, definition.blend.weight, begin);
    from.begin_stick = std::lerp(whole.begin_stick, definition.stick.value, begin);
    from.begin_wrap_angle = std::lerp(whole.begin_wrap_angle, wrap_angle, begin);
    here.blend.weight = std::lerp(whole.begin_blend, definition.blend.weight, end);
    // A stiffness is that of the whole increment.
    if (here.stick.mode == law::StickStiffness::Mode::kElasticSlip) {
      here.stick.value = std::lerp(whole.begin_stick, definition.stick.value, end);
    }
    if (belt != nullptr) belt->wrap_angle = std::lerp(whole.begin_wrap_angle, wrap_angle, end);
    const auto update =
        law::continuous_update(here, law_segment(here, from), result.state, tolerance);
    result.state = update.state;
    result.slip += update.slip_increment;
    result.work += update.work;
    result.converged = result.converged && update.converged;
    begin = end;
  }
  return result;
}

std::vector<double> equal_parts(int count) {
  std::vector<double> ends;
  for (int i = 1; i <= count; ++i) ends.push_back(static_cast<double>(i) / count);
  return ends;
}

/// A definition, and one of its increments with the state before it.
struct KeptIncrement {
  law::FrictionDefinition definition;
  PlainIncrement<double> increment;
  law::FrictionState old;
};

/// Tells whether seeds draw what they drew when they were kept.
bool draws_what_was_kept() {
#ifdef __clang__
  return false;  // of a call with two draws it makes the other one first (Dice)
#else
  return seed_of_the_night() == 0;
#endif
}

KeptIncrement increment_of(const Kept& kept) {
  const AnyCase any = any_case(kept.seed, Way::kExact);
  std::span<const double> packed(any.definition);
  const auto definition = law::unpack(packed);
  REQUIRE(definition);
  KeptIncrement result{*definition, any.increments[kept.increment - 1], {}};
  for (std::size_t i = 0; i + 1 < kept.increment; ++i) {
    result.old = in_parts(*definition, any.increments[i], result.old).state;
  }
  return result;
}

TEST_CASE("exact results do not depend on the tolerance beyond it") {
  if (!draws_what_was_kept()) return;  // other cases are drawn
  // A coefficient on its floor at rest, or that comes to it, which was taken for a limit that is
  // gone; and a slip that ends slowly, which was taken to have ended.
  for (const Kept& kept :
       {Kept{30270401003985, 2}, Kept{30270401005265, 12}, Kept{20261127002624, 11}}) {
    CAPTURE(kept.seed, kept.increment);
    const auto [definition, increment, old] = increment_of(kept);
    const Result fine = in_parts(definition, increment, old, {1.0}, 1e-11);
    CHECK(fine.converged);
    for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-10}) {
      const Result coarse = in_parts(definition, increment, old, {1.0}, tolerance);
      CHECK(coarse.converged);
      // Some dozens of pieces keep it each.
      CHECK(coarse.slip == Approx(fine.slip).epsilon(std::max(30.0 * tolerance, 1e-8)));
    }
  }
}

TEST_CASE("exact results do not depend on the number of increments") {
  if (!draws_what_was_kept()) return;  // other cases are drawn
  // With events that are located in many pieces; a slip that ends slowly; a potential with terms
  // that pull or do not. A coefficient that sees the rate of the slip under a constant stiffness is
  // held to kViscousExactness, in some pieces each.
  constexpr double kViscous = 3.0 * kViscousExactness;
  for (const auto& [kept, tolerance] :
       {std::pair(Kept{20261127001675, 1}, kViscous), std::pair(Kept{20261127002624, 11}, kViscous),
        std::pair(Kept{20261127000295, 6}, 1e-8)}) {
    CAPTURE(kept.seed, kept.increment);
    const auto [definition, increment, old] = increment_of(kept);
    const Result whole = in_parts(definition, increment, old);
    for (const int count : {2, 3, 7}) {
      CAPTURE(count);
      const Result parts = in_parts(definition, increment, old, equal_parts(count));
      CHECK(parts.converged);
      CHECK(parts.slip == Approx(whole.slip).epsilon(tolerance));
      CHECK(parts.work == Approx(whole.work).epsilon(tolerance));
    }
  }
}

/// The largest difference of two ends of an increment, as a part of its limit and of its motion and
/// elastic slip.
double difference(const law::FrictionDefinition& definition, const PlainIncrement<double>& from,
                  const law::FrictionState& old, const Result& a, const Result& b) {
  double force =
      law::continuous_update(definition, law_segment(definition, from), old, kExactness).limit;
  double apart = 0.0;
  for (std::size_t i = 0; i < law::kComponents; ++i) {
    force = std::max(force, std::abs(old.force[i]));
    apart = std::max(apart, std::abs(a.state.force[i] - b.state.force[i]));
  }
  const bool fixed = definition.stick.mode == law::StickStiffness::Mode::kStiffness;
  const double elastic =
      fixed ? force / definition.stick.value : std::max(definition.stick.value, from.begin_stick);
  double way = elastic;
  for (const double u : law::motion_in(definition.slip, law_increment(from))) way += std::abs(u);
  const double slip = way > 0.0 ? std::abs(a.slip - b.slip) / way : 0.0;
  if (!(force * way > 0.0)) return slip;
  const double work = std::abs(a.work) + std::abs(b.work) + force * way;
  return std::max({apart / force, slip, std::abs(a.work - b.work) / work});
}

TEST_CASE("random increments of any size end alike as a whole, and in long and short parts") {
  // As little moves in an increment of a fine history: what is slow there is next to rounding.
  constexpr double kShort = 1e-6;
  int increments = 0;
  int apart = 0;
  std::ostringstream which;
  for (std::uint64_t seed = 20261127000000; increments < 1000; ++seed) {
    const AnyCase any = any_case(seed, Way::kExact);
    std::span<const double> packed(any.definition);
    const auto definition = law::unpack(packed);
    REQUIRE(definition);
    if (definition->formulation || law::no_continuous_solution(*definition)) continue;
    law::FrictionState old;
    for (std::size_t i = 0; i < any.increments.size(); ++i) {
      const PlainIncrement<double>& increment = any.increments[i];
      const Result whole = in_parts(*definition, increment, old);
      const Result parts =
          in_parts(*definition, increment, old, {1.0 / 3.0, 1.0 / 3.0 + kShort, 2.0 / 3.0, 1.0});
      ++increments;
      const bool converged = whole.converged && parts.converged;
      const double by = difference(*definition, increment, old, whole, parts);
      if (by > 1e-5 || !converged) {
        ++apart;
        which << "\nseed " << seed << ", increment " << i + 1 << ": " << by << ' ' << converged;
        break;  // what follows begins in a state that is not known
      }
      old = whole.state;
    }
  }
  // A limit that drops at the begin of an increment 1e14 times as long as its viscosity needs, and
  // corners that continuous_update does not meet, and what it gives up: 6 in 30,000.
  INFO(which.str());
  CHECK(apart <= 1);
}

TEST_CASE("an increment that cannot be followed to its end is told not to be, within seconds") {
  if (!draws_what_was_kept()) return;  // other cases are drawn
  // The second came on by 1e-8 of itself at a time, without end.
  for (const Kept& kept : {Kept{30290101001198, 4}, Kept{20261136437237, 6}}) {
    CAPTURE(kept.seed, kept.increment);
    const auto [definition, increment, old] = increment_of(kept);
    CHECK_FALSE(in_parts(definition, increment, old).converged);
  }
}

}  // namespace
