// SPDX-License-Identifier: Apache-2.0
// Writes random definitions as packed numbers, with a history each and what the law makes of it:
// for tests that come to the law by other doors. All numbers are written so that they are read back
// in all bits.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "law/definition/packed_definition.hpp"
#include "tests/support/any_definition.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::test;

void write(const std::vector<double>& numbers) {
  for (const double x : numbers) std::printf("%.17g\n", x);
}

template <class Vector>
void append(const Vector& vector, std::vector<double>& numbers) {
  for (int c = 0; c < law::kComponents; ++c) numbers.push_back(vector[c]);
}

/// All numbers of the row, then the friction force, the state, the figures and the regime.
std::vector<double> line_of(const law::FrictionDefinition& definition, const HistoryRow& row,
                            const law::FrictionUpdate& update) {
  std::vector<double> line{row.duration};
  append(row.begin, line);
  append(row.end, line);
  append(row.reference, line);
  append(row.force, line);
  line.push_back(row.temperature);
  line.insert(line.end(), row.fields.begin(), row.fields.end());
  append(law::friction_force(definition, update.state), line);
  line.insert(line.end(), update.state.elastic_slip.begin(), update.state.elastic_slip.end());
  line.insert(line.end(), update.state.force.begin(), update.state.force.end());
  line.push_back(update.state.accumulated_slip);
  line.push_back(update.state.accumulated_slip.left_out());
  const auto regime = static_cast<double>(update.state.regime);
  for (const double x :
       {regime, update.limit, update.normal_force, update.mu, update.slip_increment,
        update.slip_rate, update.dissipation, update.stored_energy, update.work, regime}) {
    line.push_back(x);
  }
  return line;
}

}  // namespace

/// law_fixture COUNT: so many definitions. Each: how many numbers it has, the numbers; how many
/// rows, the rows' 58 numbers.
int main(int argc, char** argv) {
  const long count = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0;
  std::printf("%ld\n", count);
  std::uint32_t seed = 0;
  for (long made = 0; made < count;) {
    Dice dice(++seed);
    const law::FrictionDefinition definition = any_definition(dice);
    // A unit begins with an increment without motion, and its steps take time.
    std::vector<HistoryRow> rows = random_history(&dice, 5);
    for (HistoryRow& row : rows) {
      if (!(row.duration > 0.0)) row.duration = 1.0 / 64.0;
    }
    rows.insert(rows.begin(), rows.front());
    rows.front().end = rows.front().begin;
    rows.front().duration = 0.0;
    const std::vector<law::FrictionUpdate> updates = run_any(definition, rows);
    bool finite = true;
    for (const law::FrictionUpdate& one : updates)
      finite = finite && law::all_finite(one) && one.converged;
    if (!finite) continue;
    ++made;
    const std::vector<double> numbers = law::pack_all({&definition, 1});
    std::printf("%zu\n", numbers.size());
    write(numbers);
    std::printf("%zu\n", rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) write(line_of(definition, rows[i], updates[i]));
  }
  return 0;
}
