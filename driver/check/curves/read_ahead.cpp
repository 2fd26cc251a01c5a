// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/read_ahead.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "driver/case/curve_file.hpp"

namespace slipbench::driver::check {

ReadAhead::ReadAhead(const cases::Case& problem) {
  std::vector<std::shared_ptr<const cases::CurveFile>> files;
  for (const cases::Check& check : problem.checks) {
    const auto* reference = std::get_if<cases::CurveReference>(&check.against);
    if (reference == nullptr || !reference->data) continue;
    if (std::find(files.begin(), files.end(), reference->data) == files.end()) {
      files.push_back(reference->data);
    }
  }
  if (files.empty()) return;
  try {
    thread_ = std::jthread([files = std::move(files)] {
      try {
        for (const auto& file : files) file->read_ahead();
      } catch (const std::bad_alloc&) {
        // Is read when it is needed, and told there.
      }
    });
  } catch (const std::system_error&) {
    // Likewise.
  }
}

}  // namespace slipbench::driver::check
