// SPDX-License-Identifier: Apache-2.0
#include "driver/terminal/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::terminal {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kPause{100};  ///< between two drawings of the line

/// Tells whether standard error is a terminal on which a line can be taken back.
bool can_erase() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(STDERR_FILENO) == 1 && !dumb;
}

/// Returns how many characters a line of the terminal holds; 0 if it does not say.
std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string remaining_text(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  if (seconds < kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace

std::string progress_text(const WorkDone& work, const std::string& what, double seconds) {
  constexpr std::size_t kWidth = 20;
  const std::size_t done = std::min(work.done, work.total);
  const std::size_t filled = work.total == 0 ? 0 : done * kWidth / work.total;
  std::string bar(filled, '=');
  if (filled < kWidth) bar += '>';
  bar.resize(kWidth, ' ');
  std::string text = fmt::format("[{}] {} of {} {}", bar, done, work.total, what);
  if (work.failed > 0) text += fmt::format(", {} failed", work.failed);
  if (done > 0 && done < work.total) {
    const double left =
        seconds / static_cast<double>(done) * static_cast<double>(work.total - done);
    text += fmt::format(", {} left", remaining_text(left));
  }
  return text;
}

std::string fitting(const std::string& text, std::size_t width) {
  const std::string shown = base::printable(text);
  std::string_view rest = shown;
  // The last place stays free: some terminals begin a new line behind it.
  for (std::size_t used = 0; !rest.empty() && (width == 0 || used + 1 < width); ++used) {
    rest.remove_prefix(base::decode_utf8(rest).length);
  }
  return shown.substr(0, shown.size() - rest.size());
}

Progress::Progress(std::string what)
    : what_(std::move(what)),
      start_(Clock::now()),
      next_(start_ + kPatience),
      terminal_(can_erase()) {}

Progress::~Progress() {
  if (shown_) draw_line("\r\033[K");
}

/// Tells whether it is time to draw the line.
bool Progress::due() {
  const auto now = Clock::now();
  if (now < next_) return false;
  next_ = now + kPause;
  return true;
}

void Progress::draw(const std::string& text) {
  shown_ = true;
  draw_line("\r" + fitting(text, terminal_width()) + "\033[K");
}

void Progress::show(std::int64_t increment, double time) {
  if (due()) draw(fmt::format("{}: {} increments, t = {:.4g}", what_, increment, time));
}

void Progress::step(const WorkDone& work) {
  if (!terminal_ || !due()) return;
  draw(progress_text(work, what_, std::chrono::duration<double>(Clock::now() - start_).count()));
}

void Progress::say(const std::string& text) {
  if (terminal_ && due()) draw(what_ + ": " + text);
}

void Progress::hide() {
  if (!shown_) return;
  shown_ = false;
  next_ = Clock::now();
  draw_line("\r\033[K");
}

void SharedProgress::done(bool well) {
  const std::lock_guard lock(mutex_);
  ++work_.done;
  if (!well) ++work_.failed;
  progress_.step(work_);
}

void SharedProgress::tick(std::size_t rows) {
  constexpr std::size_t kRowsPerTick = 1U << 14U;
  thread_local std::size_t since = 0;
  if ((since += rows) < kRowsPerTick) return;
  since = 0;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) progress_.step(work_);
}

}  // namespace slipbench::driver::terminal
