// SPDX-License-Identifier: Apache-2.0
// The command line of the farm: slipbench-mpi, started by mpirun or srun on every rank.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/interruption.hpp"
#include "driver/base/text/inputs_read.hpp"
#include "driver/cli/declare.hpp"
#include "driver/cli/faults.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/farm_calibrate.hpp"
#include "driver/commands/farm_sweep.hpp"
#include "driver/mpi/mpi_farm.hpp"
#include "driver/results/provenance.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::mpi {
namespace {

using FarmCommand = std::function<int(const farm::Farm&)>;

void declare_sweep(CLI::App& app, commands::FarmSweepOptions& options, FarmCommand& command) {
  CLI::App* declared =
      app.add_subcommand("sweep", "Run a case with many values of its parameters, on all ranks");
  declared->add_option("SWEEP", options.file, "A sweep file (YAML)")->required();
  declared
      ->add_option("-o,--output", options.folder,
                   "Folder of the result and the journals, which all ranks see")
      ->type_name("DIR")
      ->capture_default_str();
  cli::declare_settings(*declared, options.settings, options.allow_outside);
  cli::declare_format(*declared, options.format);
  declared->add_option("--report", options.report, "Also write a page to look at: FILE.html")
      ->type_name("FILE");
  declared->add_flag("--no-rows", options.no_rows,
                     "Write the summaries only, however many samples");
  cli::declare_force(*declared, options.force, "no result of this sweep");
  declared->footer(
      "Every rank takes samples until none are left and keeps them in <sweep>.rankN.journal\n"
      "(without rows <sweep>.rankN.tally);\n"
      "rank 0 writes what 'slipbench sweep' would have written, byte by byte. Interrupted, or\n"
      "after a rank was lost, the same command goes on from these, with however many\n"
      "ranks. A rank uses one core.\n"
      "Example: mpirun -n 8 slipbench-mpi sweep loop_sweep.yaml -o out");
  declared->callback([&options, &command] {
    options.file = commands::named_case(options.file);
    command = [&options](const farm::Farm& farm) {
      return commands::farm_sweep_command(options, farm);
    };
  });
}

void declare_calibrate(CLI::App& app, commands::CalibrateOptions& options, FarmCommand& command) {
  CLI::App* declared = app.add_subcommand(
      "calibrate", "Fit parameters and tables of cases to measured data, on all ranks");
  declared->add_option("FIT", options.file, "A fit file (YAML)")->required();
  declared->add_option("-o,--output", options.folder, "Folder of the results")
      ->type_name("DIR")
      ->capture_default_str();
  cli::declare_settings(*declared, options.settings, options.allow_outside);
  declared
      ->add_option("--bootstrap", options.bootstrap,
                   "Also errors by so many resamplings of the residuals")
      ->type_name("N")
      ->check(cli::whole_number(1, 100000));
  declared->add_flag("--profile", options.profile,
                     "Also the profile likelihood of every parameter");
  cli::declare_force(*declared, options.force, "no result of this fit");
  declared->footer(
      "All ranks do the same fit; starts ('multistart:'), resamplings and profiles are shared "
      "out,\n"
      "one at a time. Rank 0 writes what 'slipbench calibrate' would have written. A rank uses "
      "one\n"
      "core.\n"
      "Example: mpirun -n 8 slipbench-mpi calibrate rig_fit.yaml -o out --bootstrap 1000");
  declared->callback([&options, &command] {
    options.file = commands::named_case(options.file);
    command = [&options](const farm::Farm& farm) {
      return commands::farm_calibrate_command(options, farm);
    };
  });
}

/// Reads the command line. Only rank 0 says what is wrong with it.
/// \return the exit code where nothing is to be run
int parse(int argc, char** argv, CLI::App& app) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto say = [&](const std::string& text) {
    if (rank == 0) terminal::print_error(text);
  };
  const std::vector<std::string_view> words(argv + std::min(argc, 1), argv + argc);
  if (const std::string fault = cli::fault_of_command(app, words); !fault.empty()) {
    say("slipbench-mpi: error: " + fault + "\n");
    return base::kExitBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
      if (rank == 0) terminal::print(out.str());
      return base::kExitOk;
    }
    say(cli::fault_of_options(app, error));
    return base::kExitBadInput;
  }
  return base::kExitOk;
}

/// Says what went wrong inside and ends all ranks, which would wait for this one for ever.
void give_up(const std::exception& error) {
  terminal::print_error(fmt::format("slipbench-mpi: internal error: {}\n", error.what()));
  MPI_Abort(MPI_COMM_WORLD, base::kExitInternal);
}

int run(int argc, char** argv) {
  CLI::App app(
      "Runs sweeps and fits of slipbench on the ranks of an MPI job, on one machine or many.\n"
      "Start it with mpirun, or with srun --mpi=pmix.",
      "slipbench-mpi");
  app.set_version_flag("--version", "slipbench-mpi " + std::string(results::program_version()));
  app.require_subcommand(1);
  commands::FarmSweepOptions sweep;
  FarmCommand command;
  declare_sweep(app, sweep, command);
  commands::CalibrateOptions calibrate;
  declare_calibrate(app, calibrate, command);
  const int code = parse(argc, argv, app);
  if (!command) return code;
  MpiFarm farm;
  try {
    return command(farm.farm());
  } catch (const std::exception& error) {
    // Here, as the end of the farm waits for all ranks.
    give_up(error);
  }
  return base::kExitInternal;
}

}  // namespace
}  // namespace slipbench::driver::mpi

int main(int argc, char** argv) {
  using namespace slipbench::driver;
  base::handle_interruption();
  base::remember_inputs();
  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &threads);
  int code = base::kExitInternal;
  try {
    code = terminal::finish_output(mpi::run(argc, argv));
  } catch (const std::exception& error) {
    mpi::give_up(error);
  }
  MPI_Finalize();
  return code;
}
