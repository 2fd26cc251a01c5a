// SPDX-License-Identifier: Apache-2.0
// A plain increment as the law takes it; where long_double.hpp is read first, in long double.
#pragma once

#include "law/definition/increment.hpp"
#include "law/exact/path_segment.hpp"
#include "tests/difference/one_step.hpp"

namespace slipbench::test {

/// \param end keeps the fields
inline law::Ambient ambient(const PlainIncrement<double>::End& end) {
  return {{end.position}, {end.motion}, end.temperature, end.fields};
}

/// \param from keeps the fields
inline law::ConnectorIncrement law_increment(const PlainIncrement<double>& from) {
  law::ConnectorIncrement increment;
  increment.duration = from.duration;
  increment.begin_position.values = from.begin.position;
  increment.end = ambient(from.end);
  increment.force.values = from.end.force;
  return increment;
}

/// \param from keeps the fields
/// \param definition at the end of the increment
inline law::PathSegment law_segment(const law::FrictionDefinition& definition,
                                    const PlainIncrement<double>& from) {
  law::PathSegment segment =
      law::path_segment(definition, law_increment(from), ambient(from.begin), {from.begin.force});
  segment.begin_blend.weight = from.begin_blend;
  segment.begin_stick = from.begin_stick;
  segment.begin_wrap_angle = from.begin_wrap_angle;
  return segment;
}

}  // namespace slipbench::test
