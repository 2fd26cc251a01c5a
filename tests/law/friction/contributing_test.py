#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The law that CONTRIBUTING shows joins the list of laws by the one entry that it speaks of, and is
then a law like any other.

usage: contributing_test.py COMPILER SOURCE_DIR LIBRARY_OF_LAW [FLAGS OF THE LIBRARY..]
"""
import pathlib
import re
import subprocess
import sys
import tempfile

TRIAL = r"""
#include <cmath>
#include <cstdio>

#include "law/friction/law_list.hpp"

using namespace slipbench::law;

int failures = 0;
void check(bool holds, const char* what) {
  if (holds) return;
  ++failures;
  std::printf("fails: %s\n", what);
}
bool close(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

int main() {
  const Logarithmic<> own{0.3, -0.01, 0.1};
  const FrictionLaw law = own;
  const auto at = [&](double v) { return evaluate(law, Ambient{}, {.slip_rate = v}); };
  check(close(at(0.9).mu, 0.3 - 0.01 * std::log(10.0), 1e-15), "mu = base + growth ln(1 + V/V_0)");
  check(close(at(0.9).to_slip_rate, -0.01, 1e-14), "dmu/dV = growth/(V_0 + V)");
  check(at(0.9).to_contact_force == 0.0 && !depends_on_contact_force(law), "no force is seen");
  check(depends_on_slip_rate(law) && has_floor(law), "the rate is seen, and there is a floor");
  check(at(1e13).mu > 0.0 && at(1e14).mu == kCoefficientFloor, "the floor holds it at exp(30) V_0");
  check(close(largest(law), 0.3, 1e-15), "the largest is that at rest");
  check(close(steepest_weakening(law), 0.1, 1e-12), "it falls the most at rest");
  check(std::isinf(largest(Logarithmic<>{0.3, 0.01, 0.1})), "what grows for ever has no bound");
  const auto slopes = to_numbers(own, Ambient{}, {.slip_rate = 0.9});
  check(close(slopes[0], 1.0, 0.0), "dmu/dbase");
  check(close(slopes[1], std::log(10.0), 1e-14), "dmu/dgrowth");
  check(close(slopes[2], 0.09, 1e-13), "dmu/dV_0 = -growth V/(V_0 (V_0 + V))");
  // -ln is convex, onto the floor too; times F_N = 1 + x it turns where 1 + x = 2 (V_0 + x).
  const SlipLine line{.end = 1e13, .rate_per_slip = 1.0, .force = 1.0};
  check(next_bend(law, line) == kNoBend, "no bend under a constant force");
  const SlipLine rising{.end = 50.0, .rate_per_slip = 1.0, .force = 1.0, .force_per_slip = 1.0};
  check(close(next_bend(law, rising), 0.8, 1e-9), "a bend under a rising force");
  check(close(range(law).slip_rate, 0.4, 1e-15), "it is drawn to four times its speed");
  return failures;
}
"""


def main(compiler, root, library, *flags):
    root = pathlib.Path(root)
    block = re.search(r"```cpp\n// SPDX-[^\n]*\n// (law/friction/\w+\.hpp)\n([\s\S]*?)```", (root / "CONTRIBUTING.md").read_text())
    law = (root / "law/friction/law_list.hpp").read_text()
    with_entry = law.replace("Stribeck<>,", "Logarithmic<>, Stribeck<>,", 1).replace(
        '#include "law/friction/stribeck.hpp"', f'#include "{block[1]}"\n#include "law/friction/stribeck.hpp"', 1)
    if len(block[2].splitlines()) >= 60 or with_entry.count("Logarithmic<>") != 1:
        print("the law of CONTRIBUTING is to be shorter than 60 lines, and the list to have a place for it")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        for name, text in [(block[1], block[2]), ("law/friction/law_list.hpp", with_entry), ("trial.cpp", TRIAL)]:
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        build = [compiler, *flags, "-std=c++20", "-I", folder, "-I", str(root), f"{folder}/trial.cpp",
                 f"{root}/law/friction/friction_law.cpp", library, "-o", f"{folder}/trial"]
        for command in (build, [f"{folder}/trial"]):
            run = subprocess.run(command, capture_output=True, text=True, check=False)
            if run.returncode != 0:
                print("\n".join((run.stdout + run.stderr).splitlines()[:20]))
                return 1
    print(f"the law of {len(block[2].splitlines())} lines joins the list and does what it says")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
