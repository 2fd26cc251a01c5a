# SPDX-License-Identifier: Apache-2.0
# Finds libmd, message digests, which ships no CMake package of its own: imported target LibMD::libmd.
include(FindPackageHandleStandardArgs)
find_path(LIBMD_INCLUDE_DIR sha256.h)
find_library(LIBMD_LIBRARY md)
mark_as_advanced(LIBMD_INCLUDE_DIR LIBMD_LIBRARY)
find_package_handle_standard_args(LibMD REQUIRED_VARS LIBMD_LIBRARY LIBMD_INCLUDE_DIR)
if(LIBMD_FOUND AND NOT TARGET LibMD::libmd)
  add_library(LibMD::libmd UNKNOWN IMPORTED)
  set_target_properties(LibMD::libmd PROPERTIES
    IMPORTED_LOCATION "${LIBMD_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${LIBMD_INCLUDE_DIR}")
endif()
