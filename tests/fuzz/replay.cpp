// SPDX-License-Identifier: Apache-2.0
// replay TARGET FOLDER: gives a target every file of a folder. Exit code 2 if there is no such
// target, or no file; a target that breaks a promise ends the program.
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

int replay(const std::string& name, const std::filesystem::path& folder) {
  const auto target = targets().find(name);
  if (target == targets().end()) {
    std::cerr << "there is no target " << name << '\n';
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  std::sort(files.begin(), files.end());
  for (std::filesystem::path& file : files) file = std::filesystem::absolute(file);
  for (const std::filesystem::path& file : files) {
    std::cout << file.filename().string() << std::endl;  // the one at which it ends stands last
    std::ifstream in(file, std::ios::binary);
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
  if (count != 3) {
    std::cerr << "usage: fuzz_replay TARGET FOLDER\n";
    return 2;
  }
  return slipbench::fuzz::replay(words[1], words[2]);
}
