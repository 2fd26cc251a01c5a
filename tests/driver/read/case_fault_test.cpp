// SPDX-License-Identifier: Apache-2.0
// Faults of every kind: each is reported once, at its place, with nothing else beside it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

struct Fault {
  std::vector<Change> changes;
  std::vector<std::string> wanted;  ///< how each message begins, after the file's name
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
      {{{"    coefficient:", "    coeficient:"}},
       {"16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?"}},
      {{{"history:", "elastic_slip: 1.0e-4\nhistory:"}},
       {"18:1: error: elastic_slip: unknown key; 'elastic_slip' belongs to friction[].stick"}},
      {{{"friction:", "Friction:"}},
       {"11:1: error: Friction: unknown key; did you mean 'friction'?"}},
      {{{"coefficient: = mu", "coefficient: {static: 0.3}"}},
       {"16:19: error: friction[0].coefficient.static: unknown key; 'static' belongs to"}},
      {{{"coefficient: = mu", "coefficient: [0.1]"}},
       {"16:18: error: friction[0].coefficient: wanted a number, a table, or one law by name,"}},
      {{{"coefficient: = mu", "coefficient:"}},
       {"16:5: error: friction[0].coefficient: wanted a number, a table, or one law by name,"}},
      {{{"coefficient: = mu", "coefficient: true"}},
       {"16:18: error: friction[0].coefficient: 'true' is a truth value where a number is wanted"}},
      {{{"coefficient: = mu", "coefficient: .nan"}},
       {"16:18: error: friction[0].coefficient: '.nan': a finite number is wanted"}},
      {{{"coefficient: = mu", "coefficient: .inf"}},
       {"16:18: error: friction[0].coefficient: '.inf': a finite number is wanted"}},
      {{{"coefficient: = mu", "coefficient: 1e400"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1e400' is too large for a"}},
      {{{"coefficient: = mu", "coefficient: 1e-400"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1e-400' is too small for a"}},
      {{{"coefficient: = mu", "coefficient: 010"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '010' has a leading zero; write"}},
      {{{"coefficient: = mu", "coefficient: 0x10"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '0x10': numbers are decimal;"}},
      {{{"coefficient: = mu", "coefficient: 1,5"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1,5': the decimal mark is '.';"}},
      {{{"coefficient: = mu", "coefficient: 1_000"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1_000': a number has digits"}},
      {{{"coefficient: = mu", "coefficient: 1.5D3"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1.5D3': write 1.5e3"}},
      {{{"coefficient: = mu", "coefficient: 5%"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '5%': write the fraction 0.05"}},
      {{{"coefficient: = mu", "coefficient: 1/2"}},
       {"16:18: error: friction[0].coefficient: wanted a number: '1/2': an expression begins "
        "with"}},
      {{{"coefficient: = mu", "coefficient: 1.5mm"}},
       {"16:18: error: friction[0].coefficient: '1.5mm': a number without a unit is wanted"}},
      {{{"coefficient: = mu", "coefficient: \"0.15\""}},
       {"16:18: error: friction[0].coefficient: wanted a number, found the text '0.15'; a number"}},
      {{{"coefficient: = mu", "coefficient: = nu"}},
       {"16:20: error: friction[0].coefficient: unknown name 'nu'; define it under 'parameters:'"}},
      {{{"coefficient: = mu", "coefficient: = mu*"}},
       {"16:18: error: friction[0].coefficient: the expression ends too early"}},
      {{{"coefficient: = mu", "coefficient: = 1/0"}},
       {"16:18: error: friction[0].coefficient: 1/0 divides by zero"}},
      {{{"coefficient: = mu", "coefficient: = mu/(li-li)"}},
       {"16:18: error: friction[0].coefficient: mu/(li-li) divides by zero"}},
      {{{"coefficient: = mu", "coefficient: -0.1"}},
       {"16:18: error: friction[0].coefficient: must be at least 0, found -0.1"}},
      {{{"coefficient: = mu", "coefficient: = -mu"}},
       {"16:18: error: friction[0].coefficient: must be at least 0, found -0.15"}},
      {{{"increments: 10", "increments: 2.5"}},
       {"20:17: error: history[0].increments: '2.5' where an integer is wanted"}},
      {{{"increments: 10", "increments: = 5/2"}},
       {"20:17: error: history[0].increments: wanted an integer, found 2.5"}},
      {{{"mu: 0.15", "mu: = nu, nu: = mu"}},
       {"4:37: error: parameters.mu: parameters define each other: mu -> nu -> mu"}},
      {{{"mu: 0.15", "mu: = rr*2"}},
       {"4:39: error: parameters.mu: unknown name 'rr'; define it under 'parameters:'"}},
      {{{"mu: 0.15", "mu: = rr*2"}, {"scale: = r", "scale: = zz"}},
       {"4:39: error: parameters.mu: unknown name 'rr'; define it under 'parameters:'",
        "14:55: error: friction[0].potential.terms[1].scale: unknown name 'zz'; define it under"}},
      {{{"mu: 0.15", "mu:"}}, {"4:33: error: parameters.mu: wanted a number, found nothing"}},
      {{{"mu: 0.15", "mu: 0.15, pi: 3"}},
       {"4:43: error: parameters.pi: 'pi' cannot name a parameter: expressions give it a meaning"}},
      {{{"parameters: {r: 0.24, li: 0.55, mu: 0.15}", "parameters: [1]"}},
       {"4:13: error: parameters: wanted a map from names to a number, found a list"}},
      {{{"{component: 1}", "{component: 7}"}},
       {"14:27: error: friction[0].potential.terms[0].component: must be between 1 and 6, found "
        "7"}},
      {{{"slipbench: 1", "slipbench: 2"}}, {"1:12: error: slipbench: must be 1, found 2"}},
      {{{"slipbench: 1\n", ""}}, {"1:1: error: missing key 'slipbench' (an integer)"}},
      {{{"type: CYLINDRICAL", "type: []"}},
       {"6:9: error: connector.type: wanted a connection type, or a list of two basic ones,"}},
      {{{"type: CYLINDRICAL", "type: CILINDRICAL"}},
       {"6:9: error: connector.type: unknown connection type 'CILINDRICAL'; did you mean"}},
      {{{"type: CYLINDRICAL", "type: cylindrical"}},
       {"6:9: error: connector.type: unknown connection type 'cylindrical'; did you mean"}},
      {{{"type: CYLINDRICAL", "type: [SLOT, JOIN]"}},
       {"6:9: error: connector.type: SLOT and JOIN do not make a pair: it takes one basic type"}},
      {{{"type: CYLINDRICAL", "type: [SLOT, JOIN, ALIGN]"}},
       {"6:9: error: connector.type: wanted a connection type, or a list of two basic ones,"}},
      {{{"type: CYLINDRICAL", "type: CYLINDRICAL\n  wrap_angle: 3"}},
       {"7:15: error: connector.wrap_angle: belongs to SLIPRING: a CYLINDRICAL connector has no"}},
      {{{"type: CYLINDRICAL", "type: CYLINDRICAL\n  dimension: 2"}},
       {"6:9: error: connector.type: CYLINDRICAL has no two-dimensional form; only SLOT and "
        "CONTACT may say"}},
      {{{"type: CYLINDRICAL", "type: CYLINDRICAL\n  dimension: 4"}},
       {"7:14: error: connector.dimension: must be between 2 and 3, found 4"}},
      {{{"coefficient: = mu", "coeficient: 0.15"},
        {"motion: {CP1: {to: 0.45}}", "motion: {CP2: {to: 0.45}}"},
        {"increments: 10", "increments: 10\n    duratoin: 2"},
        {"relative: 1.0e-2", "relative: -1"}},
       {"16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?",
        "21:5: error: history[0].duratoin: unknown key; did you mean 'duration'?",
        "22:14: error: history[0].motion.CP2: a CYLINDRICAL connector holds component 2 (its",
        "28:27: error: checks[0].tolerance.relative: must be at least 0, found -1"}},
      {{{"contact_force: normal", "contact_force: norml"},
        {"motion: {CP1: {to: 0.45}}", "motion: {CP2: {to: 0.45}}"},
        {"quantity: FLIM", "quantity: FLIMM"},
        {"relative: 1.0e-2, ", ""}},
       {"15:20: error: friction[0].contact_force: unknown derived component 'norml'; did you mean",
        "21:14: error: history[0].motion.CP2: a CYLINDRICAL connector holds component 2 (its",
        "25:15: error: checks[0].quantity: unknown name 'FLIMM'; did you mean 'FLIM'?",
        "27:16: error: checks[0].tolerance: needs 'absolute' or 'relative', or both (the larger"}},
      {{{"motion: {CP1: {to: 0.45}}", "motion: {CP2: {to: 0.45}}"},
        {"increments: 10", "increment: 10"}},
       {"20:5: error: history[0].increment: unknown key; did you mean 'increments'?",
        "21:14: error: history[0].motion.CP2: a CYLINDRICAL connector holds component 2 (its"}},
      {{{"contact_force: normal", "contact_force: norml"},
        {"coefficient: = mu", "coeficient: = mu"}},
       {"15:20: error: friction[0].contact_force: unknown derived component 'norml'; did you mean",
        "16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?"}},
      {{{"type: CYLINDRICAL", "type: CYLINDRICAL\n  initial: {CP1: x}"},
        {"contact_force: normal", "contact_force: norml"}},
       {"7:18: error: connector.initial.CP1: wanted a number: 'x' is not a number; a parameter",
        "16:20: error: friction[0].contact_force: unknown derived component 'norml'; did you "
        "mean"}},
      {{{"type: CYLINDRICAL", "type: CYLINDRICAL\n  initial: {cp1: 1}\n  reference: {f1: 2}"}},
       {"7:13: error: connector.initial.cp1: unknown position 'cp1'; did you mean 'CP1'?",
        "8:15: error: connector.reference.f1: unknown position 'f1'; positions are CP1, CP2,"}},
      {{{"history:",
         "integration: {method: exakt, accumulated_slip: begin, slip_rate: Slip}\nhistory:"}},
       {"18:23: error: integration.method: wanted backward_euler or exact, found 'exakt'; did you",
        "18:48: error: integration.accumulated_slip: wanted end or start, found 'begin'",
        "18:66: error: integration.slip_rate: wanted slip or relative_motion, found 'Slip'; did"}},
      {{{"checks:", "output: {every: 0, columns: [CSF1, CSF9, t]}\nchecks:"}},
       {"23:17: error: output.every: must be at least 1, found 0",
        "23:36: error: output.columns[1]: no result column 'CSF9'; did you mean 'CSF1'?"}},
      {{{"checks:", "output: {columns: [CSF1, CSF1]}\nchecks:"}},
       {"23:26: error: output.columns[1]: the column 'CSF1' stands twice"}},
      {{{"operator: norm, components: [2, 3]", "operator: Macauley, components: [2, 3]"}},
       {"9:18: error: derived_components.normal[0].operator: wanted norm, sum or macauley_sum,"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, sign: 0, components: [2, 3]"}},
       {"9:30: error: derived_components.normal[0].sign: the sign of a term is 1 or -1, found 0"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, sign: -1, components: [2, 3]"}},
       {"8:3: error: derived_components.normal: a contact force of norms only needs sign 1"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, components: []"}},
       {"9:36: error: derived_components.normal[0].components: a term needs at least one"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, components: [2, 2]"}},
       {"9:40: error: derived_components.normal[0].components[1]: component 2 stands twice in"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, components: [2, 3], weights: [1]"}},
       {"9:53: error: derived_components.normal[0].weights: wanted one weight for each component"}},
      {{{"operator: norm, components: [2, 3]", "operator: sum, components: [2, 3]"}},
       {"8:3: error: derived_components.normal: norm and sum terms do not mix in one contact"}},
      {{{"operator: norm, components: [2, 3]", "operator: norm, componnts: [2, 3]"}},
       {"9:24: error: derived_components.normal[0].componnts: unknown key; did you mean"}},
      {{{"components: [2, 3]", "components: 2"}},
       {"9:36: error: derived_components.normal[0].components: wanted a list, each item an"}},
      {{{"{component: 1}", "{component: \"1\"}"}},
       {"14:27: error: friction[0].potential.terms[0].component: wanted an integer, found the"}},
      {{{"contact_force: normal", "contact_force: 2.5"}},
       {"15:20: error: friction[0].contact_force: '2.5' where an integer is wanted"}},
      {{{"contact_force: normal", "contact_force: 7"}},
       {"15:20: error: friction[0].contact_force: must be between 1 and 6, found 7"}},
      {{{"contact_force: normal", "contact_force: [2]"}},
       {"15:20: error: friction[0].contact_force: wanted a component number 1-6 or the name of a"}},
      {{{"contact_force: normal", "contact_force: \"\""}},
       {"15:20: error: friction[0].contact_force: wanted a component number 1-6 or the name of a"}},
      {{{"  normal:", "  2:"}, {"contact_force: normal", "contact_force: 2"}},
       {"8:3: error: derived_components.2: a derived component cannot have the name '2':"}},
      {{{"name: sleeve", "name: my sleeve"}},
       {"12:11: error: friction[0].name: a name is a letter, then letters, digits and '_', found"}},
      {{{"title: base", "title: {a: 1}"}}, {"2:8: error: title: wanted a text, found a map"}},
      {{{"{to: 0.45}", "{too: 0.45}"}},
       {"21:20: error: history[0].motion.CP1.too: unknown key; did you mean 'to'?"}},
      {{{"{to: 0.45}", "{to: 0.45, smooth_to: 3}"}},
       {"21:19: error: history[0].motion.CP1: a profile has one form, found to and smooth_to"}},
      {{{"{to: 0.45}", "{}"}},
       {"21:19: error: history[0].motion.CP1: wanted a profile: a number, an expression, {to: "
        "v},"}},
      {{{"{to: 0.45}", "[1, 2]"}},
       {"21:19: error: history[0].motion.CP1: wanted a profile: a number, an expression, {to: "
        "v},"}},
      {{{"{to: 0.45}", "0.45"}},
       {"21:19: error: history[0].motion.CP1: a motion needs a profile, found a number; {to:"}},
      {{{"{to: 0.45}", "= mu"}},
       {"21:19: error: history[0].motion.CP1: a motion needs a profile, found a number; {to:"}},
      {{{"{to: 0.45}", "{sine: {amplitude: 1}}"}},
       {"21:26: error: history[0].motion.CP1.sine: a wave needs 'frequency' or 'period'"}},
      {{{"{to: 0.45}", "{sine: {amplitude: 1, period: 1, frequency: 1}}"}},
       {"21:26: error: history[0].motion.CP1.sine: a wave has 'frequency' or 'period', not both"}},
      {{{"{to: 0.45}", "{sine: {amplitude: 1, period: -1}}"}},
       {"21:49: error: history[0].motion.CP1.sine.period: must be greater than 0, found -1"}},
      {{{"{to: 0.45}", "{sine: {amplitude: 1, frequency: 1e-309}}"}},
       {"21:26: error: history[0].motion.CP1.sine: the period must be positive, not inf"}},
      {{{"{to: 0.45}", "{sine: {amplitude: 1, frequency: 1}, mean: 3}"}},
       {"21:56: error: history[0].motion.CP1.mean: stands beside 'sine'; what belongs to the "
        "wave"}},
      {{{"{to: 0.45}", "{columns: [t, value], rows: [[0,0],[1,1]]}"}},
       {"21:29: error: history[0].motion.CP1.columns: the columns of a profile are [value, t]"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0],[1,0.5]]}"}},
       {"21:19: error: history[0].motion.CP1: the table covers t = 0 .. 0.5, the step asks for 0"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0],[1,0.5],[2,0.25],[3,1]]}"}},
       {"21:65: error: history[0].motion.CP1.rows[2][1]: independents must ascend, the first one"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0],[1,0.5],[2,0.5],[3,1]]}"}},
       {"21:62: error: history[0].motion.CP1.rows[2]: row 3 repeats the point of row 2"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0]]}"}},
       {"21:19: error: history[0].motion.CP1: 1 point; two or more are wanted"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0],[1],[2,3,4]]}"}},
       {"21:54: error: history[0].motion.CP1.rows[1]: wanted 2 numbers, one for each column,",
        "21:58: error: history[0].motion.CP1.rows[2]: wanted 2 numbers, one for each column,"}},
      {{{"{to: 0.45}", "{columns: [value, t], rows: [[0,0],[1,1]], extrapolate: linear}"}},
       {"21:75: error: history[0].motion.CP1.extrapolate: a profile must cover its step; it is"}},
      {{{"f2: 300", "F2: 300"}},
       {"22:13: error: history[0].force.F2: unknown quantity 'F2'; did you mean 'f2'?"}},
      {{{"f2: 300", "f1: 300"}},
       {"22:13: error: history[0].force.f1: component 1 is driven by its motion CP1 here"}},
      {{{"motion: {CP1: {to: 0.45}}", "motion: {f2: {to: 0.45}}"}},
       {"21:14: error: history[0].motion.f2: 'f2' is a force: it goes under 'force:'"}},
      {{{"f2: 300", "CP1: {to: 300}"}},
       {"22:13: error: history[0].force.CP1: 'CP1' is a motion: it goes under 'motion:'"}},
      {{{"increments: 10",
         "increments: 10\n    fields: {field1: 2, field99: 3, fild1: 2}\n    temperature: {to: "
         "x}"}},
       {"21:25: error: history[0].fields.field99: unknown field 'field99'; fields are field1 ..",
        "21:37: error: history[0].fields.fild1: unknown field 'fild1'; fields are field1 ..",
        "22:23: error: history[0].temperature.to: wanted a number: 'x' is not a number; a"}},
      {{{"increments: 10", "increments: 0\n    duration: 0\n    repeat: 0"}},
       {"20:17: error: history[0].increments: must be at least 1, found 0",
        "21:15: error: history[0].duration: must be greater than 0, found 0",
        "22:13: error: history[0].repeat: must be at least 1, found 0"}},
      {{{"checks:", "  - step: press\n    increments: 3\nchecks:"}},
       {"23:11: error: history[1].step: the name 'press' is already that of history[0]"}},
      {{{"increments: 10", "adaptive: {tolerance: 1e-6}"}},
       {"20:5: error: history[0].adaptive: adaptive increments are not in this version; give"}},
      {{{"increments: 10", "increments: 10\n    change_friction: {sleve: {coefficient: 0.1}}"}},
       {"21:23: error: history[0].change_friction.sleve: unknown friction definition 'sleve'; "
        "did"}},
      {{{"increments: 10",
         "increments: 10\n    change_friction: {sleeve: {coefficient: -1, amplitude: fast, stick: "
         "{stiffness: 0}}}"}},
       {"21:45: error: history[0].change_friction.sleeve.coefficient: must be at least 0, found -1",
        "21:60: error: history[0].change_friction.sleeve.amplitude: wanted linear or smooth, found",
        "21:85: error: history[0].change_friction.sleeve.stick.stiffness: must be greater than "
        "0,"}},
      {{{"step: press", "step: \"\""}},
       {"19:11: error: history[0].step: the name of a step must not be empty"}},
      {{{"coefficient: = mu",
         "coefficient: {columns: [mu, slip_rate], rows: [[0.1, 0], [-0.1, 1], [0.2, 2], [-0.3, "
         "4]]}"}},
       {"16:63: error: friction[0].coefficient.rows[1][0]: 'mu' must be at least 0, row 2 has -0.1",
        "16:84: error: friction[0].coefficient.rows[3][0]: 'mu' must be at least 0, row 4 has "
        "-0.3"}},
      {{{"coefficient: = mu",
         "coefficient: {exponential_decay: {static: 0.1, kinetic: -0.2, decay: 0.5}}"}},
       {"16:61: error: friction[0].coefficient.exponential_decay.kinetic: must be at least 0,"}},
      {{{"coefficient: = mu",
         "coefficient: {exponential_decay: {static: 0.1, kinetic: 0.2, decay: 0.5}}"}},
       {"16:38: error: friction[0].coefficient.exponential_decay: 'static' must not be below"}},
      {{{"coefficient: = mu",
         "coefficient: {exponential_decy: {static: 0.3, kinetic: 0.2, decay: 0.5}}"}},
       {"16:19: error: friction[0].coefficient.exponential_decy: unknown key; did you mean"}},
      {{{"coefficient: = mu",
         "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.5}, renard: 1}"}},
       {"16:18: error: friction[0].coefficient: wanted one law (exponential_decay,"}},
      {{{"coefficient: = mu",
         "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.5}}\n    "
         "force_limit: 50"}},
       {"17:18: error: friction[0].force_limit: exponential decay takes no force limit"}},
      {{{"elastic_slip: 1.0e-4", "stiffness: 0"}},
       {"17:24: error: friction[0].stick.stiffness: must be greater than 0, found 0"}},
      {{{"elastic_slip: 1.0e-4", "stiffness: -3"}},
       {"17:24: error: friction[0].stick.stiffness: must be greater than 0, found -3"}},
      {{{"elastic_slip: 1.0e-4", "stiffness: 3, elastic_slip: 2"}},
       {"17:12: error: friction[0].stick: give one of {slip_tolerance, characteristic_length},"}},
      {{{"elastic_slip: 1.0e-4", "slip_tolerance: 1e-200, characteristic_length: 1e-200"}},
       {"17:12: error: friction[0].stick: slip_tolerance * characteristic_length = 1e-200 *"}},
      {{{"elastic_slip: 1.0e-4", "slip_tolerance: 1e200, characteristic_length: 1e200"}},
       {"17:12: error: friction[0].stick: slip_tolerance * characteristic_length = 1e+200 *"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: -5\n"}},
       {"16:29: error: friction[0].internal_contact_force: must be at least 0, found -5"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force:\n      columns: [force, "
         "accumulated_slip]\n      rows: [[100, 0], [90, 10],\n             [-1, 20]]\n"}},
       {"19:15: error: friction[0].internal_contact_force.rows[2][0]: 'force' must be at least "
        "0,"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force:\n      columns: [force, "
         "accumulated_slip]\n      rows: [[100, 0], [90, 20],\n             [80, 10]]\n"}},
       {"19:19: error: friction[0].internal_contact_force.rows[2][1]: independents must ascend,"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force:\n      columns: [force, "
         "accumulated_slip]\n      rows: [[100, 0], [90, 20],\n             [80, 20]]\n"}},
       {"19:14: error: friction[0].internal_contact_force.rows[2]: row 3 repeats the point of "
        "row"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [force, "
         "accumulated_slip], rows: [[100, 0]], extrapolate: linear}\n"}},
       {"16:73: error: friction[0].internal_contact_force.rows[0]: linear extrapolation needs "
        "two"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [force, slip_rate, "
         "acumulated_slip, temperature, temperature], rows: [[100, 0, 0, 0, 0]]}\n"}},
       {"16:47: error: friction[0].internal_contact_force.columns[1]: an internal contact force",
        "16:58: error: friction[0].internal_contact_force.columns[2]: an internal contact force",
        "16:88: error: friction[0].internal_contact_force.columns[4]: 'temperature' stands twice"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [accumulated_slip, "
         "force], rows: [[100, 0]]}\n"}},
       {"16:40: error: friction[0].internal_contact_force.columns[0]: 'accumulated_slip' is an"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [force, "
         "accumulated_slip]}\n"}},
       {"16:29: error: friction[0].internal_contact_force: a table needs 'rows' or 'csv'"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [force, "
         "accumulated_slip], rows: [[1,0]], csv: a.csv}\n"}},
       {"16:86: error: friction[0].internal_contact_force.csv: a table has 'rows' or 'csv', not"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [force, "
         "accumulated_slip], rows: []}\n"}},
       {"16:72: error: friction[0].internal_contact_force.rows: a table needs at least one row"}},
      {{{"    contact_force: normal\n",
         "    contact_force: normal\n    internal_contact_force: {columns: [], rows: [[1]]}\n"}},
       {"16:39: error: friction[0].internal_contact_force.columns: wanted 1 dependent column"}},
      {{{"    coefficient: = mu\n    stick", "    coefficient: = mu\n    stick"},
        {"history:",
         "  - component: 1\n    contact_force: normal\n    coefficient: 0.1\n    stick: "
         "{elastic_slip: 1e-3}\nhistory:"}},
       {"18:16: error: friction[1].component: component 1 already slips in friction[0]: a free"}},
      {{{"history:",
         "  - potential: {terms: [{component: 4}]}\n    contact_force: normal\n    coefficient: "
         "0.1\n    stick: {elastic_slip: 1e-3}\nhistory:"}},
       {"18:16: error: friction[1].potential: a connector has one potential at most, the other "
        "is"}},
      {{{"history:",
         "  - predefined: {R: 1, L: 1}\n    coefficient: 0.1\n    stick: {elastic_slip: "
         "1e-3}\nhistory:"}},
       {"18:17: error: friction[1].predefined: predefined friction must be the only definition,"}},
      {{{"history:",
         "  - predefined: {R: 1, L: 1}\n    coefficient: 0.1\n    stick: {elastic_slip: "
         "1e-3}\nhistory:"},
        {"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {R: 1}\n"}},
       {"16:17: error: friction[1].predefined: predefined friction must be the only definition,"}},
      {{{"type: CYLINDRICAL", "type: [CARTESIAN, REVOLUTE]"},
        {"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {}\n"}},
       {"13:17: error: friction[0].predefined: this connector has no predefined friction; those "
        "that have: SLOT, SLIDE-PLANE, CYLINDRICAL, TRANSLATOR, HINGE, PLANAR, UJOINT, SLIPRING "
        "and "
        "CONTACT, and SLOT and SLIDE-PLANE in a pair with any rotation; here give 'component' or "
        "'potential'"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {L: 2}\n"}},
       {"13:17: error: friction[0].predefined: missing key 'R' (a number)"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {R: 2, L: -1}\n"}},
       {"13:27: error: friction[0].predefined.L: must be at least 0, found -1"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {R: 0, L: 1}\n"}},
       {"13:21: error: friction[0].predefined.R: must be greater than 0, found 0"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined: {R: 1, l: 1, R_p: 3, internal_contact_force: -3}\n"}},
       {"13:24: error: friction[0].predefined.l: unknown key; did you mean 'L'?",
        "13:30: error: friction[0].predefined.R_p: unknown key; 'R_p' belongs to",
        "13:62: error: friction[0].predefined.internal_contact_force: must be at least 0, found "
        "-3"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n",
         "    predefined: {R: 1}\n"}},
       {"14:20: error: friction[0].contact_force: predefined friction chooses its contact force"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "contact_force: normal\n",
         "    predefined:\n"}},
       {"13:5: error: friction[0].predefined: wanted a map of the connection's geometry ({}"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n",
         "    component: 2\n"}},
       {"13:16: error: friction[0].component: a CYLINDRICAL connector holds component 2: "
        "friction"}},
      {{{"type: CYLINDRICAL", "type: SLOT"},
        {"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n",
         "    component: 5\n"}},
       {"10:37: error: derived_components.normal[1].components[0]: a SLOT connector has no",
        "10:40: error: derived_components.normal[1].components[1]: a SLOT connector has no",
        "13:16: error: friction[0].component: a SLOT connector has no component 5: friction acts",
        "21:31: error: history[0].force.m2: a SLOT connector has no component 5; its constraint"}},
      {{{"{component: 4, scale", "{component: 5, scale"}},
       {"14:43: error: friction[0].potential.terms[1].component: a CYLINDRICAL connector holds"}},
      {{{"{component: 4, scale", "{component: 1, scale"}},
       {"14:43: error: friction[0].potential.terms[1].component: component 1 stands twice in the"}},
      {{{"scale: = r", "scale: 0"}},
       {"14:53: error: friction[0].potential.terms[1].scale: must be greater than 0, found 0"}},
      {{{"    potential:\n", "    potential:\n      exponent: 0.5\n"}},
       {"14:17: error: friction[0].potential.exponent: must be between 1 and 10000, found"}},
      {{{"    potential:\n", "    potential:\n      operator: most\n"}},
       {"14:17: error: friction[0].potential.operator: wanted sum or max, found 'most'"}},
      {{{"terms: [{component: 1}, {component: 4, scale: = r}]",
         "terms: [{component: 1, of: none}, {component: 4, scale: 1, exponent: 3, sign: -1}, "
         "{derived: x}]"}},
       {"14:34: error: friction[0].potential.terms[0].of: the value itself of a component or a sum",
        "14:76: error: friction[0].potential.terms[1].exponent: the exponent of every term must be",
        "14:85: error: friction[0].potential.terms[1].sign: the contributions of a friction",
        "14:100: error: friction[0].potential.terms[2].derived: unknown derived component 'x'"}},
      {{{"contact_force: normal", "contact_force: norml"}},
       {"15:20: error: friction[0].contact_force: unknown derived component 'norml'; did you "
        "mean"}},
      {{{"    contact_force: normal\n", ""}},
       {"12:5: error: friction[0]: neither 'contact_force' nor 'internal_contact_force': nothing"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n", ""}},
       {"12:5: error: friction[0]: needs one of 'predefined', 'component' and 'potential'"}},
      {{{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n",
         "    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n    "
         "component: 1\n"}},
       {"12:5: error: friction[0]: takes only one of 'predefined', 'component' and 'potential'"}},
      {{{"length: mm", "length: N"}},
       {"3:17: error: units.length: unit 'N' does not measure a length"}},
      {{{"length: mm", "length: mmm, frce: N"}},
       {"3:17: error: units.length: unknown unit 'mmm'; did you mean 'mm'?",
        "3:22: error: units.frce: unknown key; did you mean 'force'?"}},
      {{{"length: mm", "length: 5"}},
       {"3:17: error: units.length: unit '5' does not measure a length"}},
      {{{"    coefficient: = mu\n", "    coefficient: = mu\n    force_limit: -3\n"}},
       {"17:18: error: friction[0].force_limit: must be at least 0, found -3"}},
      {{{"terms: [{component: 1}, {component: 4, scale: = r}]", "terms: []"}},
       {"14:14: error: friction[0].potential.terms: a potential needs at least one term"}},
      {{{"history:",
         "  - name: sleeve\n    component: 1\n    contact_force: normal\n    coefficient: 0.1\n    "
         "stick: {elastic_slip: 1e-3}\nhistory:"},
        {"terms: [{component: 1}, {component: 4, scale: = r}]",
         "terms: [{component: 4, scale: = r}]"}},
       {"18:11: error: friction[1].name: the name 'sleeve' is already that of friction[0]"}},
      {{{"history:",
         "  - component: 1\n    contact_force: normal\n    coefficient: 0.1\n    stick: "
         "{elastic_slip: 1e-3}\nhistory:"},
        {"terms: [{component: 1}, {component: 4, scale: = r}]",
         "terms: [{component: 4, scale: = r}]"},
        {"name: sleeve", "name: friction2"}},
       {"12:11: error: friction[0].name: the name 'friction2' is already that of friction[1]"}},
      {{{"weights: [= 2/li, = 2/li]",
         "weights: {columns: [w5, w6, CP1], rows: [[1, 1, 0.5], [2, 2]]}"}},
       {"10:98: error: derived_components.normal[1].weights.rows[1]: wanted 3 numbers, one for"}},
      {{{"weights: [= 2/li, = 2/li]", "weights: {columns: [w5], rows: [[1]]}"}},
       {"10:63: error: derived_components.normal[1].weights.columns: wanted 2 dependent columns"}},
      {{{"weights: [= 2/li, = 2/li]", "weights: {columns: [w5, w6, CP2], rows: [[1, 1, 0]]}"}},
       {"10:72: error: derived_components.normal[1].weights.columns[2]: 'CP2' never changes: a"}},
      {{{"components: [2, 3]", "components: [2, x]"}},
       {"9:40: error: derived_components.normal[0].components[1]: wanted an integer: 'x' is not"}},
      {{{"coefficient: = mu", "coeficient: = mu"},
        {"history:",
         "  - component: 2\n    contact_force: normal\n    coefficient: 0.1\n    stick: "
         "{elastic_slip: 1e-3}\n  - component: 2\n    contact_force: normal\n    coefficient: "
         "0.1\n    stick: {elastic_slip: 1e-3}\nhistory:"}},
       {"16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?",
        "18:16: error: friction[1].component: a CYLINDRICAL connector holds component 2: friction",
        "22:16: error: friction[2].component: a CYLINDRICAL connector holds component 2: "
        "friction"}},
      {{{"quantity: FLIM", "quantity: FLIMM"}},
       {"25:15: error: checks[0].quantity: unknown name 'FLIMM'; did you mean 'FLIM'?"}},
      {{{"= mu*FN", "= mu*FNN"}},
       {"26:33: error: checks[0].against.expression: unknown name 'FNN'; did you mean 'FN'?"}},
      {{{"{expression: \"= mu*FN\"}", "{}"}},
       {"26:14: error: checks[0].against: needs 'expression', 'closed_form' or 'curve'"}},
      {{{"{expression: \"= mu*FN\"}", "{expression: \"= mu\", closed_form: coulomb_slider}"}},
       {"26:14: error: checks[0].against: has 'expression' and 'closed_form', a check takes one"}},
      {{{"{expression: \"= mu*FN\"}", "{closed_form: coulomb_slidr}"}},
       {"26:28: error: checks[0].against.closed_form: unknown closed form 'coulomb_slidr'; did"}},
      {{{"{expression: \"= mu*FN\"}", "{closed_form: coulomb_slider, with: {q: 3, mu: 0.2}}"}},
       {"26:50: error: checks[0].against.with: missing key 'normal_force' (normal force (a",
        "26:50: error: checks[0].against.with: missing key 'stick_stiffness' (stiffness of the",
        "26:51: error: checks[0].against.with.q: unknown key; known here: mu, normal_force,"}},
      {{{"{expression: \"= mu*FN\"}",
         "{closed_form: coulomb_slider, with: {mu: [0.2], normal_force: -3, stick_stiffness: 0}}"}},
       {"26:55: error: checks[0].against.with.mu: wanted a number, found a list",
        "26:76: error: checks[0].against.with.normal_force: must be at least 0, found -3",
        "26:97: error: checks[0].against.with.stick_stiffness: must be greater than 0, found 0"}},
      {{{"{expression: \"= mu*FN\"}",
         "{closed_form: coulomb_slider, with: {mu: 0.2, normal_force: 3, stick_stiffness: 1}, "
         "inputs: {motion: CU9, motin: CU1}, output: forc}"}},
       {"26:115: error: checks[0].against.inputs.motion: no result column 'CU9'; did you mean",
        "26:120: error: checks[0].against.inputs.motin: unknown key; did you mean 'motion'?",
        "26:141: error: checks[0].against.output: wanted force, accumulated_slip, dissipation,"}},
      {{{"{relative: 1.0e-2, why: rounding}", "{why: x}"}},
       {"27:16: error: checks[0].tolerance: needs 'absolute' or 'relative', or both (the larger"}},
      {{{"{relative: 1.0e-2, why: rounding}", "{absolute: -1, relative: .nan}"}},
       {"27:27: error: checks[0].tolerance.absolute: must be at least 0, found -1",
        "27:41: error: checks[0].tolerance.relative: '.nan': a finite number is wanted"}},
      {{{"    tolerance: {relative: 1.0e-2, why: rounding}\n", ""}},
       {"24:5: error: checks[0]: missing key 'tolerance' (a map)"}},
      {{{"    tolerance", "    step: pres\n    tolerance"}},
       {"27:11: error: checks[0].step: no step 'pres'; did you mean 'press'?"}},
      {{{"    tolerance", "    over: {from: 3, to: 1}\n    tolerance"}},
       {"27:11: error: checks[0].over: 'from' must not be after 'to', found 3 and 1"}},
      {{{"    tolerance", "    criterion: peek\n    abscissa: FLMI\n    tolerance"}},
       {"27:16: error: checks[0].criterion: wanted pointwise, peak, area, loop_energy, breakaway,",
        "28:15: error: checks[0].abscissa: wanted time, accumulated_slip, a result column or an "}},
      {{{"    tolerance", "    abscissa: \"= mu\"\n    tolerance"}},
       {"27:15: error: checks[0].abscissa: is the same number in every row"}},
      {{{"    tolerance", "    criterion: arc_length\n    tolerance"}},
       {"27:16: error: checks[0].criterion: arc_length needs a position to go over, not time; "
        "say"}},
      {{{"{relative: 1.0e-2, why: rounding}", "{relative: 1.0e-2, abscissa: 1}"}},
       {"27:45: error: checks[0].tolerance.abscissa: pointwise compares no positions; breakaway"}},
      {{{"{expression: \"= mu*FN\"}", "{expression: \"= mu*FN\", curve: a.csv}"}},
       {"26:14: error: checks[0].against: has 'expression' and 'curve', a check takes one of "
        "them"}},
      {{{"{expression: \"= mu*FN\"}", "{expression: \"= mu*FN\", column: F}"}},
       {"26:14: error: checks[0].against: 'abscissa' and 'column' belong to a curve"}},
      {{{"{expression: \"= mu*FN\"}", "{curve: dahl_loop, output: force}"}},
       {"26:14: error: checks[0].against: 'with', 'inputs' and 'output' belong to a closed form"}},
      {{{"quantity: FLIM", "quantity: 5"}},
       {"25:15: error: checks[0].quantity: names nothing of the result: this check would compare"}},
      {{{"{expression: \"= mu*FN\"}", "{expression: \"= mu*FN\", output: force}"}},
       {"26:14: error: checks[0].against: 'with', 'inputs' and 'output' belong to a closed form"}},
      {{{"history:", "unit: mm\nhistory:"}},
       {"18:1: error: unit: unknown key; did you mean 'units'?"}},
      {{{"history:", "type: SLOT\nhistory:"}},
       {"18:1: error: type: unknown key; 'type' belongs to connector"}},
      {{{"history:", "increments: 5\nhistory:"}},
       {"18:1: error: increments: unknown key; 'increments' belongs to history[]"}},
      {{{"history:", "initial: {CP1: 2}\nhistory:"}},
       {"18:1: error: initial: unknown key; 'initial' belongs to connector"}},
      {{{"    coefficient: = mu\n", "    coefficient: = mu\n    R: 3\n"}},
       {"17:5: error: friction[0].R: unknown key; 'R' belongs to friction[].predefined"}},
      {{{"    coefficient: = mu\n", "    coefficient: = mu\n    mu: 3\n"}},
       {"17:5: error: friction[0].mu: unknown key; the coefficient is 'coefficient: 0.2'"}},
      {{{"    coefficient: = mu\n", "    coefficient: = mu\n    slip_tolerance: 3\n"}},
       {"17:5: error: friction[0].slip_tolerance: unknown key; 'slip_tolerance' belongs to"}},
      {{{"    increments", "    CP1: {to: 3}\n    increments"}},
       {"20:5: error: history[0].CP1: unknown key; 'CP1' belongs to history[].motion"}},
      {{{"    increments", "    f2: 3\n    increments"}},
       {"20:5: error: history[0].f2: unknown key; 'f2' belongs to history[].force"}},
      {{{"    increments", "    amplitude: 3\n    increments"}},
       {"20:5: error: history[0].amplitude: unknown key; 'amplitude' belongs to a profile's"}},
      {{{"    increments", "    field1: 3\n    increments"}},
       {"20:5: error: history[0].field1: unknown key; 'field1' belongs to history[].fields"}},
      {{{"    increments", "    checks: 3\n    increments"}},
       {"20:5: error: history[0].checks: unknown key; 'checks' belongs to the top level"}},
      {{{"history:", "r: 0.3\nhistory:"}},
       {"18:1: error: r: unknown key; known here: slipbench, title, units, parameters,"}},
      {{{"history:", "step: press\nhistory:"}},
       {"18:1: error: step: unknown key; 'step' belongs to history[] or checks[]"}},
      {{{"history:", "to: 3\nhistory:"}},
       {"18:1: error: to: unknown key; 'to' belongs to a profile or checks[].over"}},
      {{{"history:", "title_: 3\nhistory:"}},
       {"18:1: error: title_: unknown key; did you mean 'title'?"}},
      {{{"history:", "tolerance: 3\nhistory:"}},
       {"18:1: error: tolerance: unknown key; 'tolerance' belongs to integration or checks[]"}},
      {{{"      terms:", "      contact_force: normal\n      terms:"}},
       {"14:7: error: friction[0].potential.contact_force: unknown key; 'contact_force' belongs"}},
      {{{"{component: 1}", "{componnt: 1}"}},
       {"14:16: error: friction[0].potential.terms[0].componnt: unknown key; did you mean"}},
      {{{"stick:", "stik:"}},
       {"17:5: error: friction[0].stik: unknown key; did you mean 'stick'?"}},
      {{{"contact_force: normal", "contact_fore: normal"}},
       {"15:5: error: friction[0].contact_fore: unknown key; did you mean 'contact_force'?"}},
      {{{"potential:", "potental:"}},
       {"13:5: error: friction[0].potental: unknown key; did you mean 'potential'?"}},
      {{{"relative", "relativ"}},
       {"27:17: error: checks[0].tolerance.relativ: unknown key; did you mean 'relative'?"}},
      {{{"expression:", "expresion:"}},
       {"26:15: error: checks[0].against.expresion: unknown key; did you mean 'expression'?"}},
      {{{"friction:", "Friction:"}},
       {"11:1: error: Friction: unknown key; did you mean 'friction'?"}},
      {{{"history:", "History:"}}, {"18:1: error: History: unknown key; did you mean 'history'?"}},
      {{{"checks:", "check:"}}, {"23:1: error: check: unknown key; did you mean 'checks'?"}},
      {{{"connector:", "conector:"}},
       {"5:1: error: conector: unknown key; did you mean 'connector'?"}},
      {{{"derived_components:", "derived_component:"}},
       {"7:1: error: derived_component: unknown key; did you mean 'derived_components'?"}},
      {{{"parameters:", "parameter:"}},
       {"4:1: error: parameter: unknown key; did you mean 'parameters'?"}},
      {{{"  - step: press\n", "  - stp: press\n"}},
       {"19:5: error: history[0].stp: unknown key; did you mean 'step'?"}},
      {{{"{to: 0.45}", "{csv: good.csv, time: t, vlue: x}"}},
       {"21:44: error: history[0].motion.CP1.vlue: unknown key; did you mean 'value'?"}},
      {{{"checks:\n", "checks:\n  -\n"}}, {"24:3: error: checks[0]: wanted a map, found nothing"}},
      {{{"friction:\n", "friction:\n  -\n"}},
       {"12:3: error: friction[0]: wanted a map, found nothing"}},
      {{{"history:\n", "history:\n  - 3\n"}}, {"19:5: error: history[0]: wanted a map, found '3'"}},
      {{{"{component: 1}", "3"}},
       {"14:15: error: friction[0].potential.terms[0]: wanted a map, found '3'"}},
      {{{"{operator: norm, components: [2, 3]}", "3"}},
       {"9:7: error: derived_components.normal[0]: wanted a map, found '3'"}},
      {{{"    - {operator: norm, components: [2, 3]}\n    - {operator: norm, components: [5, 6], "
         "weights: [= 2/li, = 2/li]}\n",
         "   3\n"}},
       {"9:4: error: derived_components.normal: wanted a list, each item a map, found '3'"}},
  };
  return all;
}

TEST_CASE("Every fault of a case is reported once, at its place, and nothing else is") {
  for (const Fault& fault : faults()) {
    const std::string text = changed(fault.changes);
    const std::vector<std::string> found = messages(text);
    INFO(complaint(text));
    REQUIRE(found.size() == fault.wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].substr(0, fault.wanted[i].size()) == fault.wanted[i]);
    }
  }
}

TEST_CASE("A fault elsewhere in the file hides none of them") {
  const std::string elsewhere = ": error: title: wanted a text, found a list";
  for (const Fault& fault : faults()) {
    const std::string one = changed(fault.changes);
    if (one.find("title: base\n") == std::string::npos) continue;
    const std::string text = changed({{"title: base\n", "title: [base]\n"}}, one);
    const std::vector<std::string> found = messages(text);
    INFO(complaint(text));
    REQUIRE(found.size() == fault.wanted.size() + 1);
    CHECK(std::count_if(found.begin(), found.end(), [&](const std::string& message) {
            return message.ends_with(elsewhere);
          }) == 1);
  }
}

TEST_CASE("A list whose items would fill the memory is refused") {
  std::string many = "friction:\n";
  for (int i = 0; i < 60000; ++i) many += "  - component: 1\n";
  const std::vector<std::string> found = messages(changed({{"friction:\n", many}}));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Catch::Contains("friction: 60001 items, at most "));
}

TEST_CASE("A potential has few terms, and so has a derived component in it") {
  std::string terms;
  std::string parts;
  for (int i = 0; i < 1000; ++i) {
    terms += "{component: 1}, ";
    parts += "    - {operator: norm, components: [2, 3]}\n";
  }
  const Change many_parts{"  normal:\n", "  normal:\n" + parts};
  CHECK(messages(changed({{"terms: [", "terms: [" + terms}})) ==
        std::vector<std::string>{"14:14: error: friction[0].potential.terms: a potential has at "
                                 "most 50 terms, found 1002; each component of the connector "
                                 "enters once"});
  CHECK(messages(changed({many_parts, {"{component: 1}", "{derived: normal}"}})) ==
        std::vector<std::string>{"1014:25: error: friction[0].potential.terms[0].derived: a "
                                 "derived component of a potential has at most 50 terms, 'normal' "
                                 "has 1002; each component of the connector enters once"});
  // A contact force is one copy of them, and any number may make sense.
  const cases::Case problem = sound(changed({many_parts}));
  const auto& contact = problem.definitions[0].law.contact_force;
  CHECK(std::get<law::DerivedComponent>(contact).size() == 1002);
}

}  // namespace
}  // namespace slipbench::driver::read
