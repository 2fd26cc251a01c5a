// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace slipbench::driver::terminal {

/// Progress of a work of many equal parts.
struct WorkDone {
  std::size_t done = 0;
  std::size_t total = 0;
  std::size_t failed = 0;  ///< of the done ones
};

/// "[=====>    ] 52 of 100 cases, 1 failed, 3 s left"; `seconds` is what `work` took so far [s].
std::string progress_text(const WorkDone& work, const std::string& what, double seconds);

/// Returns what fits into a line of that many characters, without any that could harm the terminal:
/// a longer line could not be taken back. 0 stands for a width that is not known.
std::string fitting(const std::string& text, std::size_t width);

/// A line on standard error that shows how far a long work is; shown only on a terminal, and only
/// once the work has taken half a second. It is gone at the end. One thread at a time may use it.
class Progress {
 public:
  /// `what` is worked on: the name of a case, or in the plural what `WorkDone` counts.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Cheap enough to be called for every increment.
  /// \param time that the increment ends at, of the run
  void step(std::int64_t increment, double time) {
    if ((++calls_ & kMask) == 0 && terminal_) show(increment, time);
  }
  void step(const WorkDone& work);
  /// "rig: <text>", for a work whose end is not known.
  void say(const std::string& text);

  /// Takes the line away before something else is printed; the next `step` may show it again.
  void hide();

 private:
  static constexpr unsigned kMask = (1U << 16U) - 1U;
  void show(std::int64_t increment, double time);
  bool due();
  void draw(const std::string& text);

  std::string what_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;  ///< not to be drawn again before
  unsigned calls_ = 0;
  bool terminal_ = false;
  bool shown_ = false;
};

/// The same for a work of many equal parts that several threads do.
class SharedProgress {
 public:
  SharedProgress(std::string what, std::size_t total)
      : progress_(std::move(what)), work_{0, total, 0} {}

  /// One part is done.
  void done(bool well = true);
  /// A sign of life in the middle of a part, after some rows; cheap enough for every one.
  void tick(std::size_t rows);

 private:
  std::mutex mutex_;
  Progress progress_;
  WorkDone work_;
};

}  // namespace slipbench::driver::terminal
