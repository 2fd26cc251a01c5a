/* SPDX-License-Identifier: Apache-2.0
 *
 * The friction law of slipbench for C and all that can call C. One slip_law stands for the friction
 * of one connector; it never changes, so that threads may share it. States are plain arrays of
 * doubles that the caller keeps, copies and saves. After a slip_law is created nothing allocates.
 * No function throws or writes to a stream; there are no globals.
 *
 * Units: those of the caller, as long as they are one consistent system (mm, N, s: mm/s, N mm).
 * Angles are radians. Components count from 0: the translations 1..3, then the rotations 1..3 of
 * the connector. Matrices are row after row.
 *
 *   slip_error error;
 *   slip_number mu[] = {{"mu", 0.2}};
 *   slip_definition pad = {.size = sizeof pad, .connection = "SLOT", .law = "constant", .numbers =
 * mu, .number_count = 1, .elastic_slip = 1e-3}; slip_law* law = slip_law_create(&pad, 1, &error);
 *   if (law == NULL) puts(error.message);
 */
#ifndef SLIPBENCH_C_SLIP_LAW_H
#define SLIPBENCH_C_SLIP_LAW_H

#include <stddef.h>

#if defined(__GNUC__)
#define SLIP_API __attribute__((visibility("default")))
#else
#define SLIP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Version of this interface. A program that was compiled with another one asks slip_law_version()
 * at run time. */
#define SLIP_LAW_VERSION 1

enum {
  SLIP_COMPONENTS = 6,
  SLIP_FIELDS = 16,       /**< the most field variables of a table */
  SLIP_DEFINITIONS = 16,  /**< the most definitions of a connector */
  SLIP_STATE_NUMBERS = 15 /**< of one definition: see slip_law_state_size() */
};

/** Results of a call. */
enum slip_status {
  SLIP_OK = 0,
  SLIP_BAD_DEFINITION = 1, /**< numbers or a text that describe no friction */
  SLIP_BAD_ARGUMENT = 2,   /**< an argument that no connector can have */
  SLIP_NOT_FINITE = 3,     /**< an update whose numbers are not finite */
  SLIP_NO_SOLUTION = 4,    /**< an update without a return to the limit surface */
  SLIP_NO_MEMORY = 5
};

/** Regimes, as in slip_result and in the state. */
enum slip_regime { SLIP_OPEN = 0, SLIP_STICK = 1, SLIP_SLIP = 2 };

/** What went wrong, in the caller's memory; every function that takes one accepts NULL. */
typedef struct slip_error {
  int status;        /**< enum slip_status */
  char message[508]; /**< one sentence or, of a YAML text, one line for each fault; "" if all went
                        well */
} slip_error;

/** Friction of one connector. */
typedef struct slip_law slip_law;

/** A parameter: its key as in a case file (`slipbench describe LAW`), its value. */
typedef struct slip_number {
  const char* key;
  double value;
} slip_number;

/** One friction definition in numbers, without tables: those come from slip_law_create_from_yaml()
 * or unpack(). */
typedef struct slip_definition {
  size_t size;                 /**< sizeof(slip_definition) */
  const char* connection;      /**< type with predefined friction: "SLOT", "HINGE", ..; NULL:
                                  user-defined friction */
  const slip_number* geometry; /**< of the type: R_p, .. [L], internal_contact_force [F] */
  size_t geometry_count;
  const char* law; /**< key of the coefficient law: "constant", "exponential_decay", .. */
  const slip_number* numbers;
  size_t number_count;
  /** User-defined: R_i of the components that slip together, P = sqrt(sum (f_i/R_i)^2); 0 of those
   * that do not. */
  double slip_scale[6];
  /** User-defined: weights of the contact force F_C = sqrt(sum (w_i f_i)^2). */
  double contact_weight[6];
  double internal_contact_force; /**< user-defined: F_int [F] */
  double elastic_slip;           /**< allowable elastic slip g_c [L], [1]; or else */
  double stick_stiffness;        /**< kappa [F/L]; exactly one of the two is above 0 */
  double force_limit;            /**< f_max [F]; 0: none */
} slip_definition;

/** An increment of the connector. */
typedef struct slip_increment {
  double duration; /**< dt [T], finite and not negative; without one, 0, all rates are 0 */
  double begin[6]; /**< positions CP when it begins [L], [1] */
  double end[6];   /**< and ends */
  double
      reference[6];   /**< constitutive reference positions, for tables over CCU = CP - reference */
  double force[6];    /**< constraint forces and moments at its end [F], [F L] */
  double temperature; /**< at its end */
  const double* fields; /**< at its end, field_count of them; those that are missing are 0 */
  size_t field_count;
} slip_increment;

/** One definition at the end of an increment. */
typedef struct slip_result {
  double limit;          /**< F_lim [F] */
  double normal_force;   /**< F_N [F] */
  double mu;             /**< coefficient used [1] */
  double slip_increment; /**< equivalent slip of the increment [L] */
  double slip_rate;      /**< that the coefficient saw [L/T] */
  double dissipation;    /**< of the increment [F L], never negative */
  double stored_energy;  /**< of the elastic slip, at the end [F L] */
  double work;           /**< of the friction force over the increment [F L] */
  int regime;            /**< enum slip_regime */
} slip_result;

/** Returns the SLIP_LAW_VERSION that the library was compiled with. */
SLIP_API int slip_law_version(void);

/** Returns the friction of a connector with `count` definitions, or NULL. To be given back to
 * slip_law_destroy(). */
SLIP_API slip_law* slip_law_create(const slip_definition* definitions, size_t count,
                                   slip_error* error);

/** Returns the friction whose numbers slip_law_pack() or `slipbench export --to numbers` gave, or
 * NULL. */
SLIP_API slip_law* slip_law_unpack(const double* numbers, size_t count, slip_error* error);

/** Writes all numbers of the friction, at most `capacity`; returns how many there are. */
SLIP_API size_t slip_law_pack(const slip_law* law, double* numbers, size_t capacity);

/** Takes the memory back; NULL does nothing. */
SLIP_API void slip_law_destroy(slip_law* law);

/** Returns how many definitions there are: predefined friction of PLANAR and UJOINT has two. */
SLIP_API size_t slip_law_definitions(const slip_law* law);

/** Returns how many doubles a state has. Of each definition: elastic slip s_1..s_6 [L], scaled
 * force y_1..y_6 [F], accumulated slip [L], what rounding has left out of it [L], regime. */
SLIP_API size_t slip_law_state_size(const slip_law* law);

/** Writes the state of a connector that has not moved yet. */
SLIP_API void slip_law_initial_state(const slip_law* law, double* state);

/** Integrates one increment.
 * \param old_state at its begin; not changed unless it is `new_state` itself
 * \param[out] new_state at its end
 * \param[out] force friction force on the six components [F], [F L], the sum over all definitions;
 * may be NULL \param[out] results one of each definition; may be NULL Returns enum slip_status;
 * after an error new_state, force and results are as they were. */
SLIP_API int slip_law_update(const slip_law* law, const slip_increment* increment,
                             const double* old_state, double* new_state, double force[6],
                             slip_result* results, slip_error* error);

/** Does the same, and gives the consistent tangent of the force: slopes to the positions at the end
 * of the increment and to the constraint forces there, df_i/du_j at [6 i + j]; both unsymmetric in
 * general. Either may be NULL. A tangent with a number that is not finite is an error,
 * SLIP_NOT_FINITE, which changes nothing: take the update alone there. */
SLIP_API int slip_law_tangent(const slip_law* law, const slip_increment* increment,
                              const double* old_state, double* new_state, double force[6],
                              slip_result* results, double to_motion[36], double to_force[36],
                              slip_error* error);

/** Gives the coefficient of a definition at a slip rate [L/T] and a contact force F_N [F], both
 * finite and not negative, without any state. \param[out] mu coefficient [1] \param[out]
 * to_slip_rate, to_contact_force its slopes [T/L], [1/F]; may be NULL */
SLIP_API int slip_law_coefficient(const slip_law* law, size_t definition, double slip_rate,
                                  double contact_force, double temperature, const double* fields,
                                  size_t field_count, double* mu, double* to_slip_rate,
                                  double* to_contact_force, slip_error* error);

#ifdef __cplusplus
}
#endif

#endif
