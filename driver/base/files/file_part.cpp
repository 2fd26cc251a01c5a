// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/file_part.hpp"

namespace slipbench::driver::base {

std::string file_part(std::string_view name) {
  std::string part;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte >= 0x80 || (byte >= '0' && byte <= '9') ||
                       (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z') || c == '_' ||
                       c == '.' || c == '-' || c == '+';
    part += plain ? c : '-';
  }
  return part.empty() || part.front() == '.' ? "-" + part : part;
}

}  // namespace slipbench::driver::base
