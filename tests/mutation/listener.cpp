// SPDX-License-Identifier: Apache-2.0
// Part of the test programs in the copy that rewrite.py makes: writes for each test case its name,
// its seconds and the sites that it reached into the file of SLIPBENCH_REACHED.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "law/base/mutant.hpp"

namespace {

struct ReachedListener : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    TestEventListenerBase::testCaseStarting(info);
    std::fill_n(slipbench::mutation::reached, slipbench::mutation::kMost, 0);
    start_ = std::clock();
  }
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    TestEventListenerBase::testCaseEnded(stats);
    const char* const path = std::getenv("SLIPBENCH_REACHED");
    if (!path) return;
    std::ofstream file(path, std::ios::app);
    file << stats.testInfo.name << '\t'
         << static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC << '\t';
    for (int i = 0; i < slipbench::mutation::kMost; ++i) {
      if (slipbench::mutation::reached[i]) file << i << ' ';
    }
    file << '\n';
  }

 private:
  std::clock_t start_ = 0;
};
CATCH_REGISTER_LISTENER(ReachedListener)

}  // namespace
