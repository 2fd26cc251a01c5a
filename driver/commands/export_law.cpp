// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/files/plugin_path.hpp"
#include "driver/base/files/sha256.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/loss_report.hpp"
#include "driver/export/fmu/fmu_archive.hpp"
#include "driver/export/fmu/fmu_variables.hpp"
#include "driver/export/fmu/law_numbers.hpp"
#include "driver/export/fmu/model_description.hpp"
#include "driver/export/fmu/parameter_map.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;
using exports::LawNumbers;
using Kind = import::Loss::Kind;

/// Reason why nothing is written, with the exit code.
struct Failure {
  int code = base::kExitBadInput;
  std::string message;
};
using Written = tl::expected<std::string, Failure>;

/// A name that a program can be compiled with.
std::string identifier_of(const std::string& file) {
  std::string name = file == "-" ? "connector" : fs::path(file).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0)
    name.insert(0, "m_");
  return name;
}

/// The guid of a text: the same for the same unit.
std::string guid_of(const std::string& text) {
  const std::string sum = base::sha256_of(text);
  return fmt::format("{{{}-{}-{}-{}-{}}}", sum.substr(0, 8), sum.substr(8, 4), sum.substr(12, 4),
                     sum.substr(16, 4), sum.substr(20, 12));
}

/// The bytes of the library that all units have; nothing where it is not found.
std::string unit_library() {
  const auto place = base::plugin_path("slipbench-fmu.so");
  if (!place) return {};
  std::ifstream stream(*place, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Written unit_of(const read::ReadCase& read, const std::string& file,
                const std::vector<base::ParameterText>& settings, LawNumbers& law) {
  const cases::Case& problem = *read.value;
  std::string library = unit_library();
  if (library.empty()) {
    return tl::unexpected(
        Failure{base::kExitEnvironment,
                "slipbench-fmu.so, the library of units, is not beside the program"});
  }
  const std::string folder = fs::path(file).parent_path().string();
  const auto parsed = read::ParsedCase::parse(read.sources.front(), folder.empty() ? "." : folder);
  if (!parsed) return tl::unexpected(Failure{base::kExitBadInput, "the case is not read again"});
  const exports::ParameterMap map =
      exports::map_parameters(*parsed, problem, settings, law.numbers);
  const auto variables = exports::fmu_variables(problem, map);
  if (!variables) return tl::unexpected(Failure{base::kExitBadInput, variables.error()});
  for (const exports::FmuVariable& one : *variables) {
    if (one.role != "parameter") continue;
    const std::string& name = map.parameters[static_cast<std::size_t>(one.index)].name;
    law.losses.push_back(
        {Kind::kKept, fmt::format("parameter {}: the host can set it{}", name,
                                  one.name == name ? "" : ", by the name " + one.name)});
  }
  for (const exports::FixedParameter& one : map.fixed) {
    law.losses.push_back(
        {Kind::kDropped, fmt::format("parameter {}: {}; it stays {}", one.name, one.reason,
                                     problem.parameters.find(one.name)->second)});
  }
  if (std::string fault = exports::units_fault(problem); !fault.empty()) {
    return tl::unexpected(Failure{base::kExitEnvironment, std::move(fault)});
  }
  const std::string resource = exports::fmu_resource(problem, *variables, map, law.numbers);
  const std::string description_of = exports::model_description(problem, *variables, {});
  const exports::FmuIdentity identity{identifier_of(file), guid_of(resource + description_of)};
  const auto archive = exports::zip_archive(
      {{"modelDescription.xml", exports::model_description(problem, *variables, identity)},
       {"binaries/linux64/" + identity.identifier + ".so", std::move(library)},
       {"resources/law.txt", "guid " + identity.guid + "\n" + resource},
       {"documentation/case.yaml", std::string(read.sources.front().text())}});
  if (!archive) return tl::unexpected(Failure{base::kExitEnvironment, archive.error()});
  return *archive;
}

}  // namespace

int export_law(const read::ReadCase& read, const std::string& file,
               const std::vector<base::ParameterText>& settings, const DeckOutputOptions& options) {
  const auto refuse = [&](int code, const std::string& why) {
    return terminal::refuse(code, base::printable(file) + ": is not exported: " + why);
  };
  if (!options.part.empty() || options.digits > 0) {
    return refuse(base::kExitBadInput, "--part and --digits are for decks");
  }
  const bool is_unit = options.to == "fmu";
  const bool to_terminal = options.output.empty() || options.output == "-";
  if (is_unit && to_terminal)
    return refuse(base::kExitBadInput, "a unit is a file: say where it goes with -o NAME.fmu");
  auto law = exports::law_numbers(*read.value);
  if (!law) return refuse(base::kExitBadInput, law.error());
  const Written made =
      is_unit ? unit_of(read, file, settings, *law) : Written(exports::numbers_text(law->numbers));
  if (!made) return refuse(made.error().code, made.error().message);
  if (!to_terminal) {
    const std::string inputs[] = {file};
    const auto saved = base::save_text(options.output, *made, {inputs, options.force});
    if (!saved) return terminal::refuse(base::kExitEnvironment, saved.error());
  }
  if (options.json) {
    base::json::Value document;
    document["source"] = file;
    document["output"] = options.output;
    document["losses"] = loss_json(law->losses);
    terminal::print(document.dump(2) + "\n");
    return base::kExitOk;
  }
  terminal::print_error(loss_report(law->losses));
  terminal::print(to_terminal ? *made : base::printable(options.output) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
