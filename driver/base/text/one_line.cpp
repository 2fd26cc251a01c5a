// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/one_line.hpp"

namespace slipbench::driver::base {

std::string one_line(const Diagnostic& diagnostic) {
  return (diagnostic.path.empty() ? "" : diagnostic.path + ": ") + diagnostic.message +
         (diagnostic.hint.empty() ? "" : "; " + diagnostic.hint);
}

std::vector<std::string> lines_of(const Diagnostics& diagnostics, Severity severity) {
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity == severity) lines.push_back(one_line(diagnostic));
  }
  return lines;
}

}  // namespace slipbench::driver::base
