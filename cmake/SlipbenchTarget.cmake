# SPDX-License-Identifier: Apache-2.0
# What every target of the project has in common: the language, the warnings and the floating-point rules.
# Reproducibility comes first: no contraction to fused multiply-adds, no fast-math, no CPU-specific code.
function(slipbench_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF UNITY_BUILD OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
  # g++ 12 warns falsely on "literal" + std::string and string = "x" (GCC bugs 105651, 105329), in one of four forms.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  # In a shared library as in a program: nobody replaces a function of ours when it is loaded.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
  # Collecting garbage is a tenth of what g++ does; it waits until half a gigabyte is in use.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-heapsize=524288")
  endif()
  # Sanitizers keep g++ from seeing that a value is set (its manual says so): only false reports are left.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
endfunction()

# slipbench_build_together(TARGET BATCH): compiles BATCH sources at a time where CMAKE_UNITY_BUILD says so: a build from nothing
# reads each header less often, a change costs the few sources that go with it. Not for sources that are optimised for long.
function(slipbench_build_together target batch)
  set_target_properties(${target} PROPERTIES UNITY_BUILD "${CMAKE_UNITY_BUILD}" UNITY_BUILD_BATCH_SIZE ${batch})
endfunction()

# slipbench_build_quickly(TARGET): for code that no run spends its time in.
function(slipbench_build_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-fno-inline-functions-called-once>)
  endif()
endfunction()
