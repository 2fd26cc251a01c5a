// SPDX-License-Identifier: Apache-2.0
// Inputs as a fuzzer makes them: a target takes any bytes and must neither crash nor break a
// promise. Built for libFuzzer each is a program of its own; else one program replays files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace slipbench::fuzz {

/// Tries one input.
using Target = void (*)(std::string_view input);

/// Adds a target to those that replay.cpp knows.
struct Registered {
  Registered(std::string_view name, Target target);
};

/// Ends the program at a promise that is broken.
inline void want(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace slipbench::fuzz

#ifdef SLIPBENCH_LIBFUZZER
// The scanner of UDUNITS-2 loses a word of a unit that it cannot read.
#define SLIPBENCH_FUZZ_TARGET(name)                                                   \
  extern "C" const char* __lsan_default_suppressions() { return "leak:utlex"; }       \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    slipbench::fuzz::name({reinterpret_cast<const char*>(data), size});               \
    return 0;                                                                         \
  }
#else
#define SLIPBENCH_FUZZ_TARGET(name) \
  static const slipbench::fuzz::Registered registered_##name(#name, slipbench::fuzz::name);
#endif
