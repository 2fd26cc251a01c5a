# SPDX-License-Identifier: Apache-2.0
# slipbench_add_cases(DIR [PREFIX prefix] [LABELS label...] [ARGUMENTS argument...])
#
# Makes a CTest test of every case (*.yaml) below DIR, but for those in folders named `bad` and in hidden ones; the
# test passes if all checks of the case do. It fails if a check fails as well as if the case cannot be run.
# Cases that are added later are found by the next build.
#
#   DIR        folder of cases, relative to the current source folder
#   PREFIX     what test names begin with, followed by '/'; default: the name of DIR. The rest is the case's path
#              below DIR without its extension: friction/belt_guide
#   LABELS     labels of the tests, for ctest -L
#   ARGUMENTS  passed on to `slipbench check`: --set mu=0.2
#
# Comes with find_package(slipbench COMPONENTS program); call enable_testing() too.
function(slipbench_add_cases dir)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PREFIX" "LABELS;ARGUMENTS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "slipbench_add_cases: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT TARGET slipbench::slipbench)
    message(FATAL_ERROR "slipbench_add_cases: the program slipbench::slipbench is not here; "
                        "find_package(slipbench COMPONENTS program) brings it")
  endif()
  cmake_path(ABSOLUTE_PATH dir BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE top)
  string(REGEX REPLACE "/$" "" top "${top}")
  if(NOT IS_DIRECTORY "${top}")
    message(FATAL_ERROR "slipbench_add_cases: there is no folder ${top}")
  endif()
  if(NOT DEFINED arg_PREFIX)
    cmake_path(GET top FILENAME arg_PREFIX)
  endif()

  file(GLOB_RECURSE cases CONFIGURE_DEPENDS LIST_DIRECTORIES FALSE RELATIVE "${top}" "${top}/*.yaml")
  list(FILTER cases EXCLUDE REGEX "(^|/)(bad|\\.[^/]*)/")
  if(NOT cases)
    message(FATAL_ERROR "slipbench_add_cases: there is no case (*.yaml) in ${top}")
  endif()
  foreach(case IN LISTS cases)
    string(REGEX REPLACE "\\.yaml$" "" name "${arg_PREFIX}/${case}")
    add_test(NAME "${name}" WORKING_DIRECTORY "${top}"
             COMMAND slipbench::slipbench check "${case}" ${arg_ARGUMENTS})
    if(arg_LABELS)
      set_tests_properties("${name}" PROPERTIES LABELS "${arg_LABELS}")
    endif()
  endforeach()
endfunction()
