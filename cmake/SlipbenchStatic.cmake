# SPDX-License-Identifier: Apache-2.0
# slipbench_static: the objects of the program once more, linked so that it runs on any Linux of its processor, whatever is installed
# there; static/slipbench.map tells what went into it. Debian has no static library of muParser, so its sources are compiled, which
# scripts/package.sh gets; of {fmt} it has the headers, which do. Not built with `all`.
foreach(library yaml-cpp udunits2 expat gsl gslcblas md minizip z)
  find_library(SLIPBENCH_STATIC_${library} NAMES lib${library}.a REQUIRED)
  list(APPEND static_libraries ${SLIPBENCH_STATIC_${library}})
endforeach()
file(GLOB muparser_sources ${SLIPBENCH_MUPARSER_SOURCE}/src/muParser*.cpp)
list(FILTER muparser_sources EXCLUDE REGEX "(DLL|Int|Test)\\.cpp$")
add_library(slipbench_muparser STATIC EXCLUDE_FROM_ALL ${muparser_sources})
target_include_directories(slipbench_muparser PRIVATE ${SLIPBENCH_MUPARSER_SOURCE}/include)
target_compile_features(slipbench_muparser PRIVATE cxx_std_17)
set_target_properties(slipbench_muparser PROPERTIES UNITY_BUILD OFF)

set(static_sources ${PROJECT_SOURCE_DIR}/cmake/static/fmt.cpp ${PROJECT_SOURCE_DIR}/cmake/static/no_plugins.cpp)
add_executable(slipbench_static EXCLUDE_FROM_ALL ${static_sources} $<TARGET_OBJECTS:slipbench>)
slipbench_target(slipbench_static)
target_link_options(slipbench_static PRIVATE -static -Wl,--gc-sections,--wrap=dlopen,--wrap=dlsym,--wrap=dlerror -Wl,-Map=${PROJECT_BINARY_DIR}/static/slipbench.map)
# The files alone: as targets they would bring the shared libraries that they are used with elsewhere.
target_link_libraries(slipbench_static PRIVATE $<TARGET_FILE:slipbench_driver> $<TARGET_FILE:slipbench_law> slipbench_muparser
                                               ${static_libraries})
add_dependencies(slipbench_static slipbench_driver slipbench_law)
set_target_properties(slipbench_static PROPERTIES OUTPUT_NAME slipbench RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/static)
