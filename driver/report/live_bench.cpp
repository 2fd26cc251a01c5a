// SPDX-License-Identifier: Apache-2.0
#include "driver/report/live_bench.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "driver/base/files/data_path.hpp"

namespace slipbench::driver::report {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

base::json::Value file_texts(const std::string& case_path, std::span<const std::string> files) {
  base::json::Value texts = base::json::Object{};
  const fs::path folder = fs::absolute(case_path).lexically_normal().parent_path();
  for (const std::string& file : files) {
    const std::string name = fs::absolute(file).lexically_normal().lexically_relative(folder);
    if (!name.starts_with("..")) texts[name] = content_of(file);
  }
  return texts;
}

tl::expected<LiveBench, std::string> read_live_bench() {
  // As it is installed, and as scripts/wasm.sh leaves it in a source tree.
  for (const char* name : {"live.html", "build/wasm/live.html"}) {
    const auto file = base::shipped_path(name);
    if (file) return LiveBench{content_of(*file)};
  }
  return tl::unexpected(std::string(
      "the bench for pages is not there; scripts/wasm.sh of the source tree builds it"));
}

}  // namespace slipbench::driver::report
