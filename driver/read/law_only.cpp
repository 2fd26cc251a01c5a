// SPDX-License-Identifier: Apache-2.0
#include "driver/read/law_only.hpp"

#include <utility>
#include <variant>

#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {

tl::expected<LawOnly, base::Diagnostics> read_law_only(const base::SourceText& source,
                                                       const std::string& folder) {
  auto parsed = ParsedCase::parse(source, folder);
  if (!parsed) return tl::unexpected(std::move(parsed.error()));
  auto definitions = parsed->resolve_friction_only();
  if (!definitions) return tl::unexpected(std::move(definitions.error()));
  LawOnly found;
  base::Diagnostics faults;
  for (cases::CaseDefinition& one : *definitions) {
    if (one.backward || one.dead_zone || std::holds_alternative<law::Capstan>(one.law.criterion)) {
      faults.error(source.name(), {}, "friction[" + std::to_string(one.entry) + "]",
                   "a law alone has no dead zones, directions or belts",
                   "run a case that has them");
    }
    found.names.push_back(std::move(one.name));
    found.definitions.push_back(std::move(one.law));
  }
  if (found.definitions.empty()) {
    faults.error(source.name(), {}, {}, "missing key 'friction'", "a law is that of a friction");
  }
  if (faults.has_errors()) return tl::unexpected(std::move(faults));
  return found;
}

}  // namespace slipbench::driver::read
