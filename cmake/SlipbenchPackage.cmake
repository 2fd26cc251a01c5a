# SPDX-License-Identifier: Apache-2.0
# Debian packages of an installation (scripts/package.sh): slipbench, slipbench-mpi, libslipbench-dev and python3-slipbench, a component
# each.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The slipbench authors <slipbench@users.noreply.github.com>")
set(CPACK_PACKAGE_VENDOR slipbench)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "test bench for connector friction")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program mpi dev python)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
if(NOT TARGET slipbench_python)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL python)
endif()
if(NOT TARGET slipbench-mpi)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL mpi)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME slipbench)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Takes one connector of a finite element model, prescribes histories of its
position, constraint forces, temperature and fields, integrates stick and
slip, and tells what happens and why. Speaks the friction of Abaqus
connectors and of Radioss contacts, and reads and writes their decks.")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME slipbench-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "slipbench (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_MPI_DESCRIPTION "Shares the samples of a sweep, and the starts and resamplings of a calibration,
out to the ranks of MPI.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libslipbench-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/triggers)
string(CONCAT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "slipbench (= ${PROJECT_VERSION}), libeigen3-dev, libfmt-dev, libexpected-dev, libgsl-dev, "
  "libyaml-cpp-dev, libmuparser-dev, libudunits2-dev, libmd-dev, libminizip-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Headers and libraries of the friction law, its closed forms and the driver for
C, C++ and Fortran, as CMake and pkg-config find them.")

math(EXPR slipbench_next_python "${Python_VERSION_MINOR} + 1")
set(slipbench_next_python "${Python_VERSION_MAJOR}.${slipbench_next_python}~")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-slipbench)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${slipbench_next_python}), python3-numpy, slipbench (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "The Python module: cases are loaded, changed, run, swept and calibrated, and
results are NumPy arrays.")

set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/SlipbenchDebianFiles.cmake)
include(CPack)

# What the packages need built, without tests.
add_custom_target(slipbench_parts DEPENDS slipbench slipbench_c slipbench_c_yaml slipbench_fmu)
foreach(part slipbench_python slipbench-hdf5 slipbench-mpi)
  if(TARGET ${part})
    add_dependencies(slipbench_parts ${part})
  endif()
endforeach()
