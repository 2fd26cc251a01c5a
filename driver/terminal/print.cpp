// SPDX-License-Identifier: Apache-2.0
#include "driver/terminal/print.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::terminal {
namespace {

/// The first reason why standard output did not take something.
int output_error = 0;

void note_output_error() {
  if (output_error == 0) output_error = errno == 0 ? EIO : errno;
}

}  // namespace

void print(std::string_view text) { print_data(base::printable_lines(text)); }

void print_data(std::string_view bytes) {
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) note_output_error();
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) note_output_error();
}

void print_error(std::string_view text) { draw_line(base::printable_lines(text)); }

void draw_line(std::string_view text) {
  flush_output();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

int refuse(int code, std::string_view message) {
  print_error(fmt::format("slipbench: error: {}\n", base::printable(message)));
  return code;
}

int finish_output(int code) {
  flush_output();
  if (output_error == 0) return code;
  if (output_error == EPIPE) return code == base::kExitOk ? base::kExitNoReader : code;
  static bool told = false;
  if (!std::exchange(told, true))
    print_error(fmt::format("slipbench: error: standard output cannot be written: {}\n",
                            std::generic_category().message(output_error)));
  return base::worse(code, base::kExitEnvironment);
}

bool colour_wanted(int descriptor) {
  const auto value = [](const char* name) {
    const char* text = std::getenv(name);
    return std::string_view(text == nullptr ? "" : text);
  };
  const auto forced = [&](const char* name) { return !value(name).empty() && value(name) != "0"; };
  if (!value("NO_COLOR").empty()) return false;
  if (forced("FORCE_COLOR") || forced("CLICOLOR_FORCE")) return true;
  if (value("CLICOLOR") == "0") return false;
  return isatty(descriptor) == 1 && !value("TERM").empty() && value("TERM") != "dumb";
}

std::string elapsed_text(std::chrono::steady_clock::duration elapsed) {
  const double seconds = std::chrono::duration<double>(elapsed).count();
  constexpr double kShort = 0.0995;  // two digits make 1e+02 ms of more
  if (seconds < kShort) return fmt::format("{:.2g} ms", 1e3 * seconds);
  return fmt::format("{:.2f} s", seconds);
}

}  // namespace slipbench::driver::terminal
