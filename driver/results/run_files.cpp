// SPDX-License-Identifier: Apache-2.0
#include "driver/results/run_files.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

#include "driver/base/files/regular_file.hpp"
#include "driver/base/text/hash.hpp"

namespace slipbench::driver::results {
namespace {

std::string digits(const base::StreamHash& hash) { return fmt::format("{:016x}", hash.value()); }

/// Returns the hash of a file's bytes as they were written: without the mark that some editors put
/// before a text, and the ends of lines that others give it. Empty if it cannot be read.
std::string hash_of(const std::filesystem::path& file) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  constexpr std::size_t kPiece = std::size_t{1} << 16U;
  auto in = base::open_regular(file);
  if (!in) return {};
  base::StreamHash hash;
  std::string piece(kPiece, '\0');
  for (bool first = true; in->read(piece.data(), kPiece), in->gcount() > 0; first = false) {
    piece.resize(static_cast<std::size_t>(in->gcount()));
    if (first && piece.starts_with(kMark)) piece.erase(0, kMark.size());
    std::erase(piece, '\r');
    hash.add(piece);
    piece.resize(kPiece);
  }
  return digits(hash);
}

}  // namespace

base::json::Value list_of_files(std::span<const base::OutputFile* const> files) {
  base::json::Value list = base::json::Array{};
  for (const base::OutputFile* file : files) {
    base::json::Value one;
    one["name"] = file->target().filename().string();
    // Other formats are not appended to alone.
    if (file->target().extension() == ".csv") one["hash"] = digits(file->hash());
    list.push_back(one);
  }
  return list;
}

bool is_listed(const yaml::Node& json, const std::filesystem::path& file) {
  const auto list = json.find("files");
  if (!list) return true;
  const std::string own = hash_of(file);
  for (const yaml::Node one : list->items()) {
    const auto hash = one.find("hash");
    if (hash && hash->is_scalar() && hash->text() == own) return true;
  }
  return false;
}

}  // namespace slipbench::driver::results
