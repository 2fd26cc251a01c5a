// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/exact_integration.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {

void resolve_integration(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const IntegrationText& integration = text.integration;
  if (integration.method.sound) out.integration.method = integration.method.value;
  if (integration.tolerance.sound) {
    out.integration.tolerance = integration.tolerance.value;
    if (out.integration.method != cases::IntegrationMethod::kExact) {
      binder.error(*integration.tolerance.node, integration.tolerance.path,
                   "is the tolerance of exact integration; backward_euler has none",
                   "write method: exact, or leave it out");
    }
  }
  if (integration.snap_back.sound) out.integration.snap_back = integration.snap_back.value;
  if (out.integration.method != cases::IntegrationMethod::kExact) return;
  if (auto refusal = bench::refuse_exact(out)) {
    binder.error(*integration.method.node, integration.method.path, std::move(refusal->message),
                 std::move(refusal->hint));
  }
}

}  // namespace slipbench::driver::read
