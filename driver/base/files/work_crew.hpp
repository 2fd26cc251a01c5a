// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace slipbench::driver::base {

/// The most threads that a user may ask for.
inline constexpr int kMostThreads = 1024;

/// As many threads as the machine has cores, at least one.
unsigned core_count();

/// Calls `work` for the indices 0 .. count-1, in this order begun, by at most `threads` threads
/// (the caller's is one of them; fewer if the system gives no more), and returns when all are done.
/// Passes the first exception of `work` on to the caller, and begins no more after it.
void for_each_index(std::size_t count, unsigned threads,
                    const std::function<void(std::size_t)>& work);

}  // namespace slipbench::driver::base
