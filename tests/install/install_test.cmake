# SPDX-License-Identifier: Apache-2.0
# Installs the build tree into a fresh prefix, moves the prefix (a package must not remember where it was
# installed), then configures, builds and runs an outside project against it.
# Run with cmake -P and BINARY_DIR, CONFIG, GENERATOR, CXX_COMPILER, CXX_FLAGS, WITH_DRIVER, WITH_PYTHON, PYTHON, VERSION.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed (${code}): ${command}\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()

function(expect_file path)
  if(NOT EXISTS ${prefix}/${path})
    message(FATAL_ERROR "the installation has no ${path}")
  endif()
endfunction()

set(work ${BINARY_DIR}/install-test)
set(prefix ${work}/moved)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
run(${CMAKE_COMMAND} --install ${BINARY_DIR} --config ${CONFIG} --prefix ${work}/first)
file(RENAME ${work}/first ${prefix})

file(GLOB_RECURSE stray RELATIVE ${prefix} ${prefix}/include/*.cpp ${prefix}/include/*.txt)
if(stray)
  message(FATAL_ERROR "only headers belong under include: ${stray}")
endif()
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.hpp ${prefix}/include/*.h)
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^slipbench/((law|reference|driver)/.*hpp|c/.*h)$")
    message(FATAL_ERROR "only rooms belong under include/slipbench: ${header}")
  endif()
  file(STRINGS ${prefix}/include/${header} includes REGEX "^ *# *include *\"")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1" included "${line}")
    if(NOT included IN_LIST headers)
      message(FATAL_ERROR "${header} includes \"${included}\", which the installation does not have")
    endif()
  endforeach()
endforeach()
if(NOT headers MATCHES "slipbench/law/")
  message(FATAL_ERROR "no header of the law is installed")
endif()
expect_file(share/doc/slipbench/LICENSE)
expect_file(share/doc/slipbench/NOTICE)
expect_file(share/slipbench/cases)
expect_file(share/slipbench/plots)
expect_file(share/slipbench/reference/curves)
expect_file(share/slipbench/fortran/slip_law.f90)
expect_file(lib/slipbench/slipbench-fmu.so)
if(EXISTS ${BINARY_DIR}/slipbench-hdf5.so)
  expect_file(lib/slipbench/slipbench-hdf5.so)
endif()

file(READ ${CMAKE_CURRENT_LIST_DIR}/../../docs/guide/other-programs.md guide)
if(NOT guide MATCHES "```c\n([^`]*)```")
  message(FATAL_ERROR "the guide shows no C program")
endif()
file(WRITE ${work}/pad.c "${CMAKE_MATCH_1}")
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${work}/consumer -D PAD=${work}/pad.c
    -D FORTRAN=${prefix}/share/slipbench/fortran/slip_law.f90
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -D WITH_DRIVER=${WITH_DRIVER} -D WANTED_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${work}/consumer --config ${CONFIG})
run(${work}/consumer/consumer)
if(WITH_DRIVER)
  run(${work}/consumer/driver_consumer)
  run(${prefix}/bin/slipbench --version)
  if(NOT text MATCHES "${VERSION}")
    message(FATAL_ERROR "the installed program does not say version ${VERSION}: ${text}")
  endif()
  # Elsewhere than in PREFIX/bin the program takes nothing from its neighbours, nor by its name from where it was built.
  run(mktemp -d)
  string(STRIP "${text}" alone)
  file(COPY ${prefix}/bin/slipbench DESTINATION ${alone}/elsewhere)
  file(COPY ${prefix}/share/slipbench/plots DESTINATION ${alone}/share/slipbench)
  execute_process(COMMAND bash -c "exec -a \"$0\" \"$1\" plot \"$2\" -o \"$3\"" ${BINARY_DIR}/slipbench ${alone}/elsewhere/slipbench
                          ${prefix}/share/slipbench/cases/examples/hinge.yaml ${alone}
                  RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  file(REMOVE_RECURSE ${alone})
  if(code EQUAL 0 OR NOT text MATCHES "plot templates")
    message(FATAL_ERROR "a program without what is installed with it should miss its templates: ${text}")
  endif()
endif()

# The C program of the guide, by CMake above, by pkg-config here.
run(${work}/consumer/pad)
set(wanted "${text}")
if(NOT wanted MATCHES " 0.002 +6.0000 stick" OR NOT wanted MATCHES "slip\n")
  message(FATAL_ERROR "the C program of the guide prints ${wanted}")
endif()
find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB_RECURSE packages ${prefix}/lib/*.pc)
  list(GET packages 0 package)
  cmake_path(GET package PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  foreach(name IN ITEMS c law)
    run(${pkg_config} --cflags --libs slipbench-${name})
    separate_arguments(flags_of_${name} UNIX_COMMAND "${text}")
  endforeach()
  run(${CXX_COMPILER} -x c ${work}/pad.c -x none ${flags_of_c} -o ${work}/pad)
  cmake_path(GET folder PARENT_PATH libraries)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${work}/pad)
  if(NOT text STREQUAL wanted)
    message(FATAL_ERROR "by pkg-config the C program prints ${text}")
  endif()
  # The closed forms are headers only, beside those of the law.
  separate_arguments(flags UNIX_COMMAND "${CXX_FLAGS}")
  run(${CXX_COMPILER} -std=c++20 ${flags} ${CMAKE_CURRENT_LIST_DIR}/consumer/consumer.cpp ${flags_of_law} -o ${work}/by_pkg_config)
  run(${work}/by_pkg_config)
endif()
if(EXISTS ${work}/consumer/fortran_consumer)
  run(${work}/consumer/fortran_consumer)
endif()
if(WITH_PYTHON)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/lib/python3/dist-packages ${PYTHON} -c
      "print(__import__('slipbench').load('${prefix}/share/slipbench/cases/examples/hinge.yaml').run().passed)")
  if(NOT text MATCHES "True")
    message(FATAL_ERROR "the installed Python module says ${text}")
  endif()
endif()

# One that takes the source in includes the headers by the same names.
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${work}/inside
    -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
    -D SOURCE=${CMAKE_CURRENT_LIST_DIR}/../..)
run(${CMAKE_COMMAND} --build ${work}/inside --config ${CONFIG} --target compiled)

# An outside project without a compiler checks its cases: its own program finds what passes, what fails, and what is new.
if(WITH_DRIVER)
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/cases_consumer DESTINATION ${work})
  set(project ${work}/cases_consumer)
  # Names that a shell or the program could take for something else, and an editor's lock.
  foreach(name IN ITEMS "with space" "--quiet")
    file(COPY_FILE ${project}/joint/holds.yaml "${project}/joint/${name}.yaml")
  endforeach()
  file(CREATE_LINK "user@machine.1234" "${project}/joint/.#holds.yaml" SYMBOLIC)
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${project} -B ${work}/cases -D CMAKE_PREFIX_PATH=${prefix})
  execute_process(COMMAND ${CMAKE_CTEST_COMMAND} -C ${CONFIG} --output-on-failure
                  WORKING_DIRECTORY ${work}/cases RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  foreach(wanted IN ITEMS "7 tests failed out of 10" "joint/holds \\.+ +Passed" "joint/with space \\.+ +Passed"
          "joint/--quiet \\.+ +Passed"
          "joint/deep/misses \\.+\\*\\*\\*Failed" "FAIL  deep/misses   check 'limit'"
          "joint/broken \\.+\\*\\*\\*Failed" "broken.yaml:3:1: error"
          "set/holds \\.+\\*\\*\\*Failed" "set/deep/misses" "friction +=")
    if(code EQUAL 0 OR NOT text MATCHES "${wanted}")
      message(FATAL_ERROR "wanted '${wanted}' in what ctest says of the cases: ${text}")
    endif()
  endforeach()
  if(text MATCHES "never|hidden|\\.#")
    message(FATAL_ERROR "hidden cases and those in bad and hidden folders must not become tests: ${text}")
  endif()
  file(COPY_FILE ${project}/joint/holds.yaml ${project}/joint/new.yml)
  run(${CMAKE_COMMAND} --build ${work}/cases --config ${CONFIG})
  run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/cases -C ${CONFIG} -R "joint/new\\.yml")
  if(NOT text MATCHES "100% tests passed, 0 tests failed out of 1")
    message(FATAL_ERROR "a case that was added is not found: ${text}")
  endif()
  foreach(name IN ITEMS "semi\;colon" "q\"uote" "back\\slash" "gen$<x>")
    file(WRITE "${project}/joint/${name}.yaml" "")
    execute_process(COMMAND ${CMAKE_COMMAND} ${work}/cases
                    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE text)
    if(code EQUAL 0 OR NOT text MATCHES "CMake[ \n]+cannot[ \n]+pass[ \n]+it[ \n]+on")
      message(FATAL_ERROR "a name that CMake cannot pass on was not refused, ${name}: ${text}")
    endif()
    file(REMOVE "${project}/joint/${name}.yaml")
  endforeach()
endif()

# A component that is not there must be refused by name.
execute_process(
  COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${work}/refused
          -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} -D WANTED_VERSION=${VERSION}
          -D EXTRA_COMPONENT=no_such_room
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE text)
if(code EQUAL 0 OR NOT text MATCHES "no component 'no_such_room'")
  message(FATAL_ERROR "an unknown component was not refused by name: ${text}")
endif()
file(REMOVE_RECURSE ${work})
