// SPDX-License-Identifier: Apache-2.0
// SHA-256 (FIPS 180-4): the fingerprint by which a calibration names its data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// Takes a message piece by piece.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The hash of all that was added, 64 hexadecimal digits in lower case; ends the message.
  std::string hexadecimal();

 private:
  void compress(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::size_t filled_ = 0;    ///< bytes of `block_`
  std::uint64_t length_ = 0;  ///< of the message, in bytes
};

/// The hash of a file's bytes. Errors of the kind kEnvironment: it cannot be read.
tl::expected<std::string, HistoryError> sha256_of_file(const std::filesystem::path& file);

}  // namespace slipbench::driver::base
