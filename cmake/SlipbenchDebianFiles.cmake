# SPDX-License-Identifier: Apache-2.0
# Run by CPack before it makes the packages: what Debian wants in each beside the files of the installation. Manual pages are made
# of the --help of the commands, completions by the program.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  set(doc ${root}/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${doc})
  execute_process(COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/debian/files.sh ${component} ${root} ${doc}
                          ${CPACK_DEBIAN_${upper}_PACKAGE_NAME} ${CPACK_PACKAGE_VERSION}
                          "${CPACK_PACKAGE_CONTACT}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
