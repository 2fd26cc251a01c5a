// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/sha256.hpp"

#include <sha256.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace slipbench::driver::base {

tl::expected<std::string, HistoryError> sha256_of_file(const std::filesystem::path& file) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  if (SHA256File(file.c_str(), digits.data()) == nullptr) {
    return environment_error(file.string(),
                             "cannot be read: " + std::generic_category().message(errno));
  }
  return digits.data();
}

std::string sha256_of(std::string_view text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digits.data());
  return digits.data();
}

}  // namespace slipbench::driver::base
