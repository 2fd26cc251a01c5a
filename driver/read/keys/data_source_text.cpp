// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/data_source_text.hpp"

#include <utility>

#include "driver/base/text/standard_input.hpp"

namespace slipbench::driver::yaml {

using namespace read;

bool Codec<DataSourceText>::read(Binder& binder, const Node& node, const Path& path,
                                 const KeyInfo& info, DataSourceText& out) {
  if (node.is_scalar()) {
    return Codec<At<std::string>>::read(binder, node, path, info, out.file);
  }
  if (!node.is_map()) {
    binder.wrong_kind(node, path, wanted(info));
    return false;
  }
  if (!read_struct(binder, node, path, out)) return false;
  if (out.decimal.value == DecimalMark::kComma && out.separator.given() &&
      out.separator.value == ColumnSeparator::kComma) {
    binder.error(*out.separator.node, out.separator.path,
                 "the comma cannot be the decimal mark and the separator at once");
    return false;
  }
  return true;
}
Json Codec<DataSourceText>::schema(const KeyInfo& info) {
  Json either = Json(base::json::Array{});
  either.push_back(Codec<std::string>::schema(info));
  either.push_back(struct_schema<DataSourceText>());
  Json schema;
  schema["anyOf"] = std::move(either);
  return schema;
}
std::string Codec<DataSourceText>::wanted(const KeyInfo&) {
  return "a file's name ('-' is standard input), or {file: ..., decimal: ..., skip: ...}";
}
void Codec<DataSourceText>::rows(const std::string& path, std::vector<KeyRow>& rows) {
  if (path == "history.csv" || path.ends_with("experiments[].data")) {
    struct_rows<DataSourceText>(path, rows);
  }
}

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::read {

base::CsvFormat format_of(const DataSourceText& text) {
  constexpr std::array<char, 4> kSeparators{',', ';', '\t', ' '};
  base::CsvFormat format;
  format.decimal = text.decimal.value == DecimalMark::kComma ? ',' : '.';
  if (text.separator.given()) {
    format.separator = kSeparators[static_cast<std::size_t>(text.separator.value)];
  }
  format.skip = text.skip;
  format.units_row = text.units_row;
  format.missing = text.missing;
  return format;
}

std::optional<base::DataSource> data_source(yaml::Binder& binder,
                                            const yaml::At<DataSourceText>& text) {
  const yaml::At<std::string>& name = text.value.file;
  if (!text.sound || !name.sound) return std::nullopt;
  const auto file = binder.data_file(*name.node, name.path, name.value);
  if (!file) return std::nullopt;
  return base::DataSource{*file, base::source_name(name.value), format_of(text.value)};
}

}  // namespace slipbench::driver::read
