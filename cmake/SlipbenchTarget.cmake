# SPDX-License-Identifier: Apache-2.0
# What every target of the project has in common: the language, the warnings and the floating-point rules.
# Reproducibility comes first: no contraction to fused multiply-adds, no fast-math, no CPU-specific code.
function(slipbench_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
endfunction()
