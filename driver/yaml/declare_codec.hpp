// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/yaml/binding.hpp"

/// Declares, in the namespace of Codec, that a Type is read by functions of its own: one list of
/// them for all types, defined in a source.
#define SLIPBENCH_DECLARE_CODEC(Type)                                                         \
  template <>                                                                                 \
  struct Codec<Type> {                                                                        \
    static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info, \
                     Type& out); /* NOLINT: a type has no parentheses */                      \
    static Json schema(const KeyInfo& info);                                                  \
    static std::string wanted(const KeyInfo& info);                                           \
    static void rows(const std::string& path, std::vector<KeyRow>& rows);                     \
  }
