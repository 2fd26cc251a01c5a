# SPDX-License-Identifier: Apache-2.0
"""Four threads at once in all that lets other threads go on: runs, updates of a law that they share, sweeps, checks.

usage: threads.py [SECONDS]   (PYTHONPATH has the module; scripts/threads.sh runs it under ThreadSanitizer)
"""
import sys
import threading
import time

import numpy

import slipbench

SECONDS = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0
SLOT = {
    "slipbench": 1,
    "title": "slot",
    "parameters": {"mu": 0.2},
    "connector": {"type": "SLOT"},
    "friction": [{"predefined": {}, "coefficient": {"columns": ["mu", "slip_rate"], "rows": [[0.3, 0], [0.2, 10]]}, "stick": {"stiffness": 1000}}],
    "history": [{"step": "a", "increments": 400, "motion": {"CP1": {"sine": {"amplitude": 3, "period": 0.5}}}, "force": {"f2": "= 500*mu"}}],
    "checks": [{"name": "pressed", "quantity": "FN", "against": {"expression": "= 500*mu"}, "tolerance": {"relative": 1e-12, "why": "rounding"}}],
}
case = slipbench.load(SLOT)
law = slipbench.Law({key: SLOT[key] for key in ("connector", "friction", "parameters")})
states, motion = law.initial_state(200), numpy.linspace(0, 0.1, 1200).reshape(200, 6)
wanted = law.update(states, motion, [0, 100, 0, 0, 0, 0], tangent=True).force
limits = case.run()["FLIM"]
faults, rounds = [], [0] * 4
end = time.monotonic() + SECONDS


def work(index):
    try:
        own = case.with_parameters(mu=0.2)
        while time.monotonic() < end or rounds[index] == 0:
            run = own.run()
            assert run.passed and numpy.array_equal(run["FLIM"], limits)
            assert len(run.events) > 0 and run.document["summary"]
            assert numpy.array_equal(law.update(states, motion, [0, 100, 0, 0, 0, 0], tangent=True).force, wanted)
            one = law.update(states[0], motion[-1], [0, 100, 0, 0, 0, 0])
            assert one.force.shape == (6,) and law.numbers.size > 0
            swept = slipbench.sweep(case, {"peak": {"max": "FLIM"}}, mu=numpy.linspace(0.1, 0.3, 8), threads=2)
            assert not swept.failures
            own.parameters["mu"] = 0.2
            rounds[index] += 1
    except BaseException as fault:  # of a thread nobody else hears
        faults.append(repr(fault))


threads = [threading.Thread(target=work, args=(index,)) for index in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(f"rounds of the threads: {rounds}")
if faults:
    sys.exit("\n".join(faults))
