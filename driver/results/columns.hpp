// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::results {

struct Cell;
struct Column;

/// Function that reads the number of a column off a row, or off many rows without a call for each.
class ColumnValue {
 public:
  ColumnValue() = default;
  /// Takes a function object without a state, double(const Cell&).
  template <class Read>
  requires std::is_empty_v<Read> ColumnValue(Read read);  // NOLINT: a column names what reads it

  double operator()(const Cell& at) const { return one_(at); }
  /// Reads the numbers of some rows into `to`.
  void operator()(const Column& column, const cases::Case& problem,
                  std::span<const bench::Row* const> rows, double* to) const {
    many_(column, problem, rows, to);
  }
  bool operator==(const ColumnValue& other) const { return one_ == other.one_; }

 private:
  double (*one_)(const Cell& at) = nullptr;
  void (*many_)(const Column& column, const cases::Case& problem,
                std::span<const bench::Row* const> rows, double* to) = nullptr;
};

/// One column of the result: its name, the dimension its unit follows from, one sentence, and how
/// its number is read off a row.
struct Column {
  std::string name;
  base::Dimension dimension;
  std::string text;
  ColumnValue value;
  int index = 0;        ///< component 0..5, entry of the slip space, or flat quantity
  int definition = -1;  ///< of the case's definitions; -1 if it belongs to none
  double offset = 0.0;  ///< is subtracted
};

/// One number of the result: a column in a row.
struct Cell {
  const Column& column;
  const cases::Case& problem;
  const bench::Row& row;

  std::size_t index() const { return static_cast<std::size_t>(column.index); }
  std::size_t definition() const { return static_cast<std::size_t>(column.definition); }
  const bench::DefinitionRow& own() const { return row.definitions[definition()]; }
  const law::FrictionDefinition& law() const { return problem.definitions[definition()].law; }
  double scale() const { return law().slip.scale[index()]; }
  const bench::ComponentForces& forces() const { return row.forces.component[index()]; }
};

template <class Read>
requires std::is_empty_v<Read> ColumnValue::ColumnValue(Read)
    : one_([](const Cell& at) -> double { return Read{}(at); }),
      many_([](const Column& column, const cases::Case& problem,
               std::span<const bench::Row* const> rows, double* to) {
        for (const bench::Row* const row : rows) *to++ = Read{}(Cell{column, problem, *row});
      }) {}

/// All columns a case has, in the order of the result file (docs/guide, "Read the result"). Names
/// of one definition's columns end in `.name` where there are several definitions.
std::vector<Column> result_columns(const cases::Case& problem);

/// The columns of the result file: those the case selects under `output.columns`, in its order and
/// after `t`, or all of them. Names that do not exist are left out; the reader reports them.
std::vector<Column> output_columns(const cases::Case& problem);

/// The time and the columns of these names, or all that a result can have; names that no column has
/// are passed over.
std::vector<Column> chosen_columns(const cases::Case& problem, std::span<const std::string> names);

/// The column of a name, for checks: besides the names of `result_columns`, those that belong to a
/// definition may carry its `.name` even where the file omits it (CSF1.sleeve, FLIM.sleeve), and
/// the positions of held components, which are constant (CPR2 of a universal joint).
std::optional<Column> find_column(const cases::Case& problem, std::span<const Column> columns,
                                  std::string_view name);

/// Every name a check may use, for suggestions.
std::vector<std::string> column_names(const cases::Case& problem);

/// The number of a column in a row of a run of `problem`.
double column_value(const Column& column, const cases::Case& problem, const bench::Row& row);
/// Those of several rows, into `to`.
void column_values(const Column& column, const cases::Case& problem,
                   std::span<const bench::Row* const> rows, double* to);

bool is_position(const Column& column);          ///< CP, and with an offset CU and CCU
bool is_friction_force(const Column& column);    ///< of one entry of a definition's slip space
bool is_accumulated_slip(const Column& column);  ///< of a definition

/// From here on law::limit_use says only that the limit is 0, or kept at a floor next to it.
inline constexpr double kUseWithoutLimit = 1e9;

/// Tells whether y of the definition is a moment: its slip space has rotations only, none of them
/// scaled to a force.
bool is_rotational(const law::FrictionDefinition& definition);

}  // namespace slipbench::driver::results
