// SPDX-License-Identifier: Apache-2.0
// Increments of random cases at which exact integration once went wrong, or at which a change of it
// that no other test sees does. Both numbers of the difference test went the same wrong way; but
// their results depended on the tolerance, or on the number of increments.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>

#include "law/exact/continuous_update.hpp"
#include "tests/difference/any_case.hpp"
#include "tests/difference/law_increment.hpp"
#include "tests/difference/one_step.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::test;
using End = PlainIncrement<double>::End;

/// An increment of a seed, counted from 1.
struct Kept {
  std::uint64_t seed;
  std::size_t increment;
};

double between(double a, double b, double part) { return part < 1.0 ? a + part * (b - a) : b; }

End between(const End& a, const End& b, double part) {
  End end;
  for (std::size_t i = 0; i < 6; ++i) {
    end.position[i] = between(a.position[i], b.position[i], part);
    end.motion[i] = between(a.motion[i], b.motion[i], part);
    end.force[i] = between(a.force[i], b.force[i], part);
  }
  end.temperature = between(a.temperature, b.temperature, part);
  for (std::size_t i = 0; i < end.fields.size(); ++i) {
    end.fields[i] = between(a.fields[i], b.fields[i], part);
  }
  return end;
}

/// Work and end of an increment gone through in equal parts.
struct Result {
  law::FrictionState state;
  double slip = 0.0;  ///< of the increment [L]
  double work = 0.0;  ///< [F L]
  bool converged = true;
};

/// \param definition of the end of the increment
Result in_parts(const law::FrictionDefinition& definition, const PlainIncrement<double>& whole,
                const law::FrictionState& old, int count, double tolerance) {
  Result result{old};
  PlainIncrement<double> from = whole;
  from.duration = whole.duration / count;
  law::FrictionDefinition here = definition;
  auto* belt = std::get_if<law::Capstan>(&here.criterion);
  const double wrap_angle = belt != nullptr ? belt->wrap_angle : 0.0;
  for (int i = 1; i <= count; ++i) {
    const double begin = (i - 1.0) / count;
    const double end = static_cast<double>(i) / count;
    from.begin = between(whole.begin, whole.end, begin);
    from.end = between(whole.begin, whole.end, end);
    from.begin_blend = between(whole.begin_blend, definition.blend.weight, begin);
    from.begin_stick = between(whole.begin_stick, definition.stick.value, begin);
    from.begin_wrap_angle = between(whole.begin_wrap_angle, wrap_angle, begin);
    here.blend.weight = between(whole.begin_blend, definition.blend.weight, end);
    // A stiffness is that of the whole increment.
    if (here.stick.mode == law::StickStiffness::Mode::kElasticSlip) {
      here.stick.value = between(whole.begin_stick, definition.stick.value, end);
    }
    if (belt != nullptr) belt->wrap_angle = between(whole.begin_wrap_angle, wrap_angle, end);
    const auto update =
        law::continuous_update(here, law_segment(here, from), result.state, tolerance);
    result.state = update.state;
    result.slip += update.slip_increment;
    result.work += update.work;
    result.converged = result.converged && update.converged;
  }
  return result;
}

/// A definition, and one of its increments with the state before it.
struct KeptIncrement {
  law::FrictionDefinition definition;
  PlainIncrement<double> increment;
  law::FrictionState old;
};

KeptIncrement increment_of(const Kept& kept) {
  const AnyCase any = any_case(kept.seed, Way::kExact);
  std::span<const double> packed(any.definition);
  const auto definition = law::unpack(packed);
  REQUIRE(definition);
  KeptIncrement result{*definition, any.increments[kept.increment - 1], {}};
  for (std::size_t i = 0; i + 1 < kept.increment; ++i) {
    result.old = in_parts(*definition, any.increments[i], result.old, 1, kExactness).state;
  }
  return result;
}

TEST_CASE("exact results do not depend on the tolerance beyond it") {
  // A coefficient on its floor at rest, or that comes to it, which was taken for a limit that is
  // gone; and a slip that ends slowly, which was taken to have ended.
  for (const Kept& kept :
       {Kept{30270401003985, 2}, Kept{30270401005265, 12}, Kept{20261127002624, 11}}) {
    CAPTURE(kept.seed, kept.increment);
    const auto [definition, increment, old] = increment_of(kept);
    const Result fine = in_parts(definition, increment, old, 1, 1e-11);
    CHECK(fine.converged);
    for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-10}) {
      const Result coarse = in_parts(definition, increment, old, 1, tolerance);
      CHECK(coarse.converged);
      // Some dozens of pieces keep it each.
      CHECK(coarse.slip == Approx(fine.slip).epsilon(std::max(30.0 * tolerance, 1e-8)));
    }
  }
}

TEST_CASE("exact results do not depend on the number of increments") {
  // With events that are located in many pieces; a slip that ends slowly; a potential with terms
  // that pull or do not. A coefficient that sees the rate of the slip under a constant stiffness is
  // held to kViscousExactness, in some pieces each.
  constexpr double kViscous = 3.0 * kViscousExactness;
  for (const auto& [kept, tolerance] :
       {std::pair(Kept{20261127001675, 1}, kViscous), std::pair(Kept{20261127002624, 11}, kViscous),
        std::pair(Kept{20261127000295, 6}, 1e-8)}) {
    CAPTURE(kept.seed, kept.increment);
    const auto [definition, increment, old] = increment_of(kept);
    const Result whole = in_parts(definition, increment, old, 1, kExactness);
    for (const int count : {2, 3, 7}) {
      CAPTURE(count);
      const Result parts = in_parts(definition, increment, old, count, kExactness);
      CHECK(parts.converged);
      CHECK(parts.slip == Approx(whole.slip).epsilon(tolerance));
      CHECK(parts.work == Approx(whole.work).epsilon(tolerance));
    }
  }
}

TEST_CASE("an increment that cannot be followed to its end is told not to be") {
  const auto [definition, increment, old] = increment_of({30290101001198, 4});
  CHECK_FALSE(in_parts(definition, increment, old, 1, kExactness).converged);
}

}  // namespace
