# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` writes, and how an outside project finds it again.
#
#   include/slipbench/<room>/...     headers, for `#include <slipbench/law/update/return_mapping.hpp>`
#   lib/, lib/cmake/slipbench/       libraries; one targets file for each room, so that a room's consumer
#                                    needs the dependencies of that room only
#   lib/pkgconfig/                   the same for pkg-config: slipbench-law, slipbench-c, slipbench-c_yaml
#   lib/slipbench/                   what the program opens: HDF5, the library of functional mock-up units
#   lib/python3/dist-packages/       import slipbench
#   bin/slipbench                    the program
#   share/slipbench/                 cases, plot templates, reference curves; fortran: the module and its worked examples
#   share/doc/slipbench/             documentation, licence, notice
include(CMakePackageConfigHelpers)

# What is of no other component, `program`, `mpi` or `python`.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME dev)

set(SLIPBENCH_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/slipbench)

# slipbench_include_root(TARGET SCOPE): where an outside project that links TARGET finds <slipbench/ROOM/...>: in the
# installation, or, after add_subdirectory, in a folder of links to the rooms. Here headers are "ROOM/...".
function(slipbench_include_root target scope)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(NOT PROJECT_IS_TOP_LEVEL)
    target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
  endif()
endfunction()

# slipbench_install_library(TARGET COMPONENT): the library as slipbench::COMPONENT.
function(slipbench_install_library target component)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  if(NOT SLIPBENCH_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT slipbench-${component}-targets)
  install(EXPORT slipbench-${component}-targets NAMESPACE slipbench::
          DESTINATION ${SLIPBENCH_INSTALL_CMAKEDIR})
endfunction()

# slipbench_install_pkg_config(TARGET COMPONENT REQUIRES): slipbench-COMPONENT.pc, which finds the installation
# from where it stands itself.
function(slipbench_install_pkg_config target component requires)
  if(NOT SLIPBENCH_INSTALL)
    return()
  endif()
  file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  set(file ${PROJECT_BINARY_DIR}/slipbench-${component}.pc)
  file(WRITE ${file} "prefix=\${pcfiledir}/${up}
Name: slipbench-${component}
Description: ${PROJECT_DESCRIPTION}: ${component}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Cflags: -I\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}
Libs: -L\${prefix}/${CMAKE_INSTALL_LIBDIR} -l${target}
")
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# slipbench_install_room(TARGET ROOM [PATTERN]): the library as slipbench::ROOM, and the headers of the current folder.
function(slipbench_install_room target room)
  slipbench_install_library(${target} ${room})
  set(pattern "*.hpp")
  if(ARGC GREATER 2)
    set(pattern ${ARGV2})
  endif()
  if(NOT PROJECT_IS_TOP_LEVEL)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/slipbench)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/slipbench/${room} SYMBOLIC)
  endif()
  if(NOT SLIPBENCH_INSTALL)
    return()
  endif()
  set(headers "${PROJECT_BINARY_DIR}/installed-headers/${room}")
  install(CODE "include(\"${PROJECT_SOURCE_DIR}/cmake/SlipbenchHeaders.cmake\")
slipbench_write_headers(\"${CMAKE_CURRENT_SOURCE_DIR}\" \"${headers}\" \"${pattern}\")")
  install(DIRECTORY "${headers}" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slipbench)
endfunction()

# slipbench_install_program(TARGET COMPONENT): a program, for projects that find the package the target slipbench::TARGET.
function(slipbench_install_program target component)
  if(NOT SLIPBENCH_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT slipbench-program-targets RUNTIME COMPONENT ${component})
  install(EXPORT slipbench-program-targets NAMESPACE slipbench::
          DESTINATION ${SLIPBENCH_INSTALL_CMAKEDIR})
endfunction()

# slipbench_install_package(): what belongs to no single room.
function(slipbench_install_package)
  if(NOT SLIPBENCH_INSTALL)
    return()
  endif()
  configure_package_config_file(cmake/slipbench-config.cmake.in slipbench-config.cmake
                                INSTALL_DESTINATION ${SLIPBENCH_INSTALL_CMAKEDIR})
  # Before 1.0 a minor version may change an interface.
  write_basic_package_version_file(slipbench-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/slipbench-config.cmake
                ${PROJECT_BINARY_DIR}/slipbench-config-version.cmake
                ${PROJECT_SOURCE_DIR}/cmake/FindLibMD.cmake
                ${PROJECT_SOURCE_DIR}/cmake/FindMiniZip.cmake
                ${PROJECT_SOURCE_DIR}/cmake/FindUDUNITS2.cmake
                ${PROJECT_SOURCE_DIR}/cmake/SlipbenchAddCases.cmake
          DESTINATION ${SLIPBENCH_INSTALL_CMAKEDIR})
  # cases/bad are inputs of the tests.
  install(DIRECTORY cases plots DESTINATION ${CMAKE_INSTALL_DATADIR}/slipbench COMPONENT program PATTERN cases/bad EXCLUDE)
  install(DIRECTORY reference/curves DESTINATION ${CMAKE_INSTALL_DATADIR}/slipbench/reference COMPONENT program)
  # If scripts/wasm.sh has built it.
  install(FILES ${PROJECT_SOURCE_DIR}/build/wasm/live.html DESTINATION ${CMAKE_INSTALL_DATADIR}/slipbench COMPONENT program OPTIONAL)
  install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program PATTERN Doxyfile EXCLUDE)
  install(FILES README.md CHANGELOG.md LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
endfunction()
