// SPDX-License-Identifier: Apache-2.0
#include "driver/results/regime_spans.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::results {
namespace {

TEST_CASE("spans that meet are one, stick is none, regimes are told apart") {
  RegimeSpans spans;
  spans.add(1, 0.0, 1.0);
  spans.add(2, 1.0, 2.0);
  spans.add(2, 2.0, 3.0);
  spans.add(0, 3.0, 4.0);
  spans.add(1, 4.0, 5.0);
  spans.add(2, 5.0, 5.0);
  spans.add(2, 6.0, 7.0);
  const auto& all = spans.spans();
  REQUIRE(all.size() == 3);
  CHECK(all[0].from == 1.0);
  CHECK(all[0].to == 3.0);
  CHECK(all[0].status == 2);
  CHECK(all[1].status == 0);
  CHECK(all[1].to == 4.0);
  CHECK(all[2].from == 6.0);
  for (const RegimeSpan& span : all) CHECK_FALSE(span.merged);
}

TEST_CASE("chatter needs no memory and stays where it was") {
  RegimeSpans spans(100);
  for (int i = 0; i < 100000; ++i) spans.add(i % 2 == 0 ? 2 : 1, i, i + 1.0);
  spans.add(1, 100000.0, 200000.0);
  spans.add(2, 200000.0, 200001.0);
  const auto& all = spans.spans();
  CHECK(all.size() <= 401);
  CHECK(all.front().from == 0.0);
  // The quiet half is not painted over.
  REQUIRE(all.size() >= 2);
  CHECK(all[all.size() - 2].to <= 100000.0);
  CHECK(all.back().from == 200000.0);
  // What covers stick, too, does not look like slip; the last one is slip and nothing else.
  for (const RegimeSpan& span : all) {
    CAPTURE(span.from, span.to);
    CHECK(span.merged == (span.to - span.from > 1.5));
  }
  CHECK(all.front().merged);
}

}  // namespace
}  // namespace slipbench::driver::results
