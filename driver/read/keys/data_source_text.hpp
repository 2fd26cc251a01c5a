// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver {

enum class DecimalMark { kPoint, kComma };
template <>
struct EnumWords<DecimalMark> {
  static constexpr std::array<std::string_view, 2> kWords{".", ","};
};
enum class ColumnSeparator { kComma, kSemicolon, kTab, kSpace };
template <>
struct EnumWords<ColumnSeparator> {
  static constexpr std::array<std::string_view, 4> kWords{",", ";", "tab", "space"};
};
template <>
struct EnumWords<MissingSample> {
  static constexpr std::array<std::string_view, 3> kWords{"error", "skip", "hold"};
};

/// A file of numbers wherever one is read: its name, or its name and how it is written.
struct DataSourceText {
  static constexpr bool kIsDeclared = true;
  At<std::string> file;
  At<DecimalMark> decimal = default_of(DecimalMark::kPoint);
  At<ColumnSeparator> separator;
  int skip = 0;
  bool units_row = false;
  MissingSample missing = MissingSample::kError;

  template <class V>
  static void declare(V& key) {
    key("file", &DataSourceText::file, KeyInfo{.required = true, .text = "Name of the file."});
    key("decimal", &DataSourceText::decimal,
        KeyInfo{.text = "Decimal mark of its numbers.", .default_text = "."});
    key("separator", &DataSourceText::separator,
        KeyInfo{.text = "Between its columns; space: runs of blanks.",
                .default_text = "as the header shows: comma, semicolon or tab"});
    key("skip", &DataSourceText::skip,
        KeyInfo{.text = "How many lines stand before the header.",
                .default_text = "0",
                .bounds = law::kNotNegative});
    key("units_row", &DataSourceText::units_row,
        KeyInfo{.text = "true: the line below the header holds the units of the columns.",
                .default_text = "false"});
    key("missing", &DataSourceText::missing,
        KeyInfo{.text = "Where a sample is empty or nan: refuse the file, leave out the row, or "
                        "hold the column's value of the row before.",
                .default_text = "error"});
  }
};

template <>
struct Codec<DataSourceText> {
  static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info,
                   DataSourceText& out);
  static Json schema(const KeyInfo& info);
  static std::string wanted(const KeyInfo& info);
  /// The keys are the same everywhere: listed once in a case, and once in a fit.
  static void rows(const std::string& path, std::vector<KeyRow>& rows);
};

/// The format that a source states.
CsvFormat format_of(const DataSourceText& text);

/// The source itself, its file looked for in the case's folder; nothing after reporting an error.
std::optional<DataSource> data_source(Binder& binder, const At<DataSourceText>& text);

}  // namespace slipbench::driver
