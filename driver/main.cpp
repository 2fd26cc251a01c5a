// SPDX-License-Identifier: Apache-2.0
// The command line: what is typed becomes the options of a command.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "driver/commands/bless.hpp"
#include "driver/commands/calibrate.hpp"
#include "driver/commands/catalogue.hpp"
#include "driver/commands/check.hpp"
#include "driver/commands/import.hpp"
#include "driver/commands/plot.hpp"
#include "driver/commands/report.hpp"
#include "driver/commands/run.hpp"
#include "driver/commands/shared.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/results/interruption.hpp"
#include "driver/results/provenance.hpp"
#include "driver/text/diagnostic.hpp"

namespace slipbench::driver {
namespace {

/// A closed standard stream would give its number to the next file opened, and messages would end
/// up in a result. A stand-in that refuses the wrong direction makes them fail instead.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free number is the closed stream's, since those below it are open by now.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

void add_settings(CLI::App& command, std::vector<std::string>& settings, bool& allow_outside) {
  command
      .add_option("--set", settings,
                  "Give a parameter of the case another value; a number or an expression")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--allow-outside", allow_outside,
                   "Let the case read data files outside its own folder");
}

void name_cases(std::vector<std::string>& paths) {
  for (std::string& path : paths) path = named_case(path);
}

/// What is wrong with the command's name, if it is there and unknown; else empty.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return {};
  const std::string_view word = argv[1];
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  if (std::find(candidates.begin(), candidates.end(), word) != candidates.end()) return {};
  const auto near = nearest_name(word, candidates);
  return fmt::format(
      "unknown command '{}'; {}", printable(word),
      near ? fmt::format("did you mean '{}'?", *near) : "there are " + in_words(candidates, "and"));
}

int run(int argc, char** argv) {
  CLI::App app(
      "A test bench for connector friction: a case in YAML is run increment by increment\n"
      "and gives forces, slip and energies as CSV, verdicts and pictures.",
      "slipbench");
  app.footer(
      "Examples:\n"
      "  slipbench run shock.yaml                      run a case; shock.csv is the result\n"
      "  slipbench run shock.yaml --set mu=0.2 -o out  the same with another parameter value\n"
      "  slipbench check cases/                        run all cases and judge their checks\n"
      "  slipbench plot shock.yaml -o shock.svg        force against time and motion\n"
      "  slipbench list connections                    what a case may use\n"
      "  slipbench describe CYLINDRICAL                one of them in detail\n"
      "'slipbench COMMAND --help' tells more about a command.\n"
      "Exit codes: 0 all well, 1 a check failed, 2 bad input, 3 numerical failure,\n"
      "4 file or environment, 70 internal error, 130/143 interrupted.");
  app.set_version_flag("--version", "slipbench " + std::string(program_version()));
  app.require_subcommand(1);
  std::function<int()> command;

  RunOptions run_options;
  CLI::App* run_app = app.add_subcommand("run", "Run cases and write their results");
  run_app->add_option("CASE", run_options.cases, "Case files (YAML)")->required();
  run_app->add_option("-o,--output", run_options.folder, "Folder of the results; must exist")
      ->type_name("DIR")
      ->capture_default_str();
  add_settings(*run_app, run_options.settings, run_options.allow_outside);
  run_app->add_option("--every", run_options.every, "Write every N-th row, and the last")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000000));
  std::string format = "csv";
  run_app->add_option("--format", format, "Format of the rows")
      ->type_name("csv")
      ->check(CLI::IsMember({"csv"}))
      ->capture_default_str();
  run_app->add_flag("--no-output", run_options.no_output,
                    "Write no files, only tell what happened");
  run_app
      ->add_option("--explain", run_options.explain,
                   "Only tell why it sticks or slips at this total time; writes nothing")
      ->type_name("TIME");
  run_app->add_flag("--solver-report", run_options.solver_report,
                    "Also judge what an implicit solver has to expect; writes <case>.solver.csv");
  run_app->add_flag("--compare-integration", run_options.compare_integration,
                    "Only tell how far backward Euler is from exact integration; writes nothing");
  run_app->add_flag("--converge", run_options.converge,
                    "Only tell what half and quarter increments change; writes nothing");
  run_app->footer(
      "Writes <case>.csv (a row an increment), <case>.events.csv (every change between stick and\n"
      "slip) and <case>.json (the summary). Prints what happened and the case's own checks.\n"
      "Example: slipbench run shock.yaml hinge.yaml -o out --set mu=0.2 --every 10");
  run_app->callback([&] {
    name_cases(run_options.cases);
    command = [&] { return run_command(run_options); };
  });

  CheckOptions check_options;
  CLI::App* check_app = app.add_subcommand("check", "Run cases and judge their checks");
  check_app
      ->add_option("PATH", check_options.paths,
                   "Case files, or folders that are searched for *.yaml; default: this folder")
      ->expected(0, -1);
  check_app->add_option("-j,--jobs", check_options.jobs, "Threads; default: one a core")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  add_settings(*check_app, check_options.settings, check_options.allow_outside);
  check_app
      ->add_option("--filter", check_options.filters,
                   "Only cases whose name matches: a part of it, or a pattern with * and ?")
      ->type_name("PATTERN")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  check_app->add_flag("--failed-first", check_options.failed_first,
                      "Begin with the cases that did not pass last time");
  check_app->add_flag("--fail-fast", check_options.fail_fast,
                      "Stop at the first case that does not pass");
  check_app->add_flag("-q,--quiet", check_options.quiet,
                      "Of the table, only the cases that do not pass");
  check_app->add_option("--junit", check_options.junit, "Also write the verdicts as JUnit XML")
      ->type_name("FILE");
  check_app->add_option("--json", check_options.json, "Also write the verdicts as JSON")
      ->type_name("FILE");
  check_app->add_option("--report", check_options.report, "Also write an HTML page of the cases")
      ->type_name("FILE");
  check_app->footer(
      "Writes the files asked for, and remembers in the user's cache which cases did not pass.\n"
      "Folders named 'bad' and hidden files and folders are not searched.\n"
      "Exit code 1 if a check failed. In GitHub Actions, failures are also annotations.\n"
      "Example: slipbench check cases/ -j 4 --junit slip.xml --report slip.html");
  check_app->callback([&] {
    if (check_options.paths.empty()) check_options.paths = {"."};
    name_cases(check_options.paths);
    command = [&] { return check_command(check_options); };
  });

  BlessOptions bless_options;
  CLI::App* bless_app =
      app.add_subcommand("bless", "Accept today's curves of a case as its golden curves");
  bless_app->add_option("CASE", bless_options.file, "A case file (YAML)")->required();
  bless_app
      ->add_option("--reason", bless_options.reason,
                   "Why today's curve is right; it is kept in the golden file")
      ->type_name("TEXT")
      ->required();
  add_settings(*bless_app, bless_options.settings, bless_options.allow_outside);
  bless_app->footer(
      "Writes the files that the case's checks name as 'against: {curve: ..}', if they are "
      "missing\n"
      "or golden curves already; never anybody else's reference.\n"
      "Example: slipbench bless belt.yaml --reason \"new liner, mu 0.16\"");
  bless_app->callback([&] {
    bless_options.file = named_case(bless_options.file);
    command = [&] { return bless_command(bless_options); };
  });

  PlotOptions plot_options;
  CLI::App* plot_app = app.add_subcommand("plot", "Draw a case or a result");
  plot_app->add_option("CASE|RESULT.csv", plot_options.input, "A case file, or a result of 'run'")
      ->required();
  plot_app
      ->add_option(
          "-o,--output", plot_options.output,
          "The picture; its ending (.svg, .png, .pdf) says what it is. Default: <case>.svg")
      ->type_name("FILE");
  plot_app
      ->add_option("--as", plot_options.kind,
                   "One picture only: hysteresis, history, bands, shares, mu_map, residuals")
      ->type_name("KIND")
      ->check(CLI::IsMember(plot_kinds()));
  plot_app->add_flag("--law", plot_options.law,
                     "Draw the coefficients of a case over slip rate and pressure");
  add_settings(*plot_app, plot_options.settings, plot_options.allow_outside);
  plot_app->footer(
      "Friction force against time, with its limit and with slip shaded, and against motion.\n"
      "With --law: mu as curves and as a map, with the states that the run visits; the default\n"
      "name is <case>.law.svg.\n"
      "Needs gnuplot. Example: slipbench plot shock.yaml -o shock.png --set mu=0.2");
  plot_app->callback([&] {
    plot_options.input = named_case(plot_options.input);
    command = [&] { return plot_command(plot_options); };
  });

  ReportOptions report_options;
  CLI::App* report_app =
      app.add_subcommand("report", "Write an HTML page about cases and results, to look at");
  report_app
      ->add_option("CASE|RESULT.csv", report_options.inputs,
                   "Case files, folders that are searched for them, or results of 'run'")
      ->required();
  report_app->add_option("-o,--output", report_options.output, "The page")
      ->type_name("FILE.html")
      ->required();
  report_app->add_option("--title", report_options.title, "Title of the page")->type_name("TEXT");
  add_settings(*report_app, report_options.settings, report_options.allow_outside);
  report_app->footer(
      "One file that opens offline in any browser: verdicts, loops and histories, events, energy.\n"
      "Example: slipbench report cases/ -o report.html");
  report_app->callback([&] {
    name_cases(report_options.inputs);
    command = [&] { return report_command(report_options); };
  });

  CalibrateOptions calibrate_options;
  CLI::App* calibrate_app =
      app.add_subcommand("calibrate", "Fit parameters and tables of cases to measured data");
  calibrate_app->add_option("FIT", calibrate_options.file, "A fit file (YAML)")->required();
  calibrate_app
      ->add_option("-o,--output", calibrate_options.folder, "Folder of the results; must exist")
      ->type_name("DIR")
      ->capture_default_str();
  add_settings(*calibrate_app, calibrate_options.settings, calibrate_options.allow_outside);
  calibrate_app
      ->add_option("--bootstrap", calibrate_options.bootstrap,
                   "Also errors by so many resamplings of the residuals")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  calibrate_app->add_flag("--profile", calibrate_options.profile,
                          "Also the profile likelihood of every parameter");
  calibrate_app
      ->add_option("--report", calibrate_options.report,
                   "The HTML page; default: <fit>.html in the folder of the results")
      ->type_name("FILE");
  calibrate_app->add_flag("--no-output", calibrate_options.no_output,
                          "Write no files, only tell what was found");
  calibrate_app->footer(
      "Writes <fit>.json (all figures), <fit>.html and <fit>.*.svg (measured against fitted), and\n"
      "<case>.calibrated.yaml, the case with the values found, ready to run. Exit code 3 if the\n"
      "search did not converge; the reason is told in words.\n"
      "Example: slipbench calibrate rig_fit.yaml -o out --bootstrap 200");
  calibrate_app->callback([&] {
    calibrate_options.file = named_case(calibrate_options.file);
    command = [&] { return calibrate_command(calibrate_options); };
  });

  ImportOptions import_options;
  CLI::App* import_app =
      app.add_subcommand("import", "Write a case with the friction of a Radioss starter deck");
  import_app->add_option("DECK", import_options.deck, "A starter deck with a /FRICTION")
      ->required();
  import_app
      ->add_option("-o,--output", import_options.output, "The case file; default: the terminal")
      ->type_name("FILE");
  import_app->add_option("--id", import_options.id, "The /FRICTION to take, if there are several")
      ->type_name("ID");
  import_app
      ->add_option("--units", import_options.units,
                   "Length, force and time the deck is in; default: those of /BEGIN")
      ->type_name("\"mm N s\"");
  import_app
      ->add_option("--normal", import_options.normal,
                   "Normal of the contact, to judge the directions of orthotropic friction by")
      ->type_name("\"X Y Z\"");
  import_app->footer(
      "What a deck has no number for (stiffness, mass, area, load) is a parameter without a value\n"
      "in the case: give it there or with --set. Example:\n"
      "  slipbench import model_0000.rad --units \"mm N s\" -o pad.yaml\n"
      "  slipbench run pad.yaml --set K=5000 --set m=1e-6 --set normal_force=100 ...");
  import_app->callback([&] { command = [&] { return import_command(import_options); }; });

  std::string what;
  CLI::App* list_app = app.add_subcommand("list", "List what a case may use");
  list_app->add_option("WHAT", what, "One kind only")
      ->type_name("connections|laws|keys|closed-forms|curves|criteria|quantities")
      ->check(CLI::IsMember(
          {"connections", "laws", "keys", "closed-forms", "curves", "criteria", "quantities"}));
  list_app->callback([&] { command = [&] { return list_command(what); }; });

  std::string name;
  CLI::App* describe_app = app.add_subcommand(
      "describe",
      "Describe a connection type, law, key, closed form, curve, criterion or quantity");
  describe_app->add_option("NAME", name, "A name that 'slipbench list' shows")->required();
  describe_app->callback([&] { command = [&] { return describe_command(name); }; });

  CLI::App* schema_app =
      app.add_subcommand("schema", "Print the JSON Schema of case or fit files, for editors");
  bool markdown = false;
  bool fit_schema = false;
  schema_app->add_flag("--fit", fit_schema, "Print the schema of fit files, which calibrate reads");
  schema_app->add_flag("--markdown", markdown,
                       "Print the reference of both kinds of files as Markdown instead");
  schema_app->callback([&] { command = [&] { return schema_command(markdown, fit_schema); }; });

  if (const std::string fault = unknown_command(app, argc, argv); !fault.empty()) {
    print_error("slipbench: error: " + fault + "\n");
    return kExitBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
      print(out.str());
      return kExitOk;
    }
    print_error(fmt::format("slipbench: error: {}\nRun 'slipbench --help' for what there is.\n",
                            error.what()));
    return kExitBadInput;
  }
  return command();
}

}  // namespace
}  // namespace slipbench::driver

int main(int argc, char** argv) {
  using namespace slipbench::driver;
  fill_closed_streams();
  handle_interruption();
  try {
    return finish_output(run(argc, argv));
  } catch (const std::bad_alloc&) {
    return finish_output(refuse(kExitEnvironment, "this needs more memory than there is"));
  } catch (const std::exception& error) {
    print_error(fmt::format("slipbench: internal error: {}\n", error.what()));
    return kExitInternal;
  }
}
