// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/fuzz_files.hpp"

#include <stdlib.h>

#include <fstream>
#include <set>

#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::fuzz {
namespace fs = std::filesystem;

namespace {

/// Folder that is removed when the program ends in order.
struct OwnFolder {
  OwnFolder() {
    const fs::path memory = "/dev/shm";
    std::error_code error;
    const fs::path place = fs::is_directory(memory, error) ? memory : fs::temp_directory_path();
    std::string name = (place / "slipbench-fuzz-XXXXXX").string();
    want(::mkdtemp(name.data()) != nullptr, "a folder for files can be made");
    path = name;
    fs::current_path(path);
  }
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  fs::path path;
};

}  // namespace

const fs::path& own_folder() {
  static const OwnFolder folder;
  return folder.path;
}

fs::path own_file(std::string_view name, std::string_view bytes) {
  fs::path file = own_folder() / name;
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

void copy_of_sources(std::string_view folder) {
  static std::set<std::string, std::less<>> copied;
  if (!copied.emplace(folder).second) return;
  for (const auto& entry : fs::directory_iterator(fs::path(test::source_dir()) / folder)) {
    if (entry.is_regular_file()) {
      fs::copy_file(entry, own_folder() / entry.path().filename(),
                    fs::copy_options::overwrite_existing);
    }
  }
}

}  // namespace slipbench::fuzz
