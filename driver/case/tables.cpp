// SPDX-License-Identifier: Apache-2.0
// From the text of a table to the law's table, with every fault at its row.
#include <algorithm>

#include "driver/case/case_codecs.hpp"
#include "driver/case/quantity.hpp"
#include "driver/history/csv_reader.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

std::optional<law::Independent> independent(std::string_view name, const TableUse& use) {
  using Kind = law::IndependentKind;
  if (use.slip_rate && name == "slip_rate") return law::Independent{Kind::kSlipRate};
  if (use.contact_force && name == "contact_force") return law::Independent{Kind::kContactForce};
  if (use.accumulated_slip && name == "accumulated_slip") {
    return law::Independent{Kind::kAccumulatedSlip};
  }
  if (name == "temperature") return law::Independent{Kind::kTemperature};
  if (const auto field = field_of(name)) return law::Independent{Kind::kField, *field};
  if (use.motion) {
    if (const auto c = component_of_motion(name)) return law::Independent{Kind::kPosition, *c};
    for (const std::string_view prefix : {"CCU", "CU"}) {
      if (const auto c = component_of_motion(name, prefix)) {
        return law::Independent{Kind::kConstitutiveMotion, *c};
      }
    }
  }
  return std::nullopt;
}

std::vector<std::string_view> independents_of(const TableUse& use) {
  std::vector<std::string_view> names;
  if (use.slip_rate) names.push_back("slip_rate");
  if (use.contact_force) names.push_back("contact_force");
  if (use.accumulated_slip) names.push_back("accumulated_slip");
  if (use.motion) names.insert(names.end(), {"CP1", "CU1", "CCU1"});
  names.insert(names.end(), {"temperature", "field1"});
  return names;
}

/// The rows of a table, from the case or from its CSV file, with a node to point at for each.
struct Rows {
  std::vector<std::vector<double>> values;
  std::vector<Node> nodes;
};

std::optional<Rows> rows_of(Binder& binder, const TableText& text, const Node& node,
                            const Path& path) {
  Rows rows;
  if (text.rows.given() == text.csv.given()) {
    binder.error(node, path, "a table needs 'rows' or 'csv', and only one of them");
    return std::nullopt;
  }
  if (text.rows.given()) {
    for (const At<std::vector<double>>& row : text.rows.value) {
      rows.values.push_back(row.value);
      rows.nodes.push_back(*row.node);
    }
    return rows;
  }
  const auto file = binder.data_file(*text.csv.node, text.csv.path, text.csv.value);
  if (!file) return std::nullopt;
  std::vector<std::string> columns;
  for (const auto& column : text.columns) columns.push_back(column.value);
  const auto fail = [&](const HistoryError& error) {
    binder.history_error(*text.csv.node, text.csv.path, error);
    return std::nullopt;
  };
  auto reader = CsvReader::open(*file, columns, text.csv.value);
  if (!reader) return fail(reader.error());
  std::vector<double> row(columns.size());
  while (true) {
    const auto more = reader->next(row);
    if (!more) return fail(more.error());
    if (!*more) return rows;
    rows.values.push_back(row);
    rows.nodes.push_back(*text.csv.node);
  }
}

std::string row_name(int row) { return "row " + std::to_string(row + 1); }

}  // namespace

std::optional<law::Table> table(Binder& binder, const TableText& text, const Node& node,
                                const Path& path, int dependents, int independents,
                                bool not_negative) {
  const std::optional<Rows> rows = rows_of(binder, text, node, path);
  if (!rows) return std::nullopt;
  const auto at = [&](int row) {
    return row >= 0 && row < static_cast<int>(rows->nodes.size())
               ? rows->nodes[static_cast<std::size_t>(row)]
               : node;
  };
  bool good = true;
  for (std::size_t r = 0; not_negative && r < rows->values.size(); ++r) {
    const int row = static_cast<int>(r);
    for (int c = 0; c < dependents && c < static_cast<int>(rows->values[r].size()); ++c) {
      const double value = rows->values[r][static_cast<std::size_t>(c)];
      if (value < 0.0) {
        binder.error(at(row), path,
                     "'" + text.columns[static_cast<std::size_t>(c)].value +
                         "' must be at least 0, " + row_name(row) + " has " + format_number(value));
        good = false;
      }
    }
  }
  law::Table result;
  law::TableError error;
  if (!law::Table::build(rows->values, dependents, independents, text.extrapolate, &result,
                         &error)) {
    using Kind = law::TableError::Kind;
    const auto column = [&] {
      return "'" + text.columns[static_cast<std::size_t>(error.column)].value + "'";
    };
    std::string message;
    switch (error.kind) {
      case Kind::kNoRows:
        message = "a table needs at least one row";
        break;
      case Kind::kRowLength:
        message = row_name(error.row) + " must have " + std::to_string(dependents + independents) +
                  " numbers, one for each column";
        break;
      case Kind::kNotFinite:
        message = row_name(error.row) + ": " + column() + " is no finite number";
        break;
      case Kind::kNotAscending:
        message = "independents must ascend, the first one fastest: " + column() +
                  " goes back from " + row_name(error.other_row) + " to " + row_name(error.row);
        break;
      case Kind::kRepeatedPoint:
        message = row_name(error.row) + " repeats the point of " + row_name(error.other_row);
        break;
      case Kind::kOneRowLinear:
        message = "linear extrapolation needs two rows, " + row_name(error.row) +
                  " stands alone over " + column();
        break;
      case Kind::kTooManyIndependents:
        message = "a table has at most " + std::to_string(law::kMaxIndependents) + " independents";
        break;
    }
    binder.error(at(error.row), path, std::move(message));
    return std::nullopt;
  }
  if (!good) return std::nullopt;
  return result;
}

std::optional<law::TableFunction> table_function(Binder& binder, const TableText& text,
                                                 const Node& node, const Path& path,
                                                 const TableUse& use, int dependents) {
  bool good = true;
  const int columns = static_cast<int>(text.columns.size());
  if (columns < dependents) {
    binder.error(
        node, path / "columns",
        "wanted " + std::to_string(dependents) + " dependent columns first, then the independents");
    return std::nullopt;
  }
  std::vector<law::Independent> independents;
  for (int c = 0; c < columns; ++c) {
    const At<std::string>& column = text.columns[static_cast<std::size_t>(c)];
    const auto found = independent(column.value, use);
    if (c < dependents) {
      if (found) {
        binder.error(*column.node, column.path,
                     "'" + column.value + "' is an independent: the dependent columns come first");
        good = false;
      }
      continue;
    }
    if (!found) {
      const auto known = independents_of(use);
      std::string hint = "known: " + in_words(known, "and");
      if (const auto nearest = nearest_name(column.value, known)) {
        hint = "did you mean '" + std::string(*nearest) + "'?";
      }
      binder.error(*column.node, column.path,
                   std::string(use.what) + " cannot depend on '" + column.value + "'",
                   std::move(hint));
      good = false;
      continue;
    }
    if (std::find(independents.begin(), independents.end(), *found) != independents.end()) {
      binder.error(*column.node, column.path, "'" + column.value + "' stands twice");
      good = false;
    }
    independents.push_back(*found);
  }
  if (!good) return std::nullopt;
  auto built = table(binder, text, node, path, dependents, static_cast<int>(independents.size()),
                     use.not_negative);
  if (!built) return std::nullopt;
  return law::TableFunction(std::move(*built), std::move(independents));
}

bool Codec<law::InternalContactForce>::read(Binder& binder, const Node& node, const Path& path,
                                            const KeyInfo& info, law::InternalContactForce& out) {
  NumberOrTable text;
  if (!Codec<NumberOrTable>::read(binder, node, path, info, text)) return false;
  if (const double* number = std::get_if<double>(&text)) {
    out = *number;
    return true;
  }
  auto function =
      table_function(binder, std::get<TableText>(text), node, path, kInternalForceTable);
  if (!function) return false;
  out = std::move(*function);
  return true;
}
Json Codec<law::InternalContactForce>::schema(const KeyInfo& info) {
  return Codec<NumberOrTable>::schema(info);
}
std::string Codec<law::InternalContactForce>::wanted(const KeyInfo& info) {
  return Codec<NumberOrTable>::wanted(info);
}
void Codec<law::InternalContactForce>::rows(const std::string&, std::vector<KeyRow>&) {}

bool Codec<law::Table>::read(Binder& binder, const Node& node, const Path& path,
                             const KeyInfo& info, law::Table& out) {
  // The only bare table of the format: the shares of a universal joint's hinges.
  constexpr std::array<std::string_view, 5> kColumns{"k_ax", "t_ax", "k_tw", "t_tw", "slenderness"};
  TableText text;
  if (!Codec<TableText>::read(binder, node, path, info, text)) return false;
  bool match = text.columns.size() == kColumns.size();
  for (std::size_t i = 0; match && i < kColumns.size(); ++i) {
    match = text.columns[i].value == kColumns[i];
  }
  if (!match) {
    binder.error(node, path, "wanted the columns [k_ax, t_ax, k_tw, t_tw, slenderness]");
    return false;
  }
  auto built = table(binder, text, node, path, 4, 1, true);
  if (!built) return false;
  out = std::move(*built);
  return true;
}
Json Codec<law::Table>::schema(const KeyInfo&) { return struct_schema<TableText>(); }
std::string Codec<law::Table>::wanted(const KeyInfo&) { return "a table"; }
void Codec<law::Table>::rows(const std::string&, std::vector<KeyRow>&) {}

}  // namespace slipbench::driver
