// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/curve_library.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "driver/base/files/data_path.hpp"

namespace slipbench::driver::check {
namespace {

namespace fs = std::filesystem;

/// Returns where the curves are: beside an installed program, or in the source folder.
std::optional<fs::path> curve_folder() {
  return base::shipped_path(fs::path("reference") / "curves");
}

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::size_t text = line.find_first_not_of("# ");
  return text == std::string::npos ? std::string() : line.substr(text);
}

}  // namespace

std::vector<ShippedCurve> shipped_curves() {
  std::vector<ShippedCurve> curves;
  const auto folder = curve_folder();
  if (!folder) return curves;
  std::error_code error;
  for (fs::directory_iterator it(*folder, error); !error && it != fs::directory_iterator();
       it.increment(error)) {
    if (it->path().extension() != ".csv") continue;
    const fs::path description = fs::path(it->path()).replace_extension(".md");
    curves.push_back({it->path().stem().string(), first_line(description), it->path()});
  }
  std::sort(curves.begin(), curves.end(),
            [](const ShippedCurve& a, const ShippedCurve& b) { return a.name < b.name; });
  return curves;
}

bool is_curve_name(std::string_view text) {
  return !text.empty() && text.find_first_of("/.") == std::string_view::npos;
}

std::optional<fs::path> find_shipped_curve(std::string_view name) {
  const auto folder = curve_folder();
  if (!folder || !is_curve_name(name)) return std::nullopt;
  std::error_code error;
  fs::path file = *folder / (std::string(name) + ".csv");
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return file;
}

std::string curve_description(std::string_view name) {
  const auto file = find_shipped_curve(name);
  if (!file) return {};
  std::ifstream stream(fs::path(*file).replace_extension(".md"));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace slipbench::driver::check
