// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::driver::base {

/// Letters and digits of ASCII, whatever the locale.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace slipbench::driver::base
