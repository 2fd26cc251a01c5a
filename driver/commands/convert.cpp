// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/table/table_reader.hpp"
#include "driver/table/table_writer.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {

int convert_command(const ConvertOptions& options) {
  constexpr std::size_t kNumbersTogether = std::size_t{1} << 16U;
  const auto format = table::format_of(options.target);
  if (!format) {
    return terminal::refuse(base::kExitBadInput, base::printable(options.target) +
                                                     ": wants a name in .csv, .npy or .h5");
  }
  const auto table = table::open_table(options.file);
  if (!table) {
    const bool is_table = table::format_of(options.file).has_value();
    return terminal::refuse(is_table ? base::kExitEnvironment : base::kExitBadInput, table.error());
  }
  const table::TableHead& head = (*table)->head();
  // A file of the same lines or columns may be replaced.
  base::FileMark as_csv{"this table"};
  const std::string lines = base::in_cells(head.lines);
  if (const std::size_t first = lines.find('\n'); first != std::string::npos) {
    as_csv.start = lines.substr(0, first);
    as_csv.text = lines.substr(first);
  }
  const std::array inputs{options.file};
  auto file = base::OutputFile::create(options.target, table::mark_of(*format, head, as_csv),
                                       {inputs, options.force});
  if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
  auto writer = table::TableWriter::create(*format, head, *file);
  if (!writer) return terminal::refuse(base::kExitEnvironment, writer.error());
  const std::size_t width = head.columns.size();
  std::vector<double> block(std::max<std::size_t>(1, kNumbersTogether / width) * width);
  std::uint64_t rows = 0;
  terminal::Progress progress(std::filesystem::path(options.file).filename().string());
  while (true) {
    const auto count = (*table)->read(block);
    if (!count) {
      progress.hide();
      return terminal::refuse(base::kExitBadInput, count.error());
    }
    if (*count == 0) break;
    rows += *count;
    writer->write(std::span(block).first(*count * width));
    progress.say(fmt::format("{} rows", rows));
  }
  progress.hide();
  auto completed = writer->finish();
  base::OutputFile* const files[] = {&*file};
  if (completed) completed = base::commit(files);
  if (!completed) return terminal::refuse(base::kExitEnvironment, completed.error());
  terminal::print(fmt::format("{}: {} rows, {} columns\n", base::printable(file->target().string()),
                              rows, width));
  if (*format == table::TableFormat::kNpy && !head.lines.empty()) {
    terminal::print("  .npy has no place for where the rows come from, nor for units\n");
  }
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
