// SPDX-License-Identifier: Apache-2.0
// Reads a case with yaml-cpp's tree of nodes, as most programs do, and adds up all numbers in rows
// of the history's tables. Prints JSON.
#include <yaml-cpp/yaml.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const YAML::Node root = YAML::LoadFile(argv[1]);
  const YAML::Node step = root["history"][0];
  double sum = 0.0;
  long rows = 0;
  const auto add = [&](const YAML::Node& table) {
    for (const YAML::Node& row : table["rows"]) {
      for (const YAML::Node& number : row) sum += number.as<double>();
      ++rows;
    }
  };
  add(step["motion"]["CP2"]);
  add(step["motion"]["CP3"]);
  add(step["force"]["f1"]);
  add(step["temperature"]);
  std::printf("{\"rows\": %ld, \"sum\": %.17g}\n", rows, sum);
}
