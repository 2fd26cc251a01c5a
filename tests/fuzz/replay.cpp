// SPDX-License-Identifier: Apache-2.0
// replay TARGET FILE|FOLDER..: gives a target the files, and every file of the folders. Exit code 2
// if there is no such target, no file, or one that cannot be read; a target that breaks a promise
// ends the program.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {
namespace {

std::map<std::string_view, Target>& targets() {
  static std::map<std::string_view, Target> all;
  return all;
}

/// Feeds a target with files, and with all files of folders, the inputs of each in the order of
/// their names.
int replay(const std::string& name, const std::vector<std::filesystem::path>& places) {
  const auto target = targets().find(name);
  if (target == targets().end()) {
    std::cerr << "there is no target " << name << '\n';
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& place : places) {
    if (!std::filesystem::is_directory(place)) {
      files.push_back(place);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(place)) files.push_back(entry);
  }
  std::sort(files.begin(), files.end());
  for (std::filesystem::path& file : files) file = std::filesystem::absolute(file);
  for (const std::filesystem::path& file : files) {
    std::cout << file.filename().string() << std::endl;  // the one at which it ends stands last
    std::ifstream in(file, std::ios::binary);
    if (!in) {
      std::cerr << "it cannot be read\n";
      return 2;
    }
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    target->second(bytes);
  }
  std::cout << files.size() << " inputs of " << name << '\n';
  return files.empty() ? 2 : 0;
}

}  // namespace

Registered::Registered(std::string_view name, Target target) { targets().emplace(name, target); }

}  // namespace slipbench::fuzz

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "usage: fuzz_replay TARGET FILE|FOLDER..\n";
    return 2;
  }
  return slipbench::fuzz::replay(words[1], {words + 2, words + count});
}
