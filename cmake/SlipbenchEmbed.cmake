# SPDX-License-Identifier: Apache-2.0
# Text files as part of a library: the file itself stays what is edited, the build makes C++ of it.
#
# slipbench_embed(TARGET NAMESPACE NAME=FILE...): adds to TARGET one source with a function for each file,
#   std::string_view NAMESPACE::NAME();
# that is made again when a file changes. Declare the functions in a header of your own.
if(CMAKE_SCRIPT_MODE_FILE)
  # Run by the build: -D OUTPUT=.. -D NAMESPACE=.. -D "FILES=NAME=FILE|NAME=FILE".
  string(REPLACE "|" ";" files "${FILES}")
  set(code "// Made by the build from text files; edit those.\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n")
  foreach(entry IN LISTS files)
    string(REGEX MATCH "^([a-z_]+)=(.+)$" matched "${entry}")
    if(NOT matched)
      message(FATAL_ERROR "wanted NAME=FILE, found '${entry}'")
    endif()
    set(name ${CMAKE_MATCH_1})
    file(READ "${CMAKE_MATCH_2}" text HEX)
    # Numbers, not a literal in quotes: any byte, any length, and nothing to escape.
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${text}")
    string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
    string(APPEND code "namespace {\nconstexpr unsigned char k_${name}[] = {\n${bytes}0};\n}\n")
    string(APPEND code "std::string_view ${name}() { return {reinterpret_cast<const char*>(k_${name}), sizeof k_${name} - 1}; }\n")
  endforeach()
  string(APPEND code "}  // namespace ${NAMESPACE}\n")
  file(WRITE "${OUTPUT}" "${code}")
  return()
endif()

function(slipbench_embed target namespace)
  set(files)
  set(entries)
  foreach(entry IN LISTS ARGN)
    string(REGEX MATCH "^([a-z_]+)=(.+)$" matched "${entry}")
    get_filename_component(file "${CMAKE_MATCH_2}" ABSOLUTE)
    list(APPEND files "${file}")
    list(APPEND entries "${CMAKE_MATCH_1}=${file}")
  endforeach()
  list(JOIN entries "|" entries)
  set(script "${PROJECT_SOURCE_DIR}/cmake/SlipbenchEmbed.cmake")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} -D "OUTPUT=${output}" -D "NAMESPACE=${namespace}" -D "FILES=${entries}" -P "${script}"
    DEPENDS ${files} "${script}"
    COMMENT "Embedding text files into ${target}"
    VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()

# slipbench_find_chart_js(): sets SLIPBENCH_CHART_JS to the chart library that report pages carry along.
function(slipbench_find_chart_js)
  find_file(SLIPBENCH_CHART_JS chart.min.js
            PATHS /usr/share/javascript/chart.js /usr/share/javascript/Chart.js
            DOC "Chart.js 3, minified, for report pages")
  if(NOT SLIPBENCH_CHART_JS)
    message(FATAL_ERROR "Chart.js 3 not found: install the Debian package libjs-chart.js, "
                        "or set SLIPBENCH_CHART_JS to its chart.min.js")
  endif()
  # Its first lines name version and licence; they go into every page.
  file(STRINGS "${SLIPBENCH_CHART_JS}" head LIMIT_COUNT 6)
  if(NOT head MATCHES "Chart\\.js v3\\." OR NOT head MATCHES "MIT License")
    message(FATAL_ERROR "${SLIPBENCH_CHART_JS} is not Chart.js 3 with its licence: install the Debian package "
                        "libjs-chart.js, or set SLIPBENCH_CHART_JS to the chart.min.js of a version 3")
  endif()
endfunction()
