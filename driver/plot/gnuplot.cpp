// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "driver/exit_code.hpp"
#include "driver/history/data_path.hpp"
#include "driver/results/interruption.hpp"

extern char** environ;

namespace slipbench::driver {
namespace fs = std::filesystem;
namespace {

/// Runs gnuplot on a script and waits for it.
tl::expected<void, PlotFailure> run_gnuplot(const fs::path& script_file) {
  std::string program = "gnuplot";
  std::string argument = script_file.string();
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  int error = 0;
  {
    const InterruptionPause pause;
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t nothing;
    sigemptyset(&nothing);
    posix_spawnattr_setsigmask(&attributes, &nothing);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    error = posix_spawnp(&child, "gnuplot", &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (error == 0) register_child(child);
  }
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    return failed(kExitEnvironment,
                  "gnuplot is not installed; pictures need it (Debian: apt install gnuplot-nox)");
  }
  if (error != 0) {
    return failed(kExitEnvironment,
                  "gnuplot cannot be started: " + std::generic_category().message(error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  register_child(0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return failed(kExitEnvironment, "gnuplot failed, see above");
  }
  return {};
}

}  // namespace

tl::unexpected<PlotFailure> failed(int code, const std::string& message) {
  return tl::unexpected(PlotFailure{code, "slipbench: error: " + message + "\n"});
}

std::string terminal_for(const fs::path& picture, std::size_t height) {
  const std::string extension = picture.extension().string();
  if (extension == ".svg") {
    return fmt::format("svg size 1200,{} background 'white' font 'Helvetica,15'", height);
  }
  if (extension == ".png") {
    return fmt::format("pngcairo size 1200,{} background 'white' font 'Sans,11'", height);
  }
  if (extension == ".pdf") {
    return fmt::format("pdfcairo size 1200/100.,{}/100. font 'Sans,11'", height);
  }
  return {};
}

std::optional<fs::path> find_template(std::string_view name_of_template) {
  return shipped_path(fs::path("plots") / name_of_template);
}

std::string gnuplot_string(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + "'";
}

tl::expected<void, PlotFailure> draw_script(const std::string& script, const fs::path& picture,
                                            OutputFile& output) {
  auto commands = OutputFile::create(fs::path(picture).concat(".gp"));
  if (!commands) return failed(kExitEnvironment, commands.error());
  commands->append(script);
  if (auto closed = commands->close(); !closed) return failed(kExitEnvironment, closed.error());
  if (auto drawn = run_gnuplot(commands->temporary()); !drawn) return drawn;
  std::error_code error;
  if (fs::file_size(output.temporary(), error) == 0 || error) {
    return failed(kExitEnvironment, picture.string() + ": gnuplot wrote no picture");
  }
  OutputFile* const together[] = {&output};
  if (auto committed = commit(together); !committed) {
    return failed(kExitEnvironment, committed.error());
  }
  return {};
}

}  // namespace slipbench::driver
