// SPDX-License-Identifier: Apache-2.0
// From the text of a table to the law's table, with every fault at its row.
#include <fmt/format.h>

#include <algorithm>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/column_unit.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

std::optional<law::Independent> independent(std::string_view name, const TableUse& use) {
  using Kind = law::IndependentKind;
  if (use.slip_rate && name == "slip_rate") return law::Independent{Kind::kSlipRate};
  if (use.contact_force && name == "contact_force") return law::Independent{Kind::kContactForce};
  if (use.accumulated_slip && name == "accumulated_slip") {
    return law::Independent{Kind::kAccumulatedSlip};
  }
  // A spring's table is asked at its displacement, a damper's at its velocity.
  if (use.displacement && name == "displacement") {
    return law::Independent{Kind::kConstitutiveMotion};
  }
  if (use.velocity && name == "velocity") return law::Independent{Kind::kSlipRate};
  if (name == "temperature") return law::Independent{Kind::kTemperature};
  if (const auto field = cases::field_of(name)) return law::Independent{Kind::kField, *field};
  if (use.motion) {
    if (const auto c = cases::component_of_motion(name))
      return law::Independent{Kind::kPosition, *c};
    for (const std::string_view prefix : {"CCU", "CU"}) {
      if (const auto c = cases::component_of_motion(name, prefix)) {
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
  if (use.displacement) names.push_back("displacement");
  if (use.velocity) names.push_back("velocity");
  if (use.motion) names.insert(names.end(), {"CP1", "CU1", "CCU1"});
  names.insert(names.end(), {"temperature", "field1"});
  return names;
}

/// The rows of a table, from the case or from its CSV file, and how messages point at them.
struct Rows {
  /// The case's own `rows:`, not copied, as there may be a million; null for those of a file.
  const std::vector<std::vector<double>>* stated = nullptr;
  std::vector<std::vector<double>> of_file;
  std::optional<yaml::Node> list;  ///< `rows:` of the case
  yaml::Path path;
  std::optional<yaml::Node> csv;  ///< where the case names the file
  std::string file;               ///< its name
  std::vector<long> lines;        ///< in the file

  [[nodiscard]] const std::vector<std::vector<double>>& values() const {
    return stated != nullptr ? *stated : of_file;
  }
  /// Reports a fault of row r, item c (-1: the whole row).
  void error(yaml::Binder& binder, int r, int c, const std::string& message) const {
    const auto row = static_cast<std::size_t>(r);
    if (list) {
      const yaml::Node node = (*list)[row];
      const bool item = c >= 0 && node.is_sequence() && static_cast<std::size_t>(c) < node.size();
      const yaml::Path here = path / row;
      binder.error(item ? node[static_cast<std::size_t>(c)] : node, item ? here / c : here,
                   message);
    } else {
      binder.error(*csv, path,
                   base::printable(file) + ":" + std::to_string(lines[row]) + ": " + message);
    }
  }
  /// "row 3", or "line 5" of the file.
  [[nodiscard]] std::string name(int r) const {
    const auto row = static_cast<std::size_t>(r);
    return list ? "row " + std::to_string(r + 1) : "line " + std::to_string(lines[row]);
  }
};

std::optional<Rows> rows_of(yaml::Binder& binder, const TableText& text, const yaml::Node& node,
                            const yaml::Path& path) {
  if (text.rows.given() == text.csv.given()) {
    if (text.rows.given()) {
      binder.error(*text.csv.node, text.csv.path, "a table has 'rows' or 'csv', not both");
    } else if (!yaml::has_unknown_key<TableText>(node)) {
      binder.error(node, path, "a table needs 'rows' or 'csv'");
    }
    return std::nullopt;
  }
  Rows rows;
  if (text.rows.given()) {
    if (!text.rows.sound) return std::nullopt;
    rows.stated = &text.rows.value;
    rows.list = text.rows.node;
    rows.path = text.rows.path;
    return rows;
  }
  if (!text.csv.sound) return std::nullopt;
  rows.csv = text.csv.node;
  rows.path = text.csv.path;
  const auto source = data_source(binder, text.csv);
  if (!source) return std::nullopt;
  rows.file = source->shown_name;
  std::vector<std::string> columns;
  for (const auto& column : text.columns.value) columns.push_back(column.value);
  const auto fail = [&](const base::HistoryError& error) {
    binder.history_error(*text.csv.node, text.csv.path, error);
    return std::nullopt;
  };
  if (!may_read(binder, *source, *text.csv.node, text.csv.path)) return std::nullopt;
  auto reader = base::CsvReader::open(*source, columns);
  if (!reader) return fail(reader.error());
  for (const auto& column : text.columns.value) {
    if (!is_in_units_of_case(binder, *reader, column.value, "a table", *column.node, column.path)) {
      return std::nullopt;
    }
  }
  std::vector<double> row(columns.size());
  while (true) {
    const auto more = reader->next(row);
    if (!more) return fail(more.error());
    if (!*more) break;
    if (!binder.count_table_row()) {
      binder.error(*text.csv.node, text.csv.path,
                   fmt::format("the tables of this case have more than {} rows from files",
                               yaml::Binder::kMostTableRows));
      return std::nullopt;
    }
    rows.of_file.push_back(row);
    rows.lines.push_back(reader->line());
  }
  const std::string missing = base::in_words(reader->missing(), source->format.missing);
  if (!missing.empty()) binder.note(*rows.csv, rows.path, rows.file + ": " + missing);
  return rows;
}

}  // namespace

std::optional<law::Table> table(yaml::Binder& binder, const TableText& text, const yaml::Node& node,
                                const yaml::Path& path, int dependents, int independents,
                                bool not_negative, law::Extrapolation extrapolation) {
  const std::optional<Rows> rows = rows_of(binder, text, node, path);
  if (!rows) return std::nullopt;
  const auto column = [&](int c) {
    return "'" + text.columns.value[static_cast<std::size_t>(c)].value + "'";
  };
  bool good = true;
  for (std::size_t r = 0; r < rows->values().size(); ++r) {
    const std::vector<double>& values = rows->values()[r];
    const int row = static_cast<int>(r);
    if (static_cast<int>(values.size()) != dependents + independents) {
      rows->error(binder, row, -1,
                  "wanted " + std::to_string(dependents + independents) +
                      " numbers, one for each column, found " + std::to_string(values.size()));
      good = false;
      continue;
    }
    for (int c = 0; not_negative && c < dependents; ++c) {
      const double value = values[static_cast<std::size_t>(c)];
      if (value < 0.0) {
        rows->error(binder, row, c,
                    column(c) + " must be at least 0, " + rows->name(row) + " has " +
                        base::format_number(value));
        good = false;
      }
    }
  }
  if (!good) return std::nullopt;
  law::Table result;
  law::TableError error;
  if (law::Table::build(rows->values(), dependents, independents, extrapolation, &result, &error)) {
    return result;
  }
  using Kind = law::TableError::Kind;
  switch (error.kind) {
    case Kind::kNoRows:
      binder.error(text.rows.given() ? *text.rows.node : node,
                   text.rows.given() ? text.rows.path : path, "a table needs at least one row");
      break;
    case Kind::kRowLength:
      rows->error(binder, error.row, -1, "the row has another number of columns");
      break;
    case Kind::kNotFinite:
      rows->error(binder, error.row, error.column, column(error.column) + " is no finite number");
      break;
    case Kind::kNotAscending: {
      const auto item = [&](int r) {
        return base::format_number(
            rows->values()[static_cast<std::size_t>(r)][static_cast<std::size_t>(error.column)]);
      };
      rows->error(binder, error.row, error.column,
                  "independents must ascend, the first one fastest: " + column(error.column) +
                      " goes back from " + item(error.other_row) + " in " +
                      rows->name(error.other_row) + " to " + item(error.row) + " in " +
                      rows->name(error.row));
      break;
    }
    case Kind::kRepeatedPoint:
      rows->error(binder, error.row, -1,
                  rows->name(error.row) + " repeats the point of " + rows->name(error.other_row));
      break;
    case Kind::kOneRowLinear:
      rows->error(binder, error.row, -1,
                  "linear extrapolation needs two rows, " + rows->name(error.row) +
                      " stands alone over " + column(error.column));
      break;
    case Kind::kTooManyIndependents:
      binder.error(
          *text.columns.node, text.columns.path,
          "a table has at most " + std::to_string(law::kMaxIndependents) + " independents");
      break;
    case Kind::kTooManyCorners:
      binder.error(*text.columns.node, text.columns.path,
                   "the blocks of the table have too few points in common: between them are more "
                   "than " +
                       std::to_string(law::kMostCorners) + " cells",
                   "give every block the same points of the first independents");
      break;
  }
  return std::nullopt;
}

std::optional<law::TableFunction> table_function(yaml::Binder& binder, const TableText& text,
                                                 const yaml::Node& node, const yaml::Path& path,
                                                 const TableUse& use, int dependents) {
  if (!text.columns.sound) return std::nullopt;
  bool good = true;
  const int columns = static_cast<int>(text.columns.value.size());
  if (columns < dependents) {
    binder.error(*text.columns.node, text.columns.path,
                 "wanted " + std::to_string(dependents) + " dependent column" +
                     (dependents == 1 ? "" : "s") + " first, then the independents; found " +
                     std::to_string(columns));
    return std::nullopt;
  }
  std::vector<law::Independent> independents;
  for (int c = 0; c < columns; ++c) {
    const yaml::At<std::string>& column = text.columns.value[static_cast<std::size_t>(c)];
    const auto found = independent(column.value, use);
    if (c < dependents) {
      if (found) {
        binder.error(*column.node, column.path,
                     "'" + column.value + "' is an independent: the dependent columns come first");
        // The others are then unknown.
        return std::nullopt;
      }
      continue;
    }
    if (!found) {
      const auto known = independents_of(use);
      binder.error(
          *column.node, column.path,
          std::string(use.what) + " cannot depend on '" + base::printable(column.value) + "'",
          binder.nearest_or(column.value, known, "known: " + base::few_in_words(known)));
      good = false;
      continue;
    }
    if (std::find(independents.begin(), independents.end(), *found) != independents.end()) {
      binder.error(*column.node, column.path, "'" + column.value + "' stands twice");
      good = false;
    }
    independents.push_back(*found);
  }
  // The rows are judged even so: their faults are their own.
  const law::Extrapolation extrapolation = use.of_behavior && !text.extrapolate.given()
                                               ? binder.extrapolation()
                                               : text.extrapolate.value;
  auto built = table(binder, text, node, path, dependents, columns - dependents, use.not_negative,
                     extrapolation);
  if (!good || !built) return std::nullopt;
  return law::TableFunction(std::move(*built), std::move(independents));
}

bool independents_available(yaml::Binder& binder, const law::Connection& connection,
                            const law::TableFunction& function, const yaml::Node& node,
                            const yaml::Path& path) {
  const auto columns = node.find("columns");
  if (!columns || !columns->is_sequence()) return true;
  const std::size_t dependents = columns->size() - function.independents().size();
  bool good = true;
  for (std::size_t i = 0; i < function.independents().size(); ++i) {
    const law::Independent& one = function.independents()[i];
    const bool motion = one.kind == law::IndependentKind::kPosition ||
                        one.kind == law::IndependentKind::kConstitutiveMotion;
    if (!motion || connection.info.available.contains(one.index)) continue;
    const yaml::Node name = (*columns)[dependents + i];
    binder.error(name, path / "columns" / (dependents + i),
                 "'" + base::printable(name.text()) +
                     "' never changes: " + connector_words(connection) +
                     (connection.info.held.contains(one.index) ? " holds" : " has no") +
                     " component " + std::to_string(one.index + 1) + "; free are " +
                     motion_names(connection.info.available));
    good = false;
  }
  return good;
}

}  // namespace slipbench::driver::read

namespace slipbench::driver::yaml {

using namespace read;  // specialisations belong to the namespace of their template

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
  bool match = text.columns.value.size() == kColumns.size();
  for (std::size_t i = 0; match && i < kColumns.size(); ++i) {
    match = text.columns.value[i].value == kColumns[i];
  }
  if (!match) {
    binder.error(*text.columns.node, text.columns.path,
                 "wanted the columns [k_ax, t_ax, k_tw, t_tw, slenderness]");
    return false;
  }
  auto built = table(binder, text, node, path, 4, 1, true, text.extrapolate.value);
  if (!built) return false;
  out = std::move(*built);
  return true;
}
Json Codec<law::Table>::schema(const KeyInfo&) { return struct_schema<TableText>(); }
std::string Codec<law::Table>::wanted(const KeyInfo&) { return "a table"; }
void Codec<law::Table>::rows(const std::string&, std::vector<KeyRow>&) {}

}  // namespace slipbench::driver::yaml
