// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/work_crew.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <new>
#include <vector>

namespace slipbench::driver::base {

TEST_CASE("every index is worked on once, whatever the number of threads") {
  for (const unsigned threads : {0U, 1U, 3U, 50U}) {
    std::vector<std::atomic<int>> times(20);
    for_each_index(times.size(), threads, [&](std::size_t i) { ++times[i]; });
    for (const auto& one : times) CHECK(one == 1);
  }
}

TEST_CASE("what work throws in a thread comes to the caller") {
  for (const unsigned threads : {1U, 3U}) {
    std::atomic<int> begun{0};
    const auto run = [&] {
      for_each_index(1'000'000, threads, [&](std::size_t i) {
        ++begun;
        if (i >= 10) throw std::bad_alloc();
      });
    };
    CHECK_THROWS_AS(run(), std::bad_alloc);
    CHECK(begun < 1'000'000);
  }
}

}  // namespace slipbench::driver::base
