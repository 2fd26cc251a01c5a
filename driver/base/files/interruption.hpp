// SPDX-License-Identifier: Apache-2.0
// Files that must not be left behind when the user interrupts a run.
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// From now on SIGINT, SIGTERM and SIGHUP (unless it was ignored) remove all registered files, end
/// all registered processes and end this program at once, with exit code 130, 143 or 129; a closed
/// pipe, or a file beyond the limit of its size, is an error of the write instead of a signal.
void handle_interruption();

/// Sets what an interruption says on standard error before it ends the program, at most 2000 bytes;
/// an empty text takes it back.
void say_when_interrupted(std::string_view text);

/// Holds interruption back while it exists; one that came meanwhile acts at its end.
class InterruptionPause {
 public:
  InterruptionPause();
  ~InterruptionPause();
  InterruptionPause(const InterruptionPause&) = delete;
  InterruptionPause& operator=(const InterruptionPause&) = delete;

 private:
  bool already_paused_ = false;
};

/// A file that an interruption removes, or a folder if it is empty, until `forget_file`. Returns
/// its number, or -1 when all places are taken or the path is too long: such a file may be left
/// behind, under its temporary name. Call it, like forget_file, under an InterruptionPause.
int register_file(const std::string& path);
void forget_file(int number);

/// Removes the registered folders that are empty, and forgets them.
void remove_empty_folders();

/// The child process an interruption ends; 0 for none. There is one at a time.
void register_child(int process);

}  // namespace slipbench::driver::base
