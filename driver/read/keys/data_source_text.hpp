// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/read/keys/choices.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// A file of numbers wherever one is read: its name, or its name and how it is written.
struct DataSourceText {
  yaml::At<std::string> file;
  yaml::At<DecimalMark> decimal = yaml::default_of(DecimalMark::kPoint);
  yaml::At<ColumnSeparator> separator;
  int skip = 0;
  bool units_row = false;
  base::MissingSample missing = base::MissingSample::kError;

  static void declare(auto& key) {
    key("file", &DataSourceText::file, {.required = true, .text = "Name of the file."});
    key("decimal", &DataSourceText::decimal,
        {.text = "Decimal mark of its numbers.", .default_text = "."});
    key("separator", &DataSourceText::separator,
        {.text = "Between its columns; space: runs of blanks.",
         .default_text = "as the header shows: comma, semicolon or tab"});
    key("skip", &DataSourceText::skip,
        {.text = "How many lines stand before the header.",
         .default_text = "0",
         .bounds = law::kNotNegative});
    key("units_row", &DataSourceText::units_row,
        {.text = "true: the line below the header holds the units of the columns.",
         .default_text = "false"});
    key("missing", &DataSourceText::missing,
        {.text = "Where a sample is empty or nan: refuse the file, leave out the row, or "
                 "hold the column's value of the row before.",
         .default_text = "error"});
  }
};

}  // namespace slipbench::driver::read

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

template <>
struct Codec<read::DataSourceText> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   read::DataSourceText& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo& info);
  /// The keys are the same everywhere: listed once in a case, and once in a fit.
  static void rows(const std::string& path, std::vector<KeyRow>& rows);
};

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::read {

/// The format that a source states.
base::CsvFormat format_of(const DataSourceText& text);

/// The source itself, its file looked for in the case's folder; nothing after reporting an error.
std::optional<base::DataSource> data_source(yaml::Binder& binder,
                                            const yaml::At<DataSourceText>& text);

}  // namespace slipbench::driver::read
