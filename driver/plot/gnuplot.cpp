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
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

#include "driver/base/files/data_path.hpp"
#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/interruption.hpp"
#include "driver/plot/picture_mark.hpp"

namespace slipbench::driver::plot {
namespace fs = std::filesystem;
namespace {

/// Runs gnuplot on a script and waits for it.
tl::expected<void, PlotFailure> run_gnuplot(const fs::path& script_file) {
  std::string program = "gnuplot";
  std::string argument = script_file.string();
  std::string no_settings = "-d";  // of the user: they would change the picture
  std::array<char*, 4> arguments{program.data(), no_settings.data(), argument.data(), nullptr};
  // Nor does the user's language or terminal change it, and the degree sign is one of UTF-8.
  std::string locale = "LC_ALL=C.UTF-8";
  std::vector<char*> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view variable(*entry);
    if (!variable.starts_with("LC_ALL=") && !variable.starts_with("GNUTERM=")) {
      environment.push_back(*entry);
    }
  }
  environment.insert(environment.end(), {locale.data(), nullptr});
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  int error = 0;
  {
    const base::InterruptionPause pause;
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t nothing;
    sigemptyset(&nothing);
    posix_spawnattr_setsigmask(&attributes, &nothing);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    error = posix_spawnp(&child, "gnuplot", &actions, &attributes, arguments.data(),
                         environment.data());
    posix_spawnattr_destroy(&attributes);
    if (error == 0) base::register_child(child);
  }
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    return failed(base::kExitEnvironment,
                  "gnuplot is not installed; pictures need it (Debian: apt install gnuplot-nox)");
  }
  if (error != 0) {
    return failed(base::kExitEnvironment,
                  "gnuplot cannot be started: " + std::generic_category().message(error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  base::register_child(0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return failed(base::kExitEnvironment, "gnuplot failed, see above");
  }
  return {};
}

/// Shows an SVG smaller or larger than it is laid out: its first width and height are those of the
/// page, its viewBox stays. Returns whether it could.
bool scale_svg(const fs::path& file, double scale) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  in.close();
  for (const std::string_view name : {"width=\"", "height=\""}) {
    const std::size_t found = text.find(name);
    if (found == std::string::npos) return false;
    const std::size_t begin = found + name.size();
    const std::size_t end = text.find('"', begin);
    const double side = std::strtod(text.substr(begin, end - begin).c_str(), nullptr);
    text.replace(begin, end - begin, fmt::format("{:.0f}", scale * side));
  }
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

}  // namespace

tl::unexpected<PlotFailure> failed(int code, const std::string& message) {
  return tl::unexpected(PlotFailure{code, "slipbench: error: " + message + "\n"});
}

std::string terminal_for(const fs::path& picture, const Canvas& canvas, const PictureLook& look) {
  const std::string extension = picture.extension().string();
  const std::string background = fmt::format("background '{}'", look.dark ? "#16191d" : "white");
  if (extension == ".svg") {
    return fmt::format("svg size {:.0f},{:.0f} {} font 'Helvetica,15'", canvas.width, canvas.height,
                       background);
  }
  const auto scaled = [](double scale) {
    return fmt::format("fontscale {0:.6g} linewidth {0:.6g} pointscale {0:.6g}", scale);
  };
  if (extension == ".png") {
    const double scale = canvas.scale * (look.dpi > 0.0 ? look.dpi / kPixelsPerInch : 1.0);
    return fmt::format("pngcairo size {:.0f},{:.0f} {} font 'Sans,11' {}", canvas.width * scale,
                       canvas.height * scale, background, scaled(scale));
  }
  if (extension == ".pdf") {
    return fmt::format("pdfcairo size {:.6g}/100.,{:.6g}/100. {} font 'Sans,11' {}",
                       canvas.width * canvas.scale, canvas.height * canvas.scale, background,
                       scaled(canvas.scale));
  }
  return {};
}

std::optional<fs::path> find_template(std::string_view name_of_template) {
  return base::shipped_path(fs::path("plots") / name_of_template);
}

std::string gnuplot_string(std::string_view text) {
  // It splits a text at two apostrophes that follow each other, doubled or not.
  const char* const quote = text.find('\'') == text.npos ? "'" : "\"";
  std::string result = quote;
  for (const char c : text) {
    if (*quote == '"' && std::string_view("'\"\\`").find(c) != std::string_view::npos) {
      result += fmt::format("\\{:03o}", c);
      continue;
    }
    // gnuplot writes '>' into an SVG as it is, where "]]>" is no text.
    if (c == '>' && result.ends_with("]]")) result += ' ';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + quote;
}

tl::expected<void, PlotFailure> draw_script(const std::string& script, const fs::path& picture,
                                            double scale, base::OutputFile& output) {
  auto commands = base::OutputFile::create(fs::path(picture).concat(".gp"), {}, base::kNeverNamed);
  if (!commands) return failed(base::kExitEnvironment, commands.error());
  commands->append(script);
  if (auto closed = commands->close(); !closed)
    return failed(base::kExitEnvironment, closed.error());
  if (auto drawn = run_gnuplot(commands->temporary()); !drawn) return drawn;
  std::error_code error;
  if (fs::file_size(output.temporary(), error) == 0 || error) {
    return failed(base::kExitEnvironment, picture.string() + ": gnuplot wrote no picture");
  }
  const bool scaled =
      picture.extension() != ".svg" || scale == 1.0 || scale_svg(output.temporary(), scale);
  const std::string ending = picture.extension().string();
  if (!scaled || !write_mark(output.temporary(), ending, output.mark().text)) {
    return failed(base::kExitEnvironment,
                  picture.string() + ": cannot be written: it ends early, as on a full disk");
  }
  base::OutputFile* const together[] = {&output};
  if (auto committed = base::commit(together); !committed) {
    return failed(base::kExitEnvironment, committed.error());
  }
  return {};
}

}  // namespace slipbench::driver::plot
