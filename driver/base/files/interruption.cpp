// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/interruption.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>

namespace slipbench::driver::base {
namespace {

// A signal handler may use lock-free atomics, plain arrays and a few system calls, nothing else:
// hence the fixed places, which need no constructor.
constexpr std::size_t kPlaces = 64;
constexpr std::size_t kLongestPath = 1024;

struct Place {
  std::atomic<bool> taken;
  std::array<char, kLongestPath> path;
};

constinit std::array<Place, kPlaces> registered{};
constinit std::atomic<int> child{0};
constinit std::array<char, 2000> last_words{};
constinit std::atomic<std::size_t> last_words_length{0};

extern "C" void end_at_once(int signal_number) {
  if (const int process = child.load(); process > 0) kill(process, SIGTERM);
  for (const Place& place : registered) {
    if (place.taken.load()) unlink(place.path.data());
  }
  remove_empty_folders();
  if (const std::size_t length = last_words_length.load(); length > 0) {
    // Nobody is there who could be told that this cannot be written.
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, last_words.data(), length);
  }
  _exit(128 + signal_number);
}

sigset_t interruptions() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGHUP);
  return set;
}

}  // namespace

void handle_interruption() {
  struct sigaction action {};
  action.sa_handler = end_at_once;
  action.sa_mask = interruptions();
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A program started under nohup is meant to go on.
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

void say_when_interrupted(std::string_view text) {
  const InterruptionPause pause;
  last_words_length.store(0);
  const std::size_t length = std::min(text.size(), last_words.size());
  std::copy_n(text.begin(), length, last_words.begin());
  last_words_length.store(length);
}

InterruptionPause::InterruptionPause() {
  const sigset_t set = interruptions();
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &set, &before);
  already_paused_ = sigismember(&before, SIGINT) == 1;
}

InterruptionPause::~InterruptionPause() {
  if (already_paused_) return;
  const sigset_t set = interruptions();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

int register_file(const std::string& path) {
  if (path.size() >= kLongestPath) return -1;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    if (registered[i].taken.load()) continue;
    std::memcpy(registered[i].path.data(), path.c_str(), path.size() + 1);
    registered[i].taken.store(true);
    return static_cast<int>(i);
  }
  return -1;
}

void forget_file(int number) {
  if (number >= 0) registered[static_cast<std::size_t>(number)].taken.store(false);
}

void remove_empty_folders() {
  // The inner ones, which were made later, first. What is no folder stays.
  for (std::size_t i = kPlaces; i-- > 0;) {
    if (registered[i].taken.load() && rmdir(registered[i].path.data()) == 0)
      registered[i].taken.store(false);
  }
}

void register_child(int process) { child.store(process); }

}  // namespace slipbench::driver::base
