// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/hash.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <string_view>

namespace slipbench::driver::base {
namespace {

std::uint64_t whole(std::string_view text) {
  StreamHash hash;
  hash.add(text);
  return hash.value();
}

TEST_CASE("a hash does not depend on how its text is cut") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    std::string text(random() % 100, '\0');
    for (char& c : text) c = static_cast<char>(random());
    StreamHash hash;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t length = std::min<std::size_t>(text.size() - at, 1 + random() % 20);
      hash.add(std::string_view(text).substr(at, length));
      at += length;
    }
    CHECK(hash.value() == whole(text));
  }
}

TEST_CASE("texts that differ in a byte or their length have other hashes") {
  std::set<std::uint64_t> hashes;
  const std::string text(40, 'a');
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = 'b';
    hashes.insert(whole(other));
    hashes.insert(whole(std::string(i, '\0')));
  }
  CHECK(hashes.size() == 2 * text.size());
  // The words are the same on every machine: FNV-1a of 0x6867666564636261, then of 8.
  constexpr std::uint64_t kWord = 0x6867666564636261U;
  CHECK(whole("abcdefgh") == (((kHashBasis ^ kWord) * kHashPrime) ^ 8U) * kHashPrime);
}

}  // namespace
}  // namespace slipbench::driver::base
