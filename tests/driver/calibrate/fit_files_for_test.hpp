// SPDX-License-Identifier: Apache-2.0
// A folder with sound cases, data and a fit file that tests change a few words of.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/calibrate/read_fit.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::calibrate {

inline const std::string kSliderCase =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "parameters: {mu: 0.15, k: 1000, stiffer: = 2*k}\n"
    "connector: {type: SLOT}\n"
    "friction:\n"
    "  - name: sleeve\n"
    "    predefined: {}\n"
    "    coefficient: = mu\n"
    "    stick: {stiffness: = k}\n"
    "history:\n"
    "  - step: go\n"
    "    increments: 10\n"
    "    force: {f2: 100}\n"
    "    motion: {CP1: {to: 1}}\n";

inline const std::string kTableCase =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "parameters: {mu: 0.3, k: 1000}\n"
    "connector: {type: SLOT}\n"
    "friction:\n"
    "  - component: 1\n"
    "    contact_force: 2\n"
    "    internal_contact_force: {columns: [press, CP1], rows: [[5, 0], [6, 1], [9, 2]]}\n"
    "    coefficient: {columns: [mu, slip_rate], rows: [[= mu, 0], [0.2, 10], [0.15, 100]]}\n"
    "    stick: {stiffness: = k}\n"
    "history:\n"
    "  - step: go\n"
    "    increments: 10\n"
    "    force: {f2: 100}\n"
    "    motion: {CP1: {to: 1}}\n";

inline const std::string kRigData =
    "# a rig of long ago\n"
    "t,stroke,load,speed\n"
    "0,0,0,1\n"
    "0.5,0.02,0.003,1\n"
    "1,0.04,0.003,1\n";

inline const std::string kSoundFit =
    "slipbench: 1\n"
    "calibrate:\n"
    "  experiments:\n"
    "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n"
    "  vary: {mu: {start: 0.2, bounds: [0, 1]}}\n";

/// slider.yaml, table.yaml, rig.csv and the fits that a test writes.
class FitFolder : public TemporaryFolder {
 public:
  FitFolder() {
    write("slider.yaml", kSliderCase);
    write("table.yaml", kTableCase);
    write("rig.csv", kRigData);
  }

  /// Reads a fit file with this text.
  ReadFit read(const std::string& text, const ReadFitOptions& options = {}) const {
    return read_fit(write("fit.yaml", text).string(), options);
  }
  /// The fit of a sound text.
  Fit sound(const std::string& text, const ReadFitOptions& options = {}) const {
    ReadFit result = read(text, options);
    INFO(base::render(result.diagnostics, result.sources));
    REQUIRE(result.value.has_value());
    return std::move(*result.value);
  }
  /// All messages in one text, with the folder's name left out.
  std::string complaint(const std::string& text, const ReadFitOptions& options = {}) const {
    const ReadFit result = read(text, options);
    CHECK(result.value.has_value() == !result.diagnostics.has_errors());
    std::string shown = base::render(result.diagnostics, result.sources);
    const std::string prefix = path().string() + "/";
    for (std::size_t at = 0; (at = shown.find(prefix, at)) != std::string::npos;) {
      shown.erase(at, prefix.size());
    }
    return shown;
  }
};

/// Replaces texts of a fit file, once each.
inline std::string changed_fit(const std::vector<std::pair<std::string, std::string>>& changes,
                               std::string text = kSoundFit) {
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    INFO("no '" << from << "' to be changed");
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  }
  return text;
}

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace slipbench::driver::calibrate
