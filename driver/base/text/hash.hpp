// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace slipbench::driver::base {

inline constexpr std::uint64_t kHashBasis = 14695981039346656037U;
inline constexpr std::uint64_t kHashPrime = 1099511628211U;

/// FNV-1a, 64 bit: the same on every machine.
inline std::uint64_t hash(std::string_view text) {
  std::uint64_t h = kHashBasis;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * kHashPrime;
  return h;
}

/// The hash of a text that comes in pieces, however it is cut: FNV-1a over its words of eight
/// bytes, the lowest first and the last one filled up with zeros, and over its length. The same on
/// every machine.
class StreamHash {
 public:
  void add(std::string_view text) {
    std::size_t i = 0;
    for (; i < text.size() && length_ % kWord != 0; ++i) add_byte(text[i]);
    for (; i + kWord <= text.size(); i += kWord) {
      std::uint64_t word = 0;
      for (std::size_t k = 0; k < kWord; ++k) word |= byte(text[i + k]) << (8U * k);
      hash_ = (hash_ ^ word) * kHashPrime;
      length_ += kWord;
    }
    for (; i < text.size(); ++i) add_byte(text[i]);
  }

  std::uint64_t value() const {
    const std::uint64_t all = length_ % kWord == 0 ? hash_ : (hash_ ^ pending_) * kHashPrime;
    return (all ^ length_) * kHashPrime;
  }

 private:
  static constexpr std::size_t kWord = 8;
  static std::uint64_t byte(char c) { return static_cast<unsigned char>(c); }

  void add_byte(char c) {
    pending_ |= byte(c) << (8U * (length_ % kWord));
    if (++length_ % kWord != 0) return;
    hash_ = (hash_ ^ pending_) * kHashPrime;
    pending_ = 0;
  }

  std::uint64_t hash_ = kHashBasis;
  std::uint64_t pending_ = 0;  ///< the word that is not full yet
  std::uint64_t length_ = 0;
};

}  // namespace slipbench::driver::base
