// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sweep_reference.hpp"

#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/sweep/sweep_text.hpp"

namespace slipbench::driver::sweep {

std::vector<yaml::KeyRow> sweep_rows() {
  std::vector<yaml::KeyRow> rows;
  yaml::struct_rows<SweepText>("", rows);
  return rows;
}

yaml::Json sweep_schema() {
  yaml::Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "slipbench sweep, version 1";
  yaml::Json body = yaml::struct_schema<SweepText>();
  for (const std::string_view key : {"type", "properties", "required", "additionalProperties"}) {
    schema[key] = body[key];
  }
  return schema;
}

std::string sweep_reference_markdown() {
  return "\n## Sweep files\n\n"
         "What `slipbench sweep` reads. Numbers are in the units of the case.\n"
         "`slipbench schema --sweep` prints the JSON Schema.\n\n" +
         read::key_table(sweep_rows());
}

const yaml::FileWords kSweepWords{[](std::string_view) { return std::optional<yaml::LaterKey>(); },
                                  [](std::string_view) { return std::string(); },
                                  [](std::string_view key) {
                                    static const std::vector<yaml::KeyRow> rows = sweep_rows();
                                    return read::places_of_key(key, rows);
                                  },
                                  read::origin_of_column,
                                  "known are t, T, the case's result columns and its parameters"};

}  // namespace slipbench::driver::sweep
