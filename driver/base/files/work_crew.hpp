// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace slipbench::driver::base {

/// As many threads as the machine has cores, at least one.
unsigned core_count();

/// Calls `work` for the indices 0 .. count-1, in this order begun, by at most `threads` threads
/// (the caller's is one of them; fewer if the system gives no more), and returns when all are done.
/// Of work that throws, as where memory runs out, the first exception goes on to the caller, and no
/// more is begun.
void for_each_index(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work);

}  // namespace slipbench::driver::base
