// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "driver/read/keys/case_text.hpp"
#include "driver/yaml/binding.hpp"
#include "law/base/component.hpp"
#include "law/definition/potential_terms.hpp"

namespace slipbench::driver::read {

/// The potential of a friction definition. Where its text is faulty the slip space is what could be
/// read.
struct ResolvedPotential {
  law::SlipSpace slip;
  law::SlipCriterion criterion;
  law::ComponentSet components;   ///< that slip
  bool components_known = false;  ///< false: there may be more
};

/// Builds a potential of its text and reports what breaks the rules of docs/theory, section 7, each
/// fault at the term that has it.
/// \param derived finds a derived component by its name, or reports why it cannot and returns null
ResolvedPotential resolve_potential(
    yaml::Binder& binder, const yaml::At<PotentialText>& text,
    const std::function<const law::DerivedComponent*(const yaml::At<std::string>& name)>& derived);

/// Returns where a potential brings in `component` (index 0..5): the key of the term, or the
/// potential.
std::pair<yaml::Node, yaml::Path> place_in_potential(const yaml::At<PotentialText>& text,
                                                     const CaseText& all, int component);

}  // namespace slipbench::driver::read
