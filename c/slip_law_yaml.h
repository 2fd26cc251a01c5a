/* SPDX-License-Identifier: Apache-2.0
 *
 * The friction of a connector from the text of a case. It is in a library of its own,
 * slipbench_c_yaml, for it needs the reader and what that needs: yaml-cpp, fmt, muParser, UDUNITS.
 */
#ifndef SLIPBENCH_C_SLIP_LAW_YAML_H
#define SLIPBENCH_C_SLIP_LAW_YAML_H

#include "c/slip_law.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Returns the friction of a case, or NULL. Of the text `connector`, `friction`, `behavior`,
 * `parameters` and `units` are read; steps, output and checks need not be there. What a law alone
 * cannot hold is refused: dead zones, coefficients for each direction, belts. Files that it names
 * are looked for in `folder`; NULL: the current one. The error's message has "LINE:COLUMN: what is
 * wrong" of each fault, as far as there is room. */
SLIP_API slip_law* slip_law_create_from_yaml(const char* text, const char* folder,
                                             slip_error* error);

#ifdef __cplusplus
}
#endif

#endif
