# SPDX-License-Identifier: Apache-2.0
# -D LIBRARY=PROGRAM -D PAGE=PROGRAM: fails where the two print something else about a unit.
execute_process(COMMAND ${LIBRARY} OUTPUT_VARIABLE wanted COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PAGE} OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY)
string(LENGTH "${wanted}" length)
if(length LESS 10000)
  message(FATAL_ERROR "hardly a unit is known: ${wanted}")
endif()
if(NOT found STREQUAL wanted)
  message(FATAL_ERROR "wanted\n${wanted}\nfound\n${found}")
endif()
