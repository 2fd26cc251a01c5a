# SPDX-License-Identifier: Apache-2.0
# slipbench_add_cases(DIR [PREFIX prefix] [LABELS label...] [ARGUMENTS argument...])
#
# Makes a CTest test of every case (*.yaml, *.yml) below DIR, but for hidden ones and those in folders that are hidden or named
# `bad`; the test passes if all checks of the case do. It fails if a check fails as well as if the case cannot be run.
# Cases that are added later are found by the next build. A file name may hold blanks, but no semicolon, quote,
# backslash, line feed or `$<`: CMake has no way to pass them on, which is an error that says so.
# A name with a blank sets policy CMP0110 to NEW for the current folder.
#
#   DIR        folder of cases, relative to the current source folder
#   PREFIX     what test names begin with, followed by '/'; default: the name of DIR. The rest is the case's path
#              below DIR without .yaml: friction/belt_guide
#   LABELS     labels of the tests, for ctest -L
#   ARGUMENTS  passed on to `slipbench check`: --set mu=0.2
#
# Comes with find_package(slipbench COMPONENTS program); call enable_testing() too.
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)  # whatever the project has
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

  file(GLOB_RECURSE cases CONFIGURE_DEPENDS LIST_DIRECTORIES FALSE RELATIVE "${top}"
       "${top}/*.yaml" "${top}/*.yml")
  list(FILTER cases EXCLUDE REGEX "(^|/)(bad/|\\.)")
  if(NOT cases)
    message(FATAL_ERROR "slipbench_add_cases: there is no case (*.yaml, *.yml) in ${top}")
  endif()
  foreach(case IN LISTS cases)
    # A semicolon makes two names of one, neither of which is there; a link to nowhere is there.
    if(NOT EXISTS "${top}/${case}" AND NOT IS_SYMLINK "${top}/${case}")
      message(FATAL_ERROR "slipbench_add_cases: in ${top} the name of a case holds a semicolon, around '${case}'; "
                          "CMake cannot pass it on, rename the file")
    elseif(case MATCHES "[\"\\\n]|\\$<")
      message(FATAL_ERROR "slipbench_add_cases: the name of the case ${top}/${case} holds a quote, a backslash, a line "
                          "feed or '$<'; CMake cannot pass it on, rename the file")
    endif()
    if(case MATCHES "[^A-Za-z0-9_./+-]")
      # The names of tests are written when the folder is left, by the policies that it has then.
      cmake_policy(SET CMP0110 NEW)
    endif()
    string(REGEX REPLACE "\\.yaml$" "" name "${arg_PREFIX}/${case}")
    add_test(NAME "${name}" WORKING_DIRECTORY "${top}"
             COMMAND slipbench::slipbench check "./${case}" ${arg_ARGUMENTS})
    if(arg_LABELS)
      set_tests_properties("${name}" PROPERTIES LABELS "${arg_LABELS}")
    endif()
  endforeach()
endfunction()
cmake_policy(POP)
