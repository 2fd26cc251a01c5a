// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/inputs_read.hpp"

#include <sys/stat.h>

#include <mutex>
#include <set>
#include <utility>

namespace slipbench::driver::base {
namespace {

struct InputsRead {
  std::mutex mutex;
  bool remembered = false;
  std::set<std::pair<dev_t, ino_t>> files;
};

InputsRead& inputs_read() {
  static InputsRead inputs;
  return inputs;
}

}  // namespace

void remember_inputs() {
  InputsRead& inputs = inputs_read();
  const std::lock_guard lock(inputs.mutex);
  inputs.remembered = true;
}

void note_input(int descriptor) {
  InputsRead& inputs = inputs_read();
  const std::lock_guard lock(inputs.mutex);
  struct stat status {};
  if (!inputs.remembered || fstat(descriptor, &status) != 0) return;
  // One without a name is the program's own, and its number will be another file's.
  if (S_ISREG(status.st_mode) && status.st_nlink > 0) {
    inputs.files.emplace(status.st_dev, status.st_ino);
  }
}

bool was_read(const std::filesystem::path& file) {
  InputsRead& inputs = inputs_read();
  const std::lock_guard lock(inputs.mutex);
  struct stat status {};
  return stat(file.c_str(), &status) == 0 && inputs.files.contains({status.st_dev, status.st_ino});
}

}  // namespace slipbench::driver::base
