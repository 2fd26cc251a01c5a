// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit_reference.hpp"

#include "driver/calibrate/fit_text.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_index.hpp"

namespace slipbench::driver::calibrate {

std::vector<yaml::KeyRow> fit_rows() {
  std::vector<yaml::KeyRow> rows;
  yaml::struct_rows<FitText>("", rows);
  return rows;
}

yaml::Json fit_schema() {
  yaml::Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "slipbench fit, version 1";
  yaml::Json body = yaml::struct_schema<FitText>();
  for (const std::string_view key : {"type", "properties", "required", "additionalProperties"}) {
    schema[key] = body[key];
  }
  return schema;
}

std::string fit_reference_markdown() {
  return "\n## Fit files\n\n"
         "What `slipbench calibrate` reads. A fit file has no parameters of its own: an "
         "expression\n"
         "(`= 2/3`) is one of plain numbers. Times, and numbers without a unit, are in the units "
         "of the\n"
         "experiment's case. `slipbench schema --fit` prints the JSON Schema.\n\n" +
         read::key_table(fit_rows());
}

const yaml::FileWords kFitWords{[](std::string_view) { return std::optional<yaml::LaterKey>(); },
                                [](std::string_view) { return std::string(); },
                                [](std::string_view key) {
                                  static const std::vector<yaml::KeyRow> rows = fit_rows();
                                  return read::places_of_key(key, rows);
                                },
                                read::origin_of_column,
                                "known are t, T, the case's result columns and its parameters"};

}  // namespace slipbench::driver::calibrate
