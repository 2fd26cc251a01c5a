// SPDX-License-Identifier: Apache-2.0
#include "driver/export/contact/contact_block.hpp"

#include <array>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {
namespace {

/// Notes what a table sees beside slip rate and contact force, which no program here has.
void drop_ambient(const FrictionStatement& statement, std::vector<Loss>& losses) {
  const auto* const table = law::get_law_if<law::TabularCoefficient>(statement.otherwise.law);
  if (table == nullptr) return;
  for (const law::Independent& one : table->table.independents()) {
    if (one.kind == law::IndependentKind::kTemperature) {
      losses.push_back(
          {Loss::Kind::kDropped, "the coefficient's dependence on the temperature: taken at " +
                                     base::format_number(statement.run.temperature) +
                                     ", where the history begins"});
    }
    if (one.kind == law::IndependentKind::kField) {
      const auto index = static_cast<std::size_t>(one.index);
      losses.push_back({Loss::Kind::kDropped, "the coefficient's dependence on field " +
                                                  std::to_string(index + 1) + ": taken at " +
                                                  base::format_number(statement.run.fields[index]) +
                                                  ", where the history begins"});
    }
  }
}

}  // namespace

tl::expected<ExportedDeck, std::string> to_contact(std::string_view program,
                                                   const cases::Case& problem,
                                                   const read::CaseText& written,
                                                   const ExportOptions& options) {
  using Writer = std::string (*)(const FrictionStatement&, const ExportOptions&, ExportedDeck&);
  constexpr std::array kWriters{
      std::pair<std::string_view, Writer>{"radioss", to_radioss},
      std::pair<std::string_view, Writer>{"lsdyna", to_lsdyna},
      std::pair<std::string_view, Writer>{"opensees", to_opensees},
      std::pair<std::string_view, Writer>{"table", to_table},
  };
  try {
    ExportedDeck deck;
    const FrictionStatement statement = stated_friction(problem, written, deck.losses);
    for (const auto& [name, write] : kWriters) {
      if (name == program) deck.text = write(statement, options, deck);
    }
    drop_ambient(statement, deck.losses);
    return deck;
  } catch (const NotExported& refused) {
    return tl::unexpected(refused.reason);
  }
}

}  // namespace slipbench::driver::exports
