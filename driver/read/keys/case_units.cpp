// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/case_units.hpp"

#include <string>

#include "driver/read/keys/key_index.hpp"

namespace slipbench::driver {

UnitSystem read_units(Binder& binder, const UnitsText& text) {
  const auto read = [&](const At<std::string>& unit, const Dimension& dimension,
                        const std::string& fallback) {
    if (!unit.given()) return std::string();
    if (!unit.sound) return fallback;
    if (const auto good = check_base_unit(unit.value, dimension); !good) {
      binder.history_error(*unit.node, unit.path, good.error());
      return fallback;
    }
    return unit.value;
  };
  return {read(text.length, kLength, "m"), read(text.force, kForce, "N"),
          read(text.time, kTime, "s"), read(text.temperature, kTemperature, "K")};
}

UnitSystem units_of(const Node& root) {
  Diagnostics unheard;
  const NamedNumbers none;
  Binder binder(unheard, none, {}, {}, false, kCaseWords);
  UnitsText text;
  if (const auto units = root.find("units")) {
    Codec<UnitsText>::read(binder, *units, Path(), {}, text);
  } else if (is_misspelt<CaseText>(root, "units")) {
    return {"m", "N", "s", "K"};
  }
  return read_units(binder, text);
}

}  // namespace slipbench::driver
