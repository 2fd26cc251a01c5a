// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/fuzz_deck.hpp"

#include <cstddef>
#include <string>

#include "driver/base/text/diagnostic.hpp"
#include "driver/read/read_case.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_run.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void try_deck(std::string_view input,
              driver::commands::ImportedDeck (*import)(const driver::commands::ImportOptions&)) {
  constexpr std::size_t kMostCases = 2;
  own_folder();
  const driver::commands::ImportOptions options{
      .deck = "deck.inp",
      .all = true,
      .text = driver::base::SourceText("deck.inp", std::string(input))};
  const driver::commands::ImportedDeck imported = import(options);
  if (imported.code != driver::base::kExitOk) {
    want(!imported.messages.empty(), "a deck that is refused is told why");
    return;
  }
  want(!imported.cases.empty(), "a deck that is read has a case");
  for (std::size_t i = 0; i < imported.cases.size() && i < kMostCases; ++i) {
    const driver::import::WrittenCase& written = imported.cases[i].written;
    driver::read::ReadOptions given;
    for (const std::string& name : written.asked) given.overrides.push_back({name, 1.0});
    const auto read = driver::read::read_case_text(
        driver::base::SourceText("case.yaml", written.text), own_folder().string(), given);
    if (read.value && !read.diagnostics.has_errors()) run_briefly(*read.value);
  }
}

}  // namespace slipbench::fuzz
