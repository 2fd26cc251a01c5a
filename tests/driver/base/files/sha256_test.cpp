// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/sha256.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

std::string hash_of(std::string_view text) {
  Sha256 hash;
  hash.add(text);
  return hash.hexadecimal();
}

TEST_CASE("SHA-256 of the examples that NIST publishes with FIPS 180-4") {
  CHECK(hash_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hash_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(hash_of("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmno"
                "ijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu") ==
        "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  CHECK(hash_of(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("The pieces of a message do not matter, wherever they are cut") {
  std::string text;
  for (int i = 0; i < 300; ++i) text += static_cast<char>(i % 251);
  const std::string whole = hash_of(text);
  for (const std::size_t piece : {1U, 7U, 55U, 56U, 63U, 64U, 65U, 128U, 299U}) {
    INFO(piece);
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      hash.add(std::string_view(text).substr(at, piece));
    }
    CHECK(hash.hexadecimal() == whole);
  }
}

TEST_CASE("A file has the hash of its bytes, one that is not there has none") {
  const TemporaryFolder folder;
  const std::string bytes = std::string(70000, 'x') + '\0' + "\r\n";
  const auto hash = sha256_of_file(folder.write("data.csv", bytes));
  REQUIRE(hash.has_value());
  CHECK(*hash == hash_of(bytes));
  const auto missing = sha256_of_file(folder.path() / "missing.csv");
  REQUIRE_FALSE(missing.has_value());
  CHECK(missing.error().kind == HistoryError::Kind::kEnvironment);
}

}  // namespace
}  // namespace slipbench::driver::base
