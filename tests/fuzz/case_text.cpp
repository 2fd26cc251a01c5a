// SPDX-License-Identifier: Apache-2.0
// The text of a case: YAML, binding, and the first increments of what is sound.
#include <string>

#include "driver/base/text/diagnostic.hpp"
#include "driver/read/read_case.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_run.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void case_text(std::string_view input) {
  copy_of_sources("cases/bad/data");
  const driver::base::SourceText source("case.yaml", std::string(input));
  const auto read = driver::read::read_case_text(source, own_folder().string());
  const std::string messages = driver::base::render(read.diagnostics, read.sources);
  want(read.value.has_value() || read.diagnostics.has_errors(),
       "a case that is refused has an error");
  want(!read.diagnostics.has_errors() || !messages.empty(), "an error has a message");
  if (read.value && !read.diagnostics.has_errors()) run_briefly(*read.value);
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(case_text)
