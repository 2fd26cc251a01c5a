// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/emit_slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/shell_word.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/samples.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Runs chunks from places all over the sweep for about two seconds, on one thread.
/// \return samples a second
double measured_rate(const sweep::Sweep& sweep) {
  constexpr std::size_t kPlaces = 16;
  constexpr std::size_t kFar = 1'000'000;  // to get there takes a moment
  constexpr double kEnough = 2.0;          // [s]
  const std::size_t size = sweep::chunk_size(sweep);
  std::vector<sweep::Chunk> chunks;
  sweep::Samples samples(sweep);
  std::size_t next = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    // Samples of long runs may be the last ones of a grid, which costs nothing to go through.
    const std::size_t all =
        sweep.sampler == sweep::Sampler::kGrid ? sweep.samples : std::min(sweep.samples, kFar);
    const std::size_t first = std::max(next, i * all / kPlaces);
    if (first >= sweep.samples) break;
    chunks.emplace_back(sweep, first, std::min(size, sweep.samples - first));
    samples.skip(first - next);
    samples.take(chunks.back().values);
    next = chunks.back().end();
  }
  const auto start = Clock::now();
  std::size_t run = 0;
  double seconds = 0.0;
  // Every seventh of the places: early and late ones by turns.
  for (std::size_t i = 0; i < chunks.size() && seconds < kEnough; ++i) {
    sweep::Chunk& chunk = chunks[chunks.size() == kPlaces ? 7 * i % kPlaces : i];
    sweep::run_chunk(sweep, chunk);
    run += chunk.count;
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return static_cast<double>(run) / std::max(seconds, 1e-9);
}

std::string absolute(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), error);
  return error ? path.string() : whole.string();
}

/// This program, as it can be started from anywhere.
std::string program() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? "slipbench" : path.string();
}

/// The words that choose the samples and what is read, for `sweep` and `merge` alike.
std::string words_of(const SweepOptions& options) {
  std::string words = base::shell_word(absolute(options.file)) + " -o " +
                      base::shell_word(absolute(options.folder));
  for (const std::string& one : options.settings) words += " --set " + base::shell_word(one);
  if (options.allow_outside) words += " --allow-outside";
  return words;
}

/// A name of a job that is one plain word: Slurm reads it from a comment, where nothing quotes.
std::string job_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

}  // namespace

std::size_t array_tasks(std::size_t samples, double rate) {
  constexpr double kTask = 120.0;  // [s]
  constexpr double kMost = 1000.0;
  const double tasks = std::floor(static_cast<double>(samples) / rate / kTask);
  return static_cast<std::size_t>(std::clamp(tasks, 1.0, kMost));
}

int emit_slurm(const OpenSweep& open, const SweepOptions& options) {
  const double rate = options.rate > 0.0 ? options.rate : measured_rate(open.sweep);
  const std::size_t samples = open.sweep.samples;
  const std::size_t tasks = array_tasks(samples, rate);
  const double seconds = static_cast<double>(samples) / rate / static_cast<double>(tasks);
  const std::string name = sweep::result_name(open.sweep, std::nullopt);
  const std::string words = words_of(options);
  const std::string file_name = sweep::file_name(open.sweep);
  const base::FileMark mark{"a script of " + file_name, "#!/bin/sh\n# slipbench ",
                            "\n# sweep: " + file_name + "\n"};
  auto file = base::OutputFile::create(fs::path(options.folder) / (name + ".slurm"), mark,
                                       {open.inputs, options.force});
  if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
  file->append(
      fmt::format("#!/bin/sh\n"
                  "# slipbench sweep --emit slurm\n"
                  "# sweep: {}\n"
                  "# {} samples, {:.3g} a second and core: {} of about {:.3g} s each\n"
                  "#SBATCH --job-name={}\n"
                  "#SBATCH --array=1-{}\n"
                  "#SBATCH --ntasks=1\n"
                  "#SBATCH --cpus-per-task=1\n"
                  "#SBATCH --requeue\n"
                  "#SBATCH --open-mode=append\n"
                  "exec {} sweep {}{} -j 1 --part \"$SLURM_ARRAY_TASK_ID/{}\"\n",
                  file_name, samples, rate, tasks == 1 ? "1 task" : fmt::format("{} tasks", tasks),
                  seconds, job_name(name), tasks, base::shell_word(program()), words,
                  options.no_rows ? " --no-rows" : "", tasks));
  base::OutputFile* const files[] = {&*file};
  if (auto committed = base::commit(files); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  const std::string target = file->target().lexically_normal().string();
  terminal::print(base::printable(fmt::format(
                      "{}: {} samples, {:.3g} a second and core, tasks: {} of about {:.3g} s", name,
                      samples, rate, tasks, seconds)) +
                  "\n  sbatch " + base::printable(base::shell_word(target)) +
                  "\n  slipbench merge " + base::printable(words) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
