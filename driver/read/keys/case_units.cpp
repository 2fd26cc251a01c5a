// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/case_units.hpp"

#include <string>

#include "driver/base/files/data_path.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::read {

base::UnitSystem read_units(yaml::Binder& binder, const UnitsText& text) {
  const auto read = [&](const yaml::At<std::string>& unit, const base::Dimension& dimension,
                        const std::string& fallback) {
    if (!unit.given()) return std::string();
    if (!unit.sound) return fallback;
    if (const auto good = base::check_base_unit(unit.value, dimension); !good) {
      binder.history_error(*unit.node, unit.path, good.error());
      return fallback;
    }
    return unit.value;
  };
  return {read(text.length, base::kLength, "m"), read(text.force, base::kForce, "N"),
          read(text.time, base::kTime, "s"), read(text.temperature, base::kTemperature, "K")};
}

base::UnitSystem units_of(const yaml::Node& root) {
  base::Diagnostics unheard;
  const base::NamedNumbers none;
  yaml::Binder binder(unheard, none, {}, {}, false, kCaseWords);
  UnitsText text;
  if (const auto units = root.find("units")) {
    yaml::Codec<UnitsText>::read(binder, *units, yaml::Path(), {}, text);
  } else if (yaml::is_misspelt<CaseText>(root, "units")) {
    return {"m", "N", "s", "K"};
  }
  return read_units(binder, text);
}

std::optional<base::UnitSystem> units_of_file(const std::filesystem::path& folder,
                                              std::string_view text, bool allow_outside) {
  const auto file = base::resolve_data_path(folder, text, allow_outside);
  if (!file || text == base::kStandardInput) return std::nullopt;
  const auto source = base::read_source(file->string());
  if (!source) return std::nullopt;
  const auto tree = yaml::parse_yaml(*source);
  if (!tree) return std::nullopt;
  return units_of(tree->root());
}

}  // namespace slipbench::driver::read
