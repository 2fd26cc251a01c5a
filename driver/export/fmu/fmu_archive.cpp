// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/fmu_archive.hpp"

#include <minizip/zip.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace slipbench::driver::exports {
namespace {

/// Memory that a C library grows as a file.
struct GrowingFile {
  char* bytes = nullptr;
  std::size_t size = 0;
  GrowingFile() = default;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile() { std::free(bytes); }
};

}  // namespace

tl::expected<std::string, std::string> zip_archive(const std::vector<ArchivedFile>& files) {
  const auto fault = [] {
    return tl::unexpected<std::string>("the archive cannot be made: no memory is left");
  };
  GrowingFile file;
  zlib_filefunc_def functions;
  fill_fopen_filefunc(&functions);
  functions.opaque = &file;
  functions.zopen_file = [](voidpf opaque, const char*, int) -> voidpf {
    auto* const to = static_cast<GrowingFile*>(opaque);
    return open_memstream(&to->bytes, &to->size);
  };
  zipFile archive = zipOpen2("", APPEND_STATUS_CREATE, nullptr, &functions);
  if (archive == nullptr) return fault();
  bool good = true;
  for (const ArchivedFile& one : files) {
    zip_fileinfo info{};
    // The first day that an archive can tell; readable for all.
    info.tmz_date = {0, 0, 0, 1, 0, 1980};
    info.external_fa = 0100644UL << 16U;
    constexpr uLong kMadeByUnix = 3UL << 8U;
    good = good &&
           zipOpenNewFileInZip4(archive, one.path.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                Z_DEFLATED, Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                Z_DEFAULT_STRATEGY, nullptr, 0, kMadeByUnix, 0) == ZIP_OK &&
           zipWriteInFileInZip(archive, one.content.data(),
                               static_cast<unsigned int>(one.content.size())) == ZIP_OK &&
           zipCloseFileInZip(archive) == ZIP_OK;
  }
  good = zipClose(archive, nullptr) == ZIP_OK && good;
  if (!good) return fault();
  return std::string(file.bytes, file.size);
}

}  // namespace slipbench::driver::exports
