# SPDX-License-Identifier: Apache-2.0
# slipbench_write_headers(FROM TO PATTERN): the headers of the folder FROM as they are installed: what they include of the
# project is "slipbench/ROOM/..", not "ROOM/..". A header of TO that is the same already keeps its time.
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)  # whatever an install script has
function(slipbench_write_headers from to pattern)
  file(GLOB_RECURSE headers RELATIVE "${from}" "${from}/${pattern}")
  file(GLOB_RECURSE gone RELATIVE "${to}" "${to}/*")
  list(REMOVE_ITEM gone ${headers})
  foreach(header IN LISTS gone)
    file(REMOVE "${to}/${header}")
  endforeach()
  foreach(header IN LISTS headers)
    file(READ "${from}/${header}" text)
    string(REPLACE "\n#include \"" "\n#include \"slipbench/" text "${text}")
    cmake_path(GET header PARENT_PATH folder)
    file(MAKE_DIRECTORY "${to}/${folder}")
    file(WRITE "${to}.new" "${text}")
    file(COPY_FILE "${to}.new" "${to}/${header}" ONLY_IF_DIFFERENT)
  endforeach()
  file(REMOVE "${to}.new")
endfunction()
cmake_policy(POP)
