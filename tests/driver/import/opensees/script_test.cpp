// SPDX-License-Identifier: Apache-2.0
// A number of a script is read only where it is certain.
#include "driver/import/opensees/script.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/import/opensees/friction_model.hpp"

namespace slipbench::driver::opensees {
namespace {

/// The coefficients of the models of a script, and what is said of it.
std::string told(const std::string& name, const std::string& text) {
  base::Diagnostics out;
  const Script script = read_script(base::SourceText(name, text), out);
  std::string all;
  for (const Found& one : read_models(script, out)) {
    all += one.friction.otherwise.coefficient + "\n";
  }
  return all + base::render(out);
}

std::string tcl(const std::string& text) { return told("a.tcl", text); }
std::string python(const std::string& text) { return told("a.py", text); }

constexpr const char* kUncertain = "mu is set in a way that is not followed here: write its number";

TEST_CASE("Commands of Tcl that may set a name take its number from it") {
  for (const std::string& between :
       std::vector<std::string>{"proc f {} {global mu; set mu 0.3}\nf",
                                "proc f {} {set ::mu 0.3}\nset x [f]",
                                "proc f {} {set ::mu 0.3}\nif {[f]} {}",
                                "proc f {} {set ::mu 0.3}\nset x [expr {[f]}]",
                                "source params.tcl",
                                "eval {set mu 0.3}",
                                "eval \"set m\" u 0.3",
                                "uplevel {set mu 0.3}",
                                "lassign {0.3 0.4} mu k",
                                "lassign {0.3} $n",
                                "scan 0.3 %f mu",
                                "regexp {x} y mu",
                                "upvar 0 k mu",
                                "dict with d {mu}",
                                "array set mu {a 1}",
                                "unknown mu",
                                "unknown $n",
                                "set $n 0.3",
                                "set m[f] 0.3",
                                "set m\\u 0.3",
                                "set {*}{mu 0.3}",
                                "package require p",
                                "namespace eval :: {set mu 0.3}",
                                "rename set put\nset mu 0.3",
                                "trace add variable mu write f\nset mu 0.3",
                                "time {set mu 0.3} 3",
                                "dict for {mu k} {0.3 1} {}",
                                "try {set mu 0.3} finally {}",
                                "pattern Plain 1 1 {set mu 1}",
                                "catch {set mu 0.3}",
                                "catch {} mu",
                                "foreach {tag mu} {1 0.3} {}",
                                "foreach k {1 2} {set mu 0.3}",
                                "while {[set mu 0.3]} {}",
                                "after 1 {set mu 0.3}",
                                "switch $k {\n  a {set k 1}\n  b {set mu 0.3}\n}",
                                "switch $k a {set mu 0.3}",
                                "proc set {a b} {}\nset mu 0.3",
                                "node 1 [set mu 0.3] 0",
                                "s\\et mu 0.3",
                                "set mu {$k}",
                                "set mu $k-1",
                                "append mu 1",
                                "gets stdin mu",
                                "unset mu",
                                "set colour #fff; eval {set mu 0.3}",
                                "$command mu 0.3",
                                "if $k \"set mu $k\""}) {
    const std::string all = tcl("set mu 0.1\n" + between +
                                "\nfrictionModel Coulomb 1 $mu\nfrictionModel Coulomb 2 0.7\n");
    INFO(between << "\n" << all);
    CHECK_THAT(all, Catch::StartsWith("0.7\n") && Catch::Contains("error: frictionModel: mu: "));
  }
  CHECK_THAT(tcl("set mu 0.1\nlassign {1} mu\n  frictionModel Coulomb 1 $mu\n"),
             Catch::Contains("a.tcl:3:3: error") && Catch::Contains(kUncertain));
}

TEST_CASE("Commands of Tcl that set no name leave its number") {
  for (const std::string& between : std::vector<std::string>{
           "puts \"mu = $mu\"", "node 1 0 0", "set ::k 2", "proc f {mu} {set mu 0.3}",
           "uniaxialMaterial Elastic 1 $mu", "set k [lindex $list 0]",
           "foreach k {1 2} {node $k 0 0}", "switch $k {\n  a {set k 1}\n}", "# eval {set mu 0.3}",
           "set k \"\\[set mu 3\"", "if {$k} {puts a} else {puts b}", "catch {wipe}"}) {
    const std::string all = tcl("set mu 0.1\n" + between + "\nfrictionModel Coulomb 1 $mu\n");
    INFO(between);
    CHECK(all == "0.1\n");
  }
  CHECK(tcl("set ::mu 0.2\nfrictionModel Coulomb 1 [expr {${mu} * \\\n 2}]\n") == "0.4\n");
}

TEST_CASE("Models of Tcl that are not followed are told") {
  CHECK(
      tcl("switch $k {\n a {frictionModel Coulomb 1 0.1}\n b {frictionModel Coulomb 2 0.2}\n}\n") ==
      "0.1\n0.2\n");
  for (const std::string& text : std::vector<std::string>{
           "eval {frictionModel Coulomb 1 0.1}", "eval \"frictionModel Coulomb 1 0.1\"",
           "set c frictionModel", "interp alias {} fm {} frictionModel",
           "unknown {frictionModel Coulomb 1 0.1}", "apply {{} {frictionModel Coulomb 1 0.1}}"}) {
    INFO(text);
    CHECK_THAT(tcl(text + "\n"),
               Catch::StartsWith("a.tcl:1:1: warning: a frictionModel in a part"));
  }
  CHECK_THAT(tcl("set k 1\n  source params.tcl\n"),
             Catch::StartsWith("a.tcl:2:3: warning: the file of source is not followed"));
  CHECK_THAT(tcl("exit\nfrictionModel Coulomb 1 0.1\n"),
             Catch::StartsWith("a.tcl:1:1: warning: the script ends here"));
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "while {1} {";
  CHECK_THAT(tcl(deep + std::string(200, '}')), Catch::Contains("is nested too deeply"));
}

TEST_CASE("Statements of Python that may set a name take its number from it") {
  for (const std::string& between : std::vector<std::string>{
           "match k:\n    case 1:\n        mu = 0.2",
           "match k:\n    case [mu, x]:\n        pass",
           "from params import mu",
           "from params import *",
           "from p import (k,\n  mu)",
           "import params as mu",
           "def f():\n    global mu\n    mu = 0.3\nf()",
           "def f():\n    global mu\n    mu = 0.3\nk = 1 + f()",
           "class A:\n    def f(self):\n        global mu\n        mu = 0.3\na = A()\na.f()",
           "if (mu := 0.3) > 0: pass",
           "print(mu := 0.3)",
           "print(f'{(mu:=0.3)}')",
           "[mu, k] = [0.3, 0.4]",
           "(mu, k) = (0.3, 0.4)",
           "mu, *k = z",
           "k, (mu, x) = z",
           "mu, k = z",
           "k = x, mu = z",
           "for mu in z: pass",
           "for [mu] in z:\n    pass",
           "for k, (mu, x) in z: pass",
           "for k in z:\n    mu = 0.3",
           "for k in z: pass\nelse: mu = 0.3",
           "while k:\n    mu += 0.1",
           "with open('x') as mu: pass",
           "with a as (k, mu): pass",
           "try: pass\nexcept E as mu: pass",
           "try:\n    mu = 0.3\nexcept E: pass",
           "exec('mu = 0.3')",
           "globals()['mu'] = 0.3",
           "del mu",
           "mu[0] = 0.3",
           "class mu: pass",
           "def mu(): pass",
           "unknown(mu)",
           "mu = 'a'",
           "mu = 1 < 2 < 3",
           "mu = 010",
           "mu = min(1, k)",
           "def max(*a): return 3\nmu = max(1, 2)",
           "from p import *\nmu = sqrt(4)",
           "mu = pi",
           "from p import sqrt\nmu = sqrt(4)",
           "import p as math\nmu = math.sqrt(4)"}) {
    const std::string all =
        python("mu = 0.1\n" + between +
               "\nops.frictionModel('Coulomb', 1, mu)\nops.frictionModel('Coulomb', 2, 0.7)\n");
    INFO(between << "\n" << all);
    CHECK_THAT(all, Catch::StartsWith("0.7\n") && Catch::Contains("error: frictionModel: mu: "));
  }
  CHECK_THAT(python("mu = 0.1\n[mu] = z\nif k:\n  ops.frictionModel('Coulomb', 1, mu)\n"),
             Catch::Contains("a.py:4:3: error") && Catch::Contains(kUncertain));
}

TEST_CASE("Statements of Python that set no name leave its number") {
  for (const std::string& between : std::vector<std::string>{
           "\"\"\"\nmu = 0.9\nops.frictionModel('Coulomb', 9, 0.9)\n\"\"\"", "'''it's\nmu = 0.3'''",
           "print('no frictionModel( here')", "print(\"it's \\\" mu = 3 (\")", "ops.node(1, mu)",
           "def f():\n    '''mu = 3'''\n    mu = 0.3", "k = {'mu': 3}", "k = [0.1,\n     0.2]",
           "if False:\n    mu = 0.3\nelse:\n    k = 2", "x = k == 3",
           "for i in range(3):\n    k = i", "import math"}) {
    const std::string all =
        python("mu = 0.1\n" + between + "\nops.frictionModel('Coulomb', 1, mu)\n");
    INFO(between << "\n" << all);
    CHECK(all == "0.1\n");
  }
  CHECK(python("a = mu = 0.3\nops.frictionModel ('Coulomb', 1, mu)\n") == "0.3\n");
  CHECK(python("from math import pi\nops.frictionModel('Coulomb', 1, pi/pi)\n") == "1\n");
  CHECK(python("ops.frictionModel('Coulomb', 1, round(0.5)); ops.frictionModel('Coulomb', 2, "
               "2**-1)\n") == "0\n0.5\n");
}

TEST_CASE("Models of Python that are not followed are told") {
  for (const std::string& text : std::vector<std::string>{
           "fm = ops.frictionModel", "x = ops.frictionModel('Coulomb', 1, 0.1)",
           "[ops.frictionModel('Coulomb', i, 0.1) for i in z]", "getattr(ops, 'frictionModel')(1)",
           "from openseespy.opensees import frictionModel as fm", "f(ops.frictionModel)",
           "if ops.frictionModel('Coulomb', 1, 0.1): pass"}) {
    INFO(text);
    const std::string all = python(text + "\n");
    CHECK_THAT(all, Catch::StartsWith("a.py:1:1: warning: frictionModel in a way"));
  }
  CHECK_THAT(python("k = 1\nx = (1,\nops.frictionModel('Coulomb', 1, 0.1)\n"),
             Catch::Contains("a.py:2:5: error: this bracket is never closed"));
  CHECK_THAT(python("x = 'it\nops.frictionModel('Coulomb', 1, 0.1)\n"),
             Catch::Contains("a.py:1:5: error: this quote is never closed"));
  CHECK_THAT(python("exit()\nops.frictionModel('Coulomb', 1, 0.1)\n"),
             Catch::StartsWith("a.py:1:1: warning: the script ends here"));
  for (const char* text : {"import", "from", "lambda", "=", ":=", "def", "for", "(", "\\"}) {
    python(text);
  }
}

}  // namespace
}  // namespace slipbench::driver::opensees
