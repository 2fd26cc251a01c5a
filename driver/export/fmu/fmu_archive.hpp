// SPDX-License-Identifier: Apache-2.0
// Files as one ZIP archive.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace slipbench::driver::exports {

/// A file of an archive: its path there, its content.
struct ArchivedFile {
  std::string path;
  std::string content;
};

/// Packs files into an archive whose bytes depend on nothing else: no times, no owners.
/// \return a sentence where it cannot be made
tl::expected<std::string, std::string> zip_archive(const std::vector<ArchivedFile>& files);

}  // namespace slipbench::driver::exports
