// SPDX-License-Identifier: Apache-2.0
// The law in double against its own sources in long double (one_step.hpp), increment by increment:
// both begin from the state that double has come to.
//
// Bound. What double gives is the exact result of numbers that are off by some roundings, kOff, and
// a few roundings more, kRounding, of the numbers that it is made of (PlainResult::size). The
// second alone holds nearly everywhere. Where it does not, the first dominates: weights against
// each other, a root that is nearly double, a motion along the limit. How much that is, long
// double tells, by the same increment with every number off. A decision that lies on rounding (a
// load on its limit, a corner of a table) shows there as results of both sides; where none of 64
// increments that are off comes near to double, double is at fault. By less than kOff, too, since a
// rounding counts as none up to 8.
// Exact integration adds its tolerance, which it keeps in each of the pieces that it goes by, as
// often as kPieces, measured by the same sizes: that dominates there.
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/difference/any_case.hpp"
#include "tests/difference/one_step.hpp"

namespace {

using namespace slipbench::test;
using Long = long double;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRounding = 64.0;
constexpr double kOff = 16.0;
constexpr double kPieces = 10.0;
constexpr std::uint64_t kSamples = 64;
/// Times as much as these show, some 40 numbers off can do: their signs hardly ever all agree, the
/// best of 64 has a surplus of some 16 of 40.
constexpr double kUnseen = 4.0;
/// Numbers that are 0: double has no squares of theirs.
constexpr double kNothing = 1e-100;
/// Difference as a part of its size that no growth of rounding makes.
constexpr double kJump = 1e-6;

/// Seeds that have found something, in the law or in what this test takes for an error.
constexpr std::array<std::uint64_t, 36> kFound{
    1233, 1692, 1906,  // work: the fraction at which a potential's limit is met
    1394, 1529, 2419, 2841, 2953, 4648,
    4840,                    // forces on a potential with shifts, or several terms a part
    1274, 1399, 2916, 4121,  // a cancelling limit, coefficient of 1e-400, onset, work of 1e-103
    20261126006602,          // a coefficient near its minimum of 0
    20261128041972,          // an internal contact force that has just worn away
    20261126008510, 20261226001905, 20261226026588,  // where a limit is met after 1e30 elastic
                                                     // slips, or from far outside
    20261126014213, 20261126023302, 20261126033775,  // a force gone after 1e20 elastic slips
    20261126010038, 20261126040574, 20261226026216,  // a thin ellipse
    20261126001160, 20261126007445, 20261126020662, 20261226017527, 20270601007112, 20270601056337,
    20270601076517, 20270801028134, 20270801055741, 20270901033084};  // the bound's own
/// The fourth: a rest of next to no length, told as a change of regime; the fifth and sixth: a
/// contribution of several terms that do not all pull; the seventh: a walk over knots without an
/// end; the eighth and the last: the steepest wear at the end of a piece and inside; the ninth: a
/// turn within a long piece, taken for rounding.
constexpr std::array<std::uint64_t, 10> kFoundExactly{34,
                                                      39,
                                                      73,
                                                      20261226004250,
                                                      20270226007850,
                                                      20270301011750,
                                                      20261126080800,
                                                      20270901008650,
                                                      20261127045600,
                                                      20261127063500};

/// Makes numbers long, and off. Equal ones stay equal, as those of a table that belong together
/// have to, and counts stay as they are.
class Off {
 public:
  /// \param sample 0: nothing is off
  explicit Off(std::uint64_t sample) : sample_(sample) {}

  Long operator()(double x) const {
    const bool counts = x == std::floor(x) && std::abs(x) < 65536.0;
    return counts || !std::isfinite(x) ? x : x * factor(std::bit_cast<std::uint64_t>(x));
  }
  template <std::size_t N>
  std::array<Long, N> operator()(const std::array<double, N>& all) const {
    std::array<Long, N> made;
    std::transform(all.begin(), all.end(), made.begin(), *this);
    return made;
  }
  std::vector<Long> operator()(const std::vector<double>& all) const {
    std::vector<Long> made(all.size());
    std::transform(all.begin(), all.end(), made.begin(), *this);
    return made;
  }
  PlainIncrement<Long>::End operator()(const PlainIncrement<double>::End& end) const {
    return {(*this)(end.position), (*this)(end.motion), (*this)(end.force),
            (*this)(end.temperature), (*this)(end.fields)};
  }
  PlainIncrement<Long> operator()(const PlainIncrement<double>& from) const {
    PlainIncrement<Long> made{(*this)(from.duration),
                              (*this)(from.begin),
                              (*this)(from.end),
                              (*this)(from.begin_blend),
                              (*this)(from.begin_stick),
                              (*this)(from.begin_wrap_angle),
                              {(*this)(from.old.elastic_slip), (*this)(from.old.force),
                               (*this)(from.old.accumulated_slip), from.old.regime}};
    // Both positions are given, and their difference is rounded once: it is what is off.
    for (std::size_t c = 0; c < 6; ++c) {
      const Long begin = from.begin.position[c];
      made.begin.position[c] = begin;
      made.end.position[c] = begin + (from.end.position[c] - begin) * factor(c);
    }
    return made;
  }

 private:
  Long factor(std::uint64_t key) const {
    if (sample_ == 0) return 1.0L;
    std::uint64_t x = key * 0x9e3779b97f4a7c15U + sample_;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    const double off =
        std::ldexp(kOff, sample_ % 2U != 0 ? 0 : -static_cast<int>(sample_ % 16U / 2U));
    return 1.0L + ((x >> 63U) != 0 ? off : -off) * kEpsilon;
  }
  std::uint64_t sample_;
};

/// Tells whether a result does not jump where stick turns to slip.
bool is_continuous(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNames{"force",       "elastic slip",  "slip increment",
                                                   "dissipation", "stored energy", "work"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

struct Comparison {
  std::string fault;         ///< empty: within the bound
  bool conditioned = false;  ///< increments that are off had to be asked
  std::string jump;          ///< within the bound, but of another branch
  bool refused = false;      ///< no result, which double says
};

Comparison compare(Way way, const std::vector<double>& definition,
                   const PlainIncrement<double>& increment,
                   const std::vector<PlainResult<double>>& found) {
  const auto in_long = [&](std::uint64_t sample) {
    const Off off(sample);
    const std::vector<Long> packed = off(definition);
    return one_step<Long>(way, packed, off(increment)).results;
  };
  const auto exact = in_long(0);
  const std::size_t count = found.size();
  Comparison result;
  if (exact.size() != count) {
    result.fault = "long double takes no such definition";
    return result;
  }

  // A search that has not converged says so, and has no bound; where exact integration has to go
  // over changes as near to each other as rounding, double may end a run that long double does not.
  const auto gives_up = [&](const auto& results) {
    return std::any_of(results.begin(), results.end(), [](const auto& one) {
      return std::string_view(one.name) == "converged" && one.value == 0;
    });
  };
  if (gives_up(found) && (way == Way::kExact || gives_up(exact))) {
    result.refused = true;
    return result;
  }

  const double part = kRounding * kEpsilon + (way == Way::kExact ? kPieces * kExactness : 0.0);
  std::vector<Long> low(count), high(count);
  for (std::size_t i = 0; i < count; ++i) low[i] = high[i] = exact[i].value;
  const auto size = [&](std::size_t i) { return std::max<Long>(found[i].size, exact[i].size); };
  const auto apart = [&](std::size_t i) { return std::abs(found[i].value - exact[i].value); };
  const auto first_beyond = [&] {
    std::size_t i = 0;
    while (i < count && apart(i) <= part * size(i) + kUnseen * (high[i] - low[i]) + kNothing) ++i;
    return i;
  };
  std::size_t beyond = first_beyond();
  result.conditioned = beyond < count;
  for (std::uint64_t sample = 1; sample <= kSamples && beyond < count; ++sample) {
    const auto other = in_long(sample);
    for (std::size_t i = 0; i < std::min(count, other.size()); ++i) {
      low[i] = std::min(low[i], other[i].value);
      high[i] = std::max(high[i], other[i].value);
    }
    beyond = first_beyond();
  }
  const auto told = [&](std::size_t i) {
    std::ostringstream text;
    text.precision(17);
    text << found[i].name << " is " << found[i].value << ", exactly " << exact[i].value << ", of "
         << size(i) << ", off " << high[i] - low[i];
    return text.str();
  };
  if (beyond < count) {
    result.fault = told(beyond);
    return result;
  }
  for (std::size_t i = 0; i < count && result.jump.empty(); ++i) {
    if (is_continuous(found[i].name) && apart(i) > kJump * size(i) + kNothing)
      result.jump = told(i);
  }
  return result;
}

struct Tally {
  std::int64_t increments = 0, conditioned = 0, jumps = 0, refused = 0;
};

/// Goes through the history of a seed, each increment from the state before it in double.
void run(std::uint64_t seed, Way way, Tally* tally) {
  AnyCase any = any_case(seed, way);
  PlainState<double> state;
  int number = 0;
  for (PlainIncrement<double>& increment : any.increments) {
    increment.old = state;
    const PlainStep<double> step = one_step<double>(way, any.definition, increment);
    if (step.results.empty()) return;
    const Comparison comparison = compare(way, any.definition, increment, step.results);
    const std::string where = "seed " + std::to_string(seed) +
                              (way == Way::kExact ? ", exactly" : "") + ", increment " +
                              std::to_string(++number) + ": ";
    if (!comparison.fault.empty()) FAIL_CHECK(where + comparison.fault);
    if (!comparison.jump.empty()) UNSCOPED_INFO(where + comparison.jump);
    ++tally->increments;
    tally->conditioned += comparison.conditioned ? 1 : 0;
    tally->jumps += comparison.jump.empty() ? 0 : 1;
    tally->refused += comparison.refused ? 1 : 0;
    state = step.state;
  }
}

TEST_CASE("double gives what long double gives, but for a stated error") {
  Tally tally;
  for (const std::uint64_t seed : kFound) run(seed, Way::kBackwardEuler, &tally);
  for (const std::uint64_t seed : kFoundExactly) run(seed, Way::kExact, &tally);
  const auto wanted = static_cast<std::int64_t>(increments_wanted());
  // An exact increment takes up to a thousand times as long as another.
  for (std::uint64_t seed = first_seed(); tally.increments < wanted; ++seed) {
    run(seed, seed % 50 == 0 ? Way::kExact : Way::kBackwardEuler, &tally);
  }
  WARN(tally.increments << " increments, " << tally.conditioned << " of them conditioned, "
                        << tally.jumps << " jumps, " << tally.refused << " refused");
  // Few decisions lie on rounding, or the bound says nothing. Of a short run chance decides.
  CHECK(tally.jumps <= std::max<std::int64_t>(tally.increments / 1000, 10));
  CHECK(tally.refused <= std::max<std::int64_t>(tally.increments / 1000, 10));
}

}  // namespace
