// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_opensees.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "driver/commands/contact_choice.hpp"
#include "driver/import/opensees/friction_model.hpp"

namespace slipbench::driver::commands {

ImportedDeck import_opensees(const ImportOptions& options) {
  ImportedDeck imported;
  const auto source = source_of(options, imported);
  if (!source) return imported;
  base::Diagnostics diagnostics;
  const opensees::Script script = opensees::read_script(*source, diagnostics);
  std::vector<ContactChoice> choices;
  for (opensees::Found& one : opensees::read_models(script, diagnostics)) {
    choices.push_back({fmt::format("{}_{}", one.type, one.tag), std::move(one.friction),
                       std::nullopt, !options.id || *options.id == one.tag});
  }
  return choose_contacts(options, std::move(choices), diagnostics, script.texts,
                         {"friction model", "--id"});
}

}  // namespace slipbench::driver::commands
