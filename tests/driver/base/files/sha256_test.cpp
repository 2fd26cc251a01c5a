// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/sha256.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

TEST_CASE("A file has the SHA-256 that NIST publishes for its bytes, one not there has none") {
  const TemporaryFolder folder;
  const auto hash_of = [&](const std::string& bytes) {
    return sha256_of_file(folder.write("data.csv", bytes)).value_or("");
  };
  CHECK(hash_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hash_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hash_of(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  const auto missing = sha256_of_file(folder.path() / "missing.csv");
  REQUIRE_FALSE(missing.has_value());
  CHECK(missing.error().kind == HistoryError::Kind::kEnvironment);
  CHECK(missing.error().message.find("cannot be read: No such file") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::base
