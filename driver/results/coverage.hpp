// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::driver::results {

/// Use that a run made of the parts of a table. A cell is what lies between neighbouring grid
/// points in every independent, the grid points of all blocks taken together.
struct TableCoverage {
  struct Axis {
    std::string name;           ///< the independent's, as a case writes it
    std::vector<double> knots;  ///< ascending
    std::int64_t below = 0;     ///< increments that asked below the first grid point
    std::int64_t above = 0;     ///< and above the last
    std::size_t stride = 1;     ///< of its intervals in `visits`
    std::size_t last = 0;       ///< the interval of the last increment

    std::size_t intervals() const { return knots.size() > 1 ? knots.size() - 1 : 1; }
  };

  std::size_t definition = 0;
  std::string
      what;  ///< "coefficient", "internal_contact_force", "weights"; with its step if changed
  law::Extrapolation extrapolation = law::Extrapolation::kConstant;
  std::vector<Axis> axes;            ///< in the order of the table's independents
  std::vector<std::int64_t> visits;  ///< increments in each cell; empty if they are not counted
  std::int64_t increments = 0;       ///< in which the table was in force
  std::int64_t outside = 0;          ///< of them, those outside the table

  /// Cells no increment was in.
  std::size_t unvisited() const;
  /// "slip_rate 0 .. 10, temperature 20 .. 90".
  std::string cell_text(std::size_t cell) const;
};

/// Counts the cells that the tables of a run are asked in: those of coefficients (also of a changed
/// friction, from its step on), internal contact forces and weights, each at the arguments of the
/// end of the increment. The storage is fixed by the tables; a case without tables costs nothing,
/// and an increment only what the tables in force then do.
class Coverage {
 public:
  explicit Coverage(const cases::Case& problem);
  /// Row 0 counts nothing.
  void add(std::span<const bench::Row> rows);
  void add(const bench::Row& row) { add({&row, 1}); }

  /// An increment of a case that keeps its friction, in both directions, known without a row.
  /// \param end of the increment
  /// \param updates one for each definition of the case
  void add(const law::Ambient& end, std::span<const law::FrictionUpdate> updates);

  std::span<const TableCoverage> tables() const { return tables_; }

  /// A line for each table that has cells never visited, or was asked outside, and one for those
  /// whose cells are not counted; indented by two blanks.
  /// \param most_lines at most so many lines; more tables are counted in one
  std::string text(std::size_t most_lines = 3) const;
  /// All tables; of each the first thousand cells, as long as these are not too many together.
  base::json::Value to_json() const;

  /// Cells of all tables: 8 MB. A table for which none are left is only counted along its
  /// independents, each for itself.
  static constexpr std::size_t kMostCells = std::size_t{1} << 20U;

 private:
  enum class Use : std::uint8_t { kCoefficient, kInternalContactForce, kWeights };
  /// In which increments a coefficient is in force.
  enum class Sense : std::uint8_t { kAny, kForward, kBackward };
  struct Probe {
    const law::TableFunction* function = nullptr;
    Use use = Use::kCoefficient;
    int first_step = 0;  ///< in force from the start of this step
    int end_step = 0;    ///< up to the start of this one
    Sense sense = Sense::kAny;
  };
  void add_table(const law::TableFunction& function, Use use, std::size_t definition,
                 std::string what, int first_step, int end_step, Sense sense = Sense::kAny);
  /// Makes in_force_ that of a step.
  void go_to(int step);
  void count(std::span<const bench::Row> rows, std::size_t table);
  void count(const law::Ambient& end, const law::FrictionUpdate& update, std::size_t table);

  const cases::Case* case_;
  std::vector<Probe> probes_;  ///< one for each of tables_
  std::vector<TableCoverage> tables_;
  std::size_t cells_ = 0;              ///< of all tables, as far as they are counted
  std::vector<std::size_t> by_step_;   ///< the tables, ordered by their first step
  std::size_t next_ = 0;               ///< of by_step_, the first that was not in force yet
  std::vector<std::size_t> in_force_;  ///< the tables in step_
  int step_ = -1;                      ///< of the last row
};

/// An independent as a case writes it: slip_rate, CP1, CU1, field2, ...
std::string independent_name(const law::Independent& independent);

}  // namespace slipbench::driver::results
