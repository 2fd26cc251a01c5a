# SPDX-License-Identifier: Apache-2.0
# Finds minizip, archives, which ships no CMake package of its own in Debian: imported target MiniZip::minizip.
include(FindPackageHandleStandardArgs)
find_path(MINIZIP_INCLUDE_DIR minizip/zip.h)
find_library(MINIZIP_LIBRARY minizip)
find_library(MINIZIP_ZLIB_LIBRARY z)
mark_as_advanced(MINIZIP_INCLUDE_DIR MINIZIP_LIBRARY MINIZIP_ZLIB_LIBRARY)
find_package_handle_standard_args(MiniZip REQUIRED_VARS MINIZIP_LIBRARY MINIZIP_ZLIB_LIBRARY MINIZIP_INCLUDE_DIR)
if(MiniZip_FOUND AND NOT TARGET MiniZip::minizip)
  add_library(MiniZip::minizip UNKNOWN IMPORTED)
  set_target_properties(MiniZip::minizip PROPERTIES IMPORTED_LOCATION "${MINIZIP_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${MINIZIP_INCLUDE_DIR}" INTERFACE_LINK_LIBRARIES "${MINIZIP_ZLIB_LIBRARY}")
endif()
