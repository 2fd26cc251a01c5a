#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The recipes of packaging/ and the workflows, as far as they can be judged without Docker, Spack and conda: recipes_test.py SOURCE

They can be read, they name what scripts/packages.txt does, by packaging/names.txt, in the versions that its words want, they build the
version of CMakeLists.txt, and the scripts that they call are there.
"""
import ast
import pathlib
import re
import sys

import yaml

SOURCE = pathlib.Path(sys.argv[1])
PACKAGING = SOURCE / "packaging"
failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def lines(file):
    return [line.split(maxsplit=4) for line in (SOURCE / file).read_text().splitlines() if line and not line.startswith("#")]


def wanted_versions():
    """{Debian's name: the least version that scripts/packages.txt asks for, or ""}"""
    texts = [line for line in (SOURCE / "scripts/packages.txt").read_text().splitlines() if not line.startswith("#")]
    found = {}
    for text in texts:
        name, words = text.split(maxsplit=1)
        version = re.match(r"[A-Za-z:+.\d-]*?[ -](\d+(?:\.\d+)*)", words)
        found[name] = version[1] if version else ""
    return found


version = re.search(r"project\(slipbench VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]
wanted = wanted_versions()
names = {debian: (spack, conda, use) for debian, spack, conda, use, *_ in lines("packaging/names.txt")}
expect(set(names) == set(wanted), f"packaging/names.txt and scripts/packages.txt differ in {sorted(set(names) ^ set(wanted))}")

# Spack: the class is read, not run.
spack = {}
for call in ast.walk(ast.parse((PACKAGING / "spack/package.py").read_text())):
    if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "depends_on":
        name, _, least = call.args[0].value.partition("@")
        spack[name] = least.partition(":")[0]
    elif isinstance(call, ast.Call) and getattr(call.func, "id", "") == "version":
        expect(call.args[0].value == version, f"packaging/spack/package.py: version {call.args[0].value}, CMakeLists.txt has {version}")
expected = {one: debian for debian, (one, _, _) in names.items() if one != "-"}
expect(set(spack) == set(expected) | {"cxx"}, f"packaging/spack/package.py: differs from names.txt in {sorted(set(spack) ^ set(expected) ^ {'cxx'})}")

# conda: no templates but the compiler's.
recipe = yaml.safe_load((PACKAGING / "conda/meta.yaml").read_text())
expect(recipe["package"]["version"] == version, f"packaging/conda/meta.yaml: version {recipe['package']['version']}, CMakeLists.txt has {version}")
needs = {use: {} for use in ("build", "host", "run")}
for use, entries in recipe["requirements"].items():
    for entry in entries:
        name, _, least = entry.partition(" ")
        needs[use]["cxx-compiler" if "compiler('cxx')" in entry else name] = re.sub(r"^>=|,.*", "", least) if "{" not in entry else ""
for use in needs:
    want = {one for _, (_, one, where) in names.items() if one != "-" and where == use} | ({"python"} if use == "run" else set())
    expect(set(needs[use]) == want, f"packaging/conda/meta.yaml: {use} differs from names.txt in {sorted(set(needs[use]) ^ want)}")
for debian, (one, other, use) in names.items():
    least = wanted[debian]
    for where, told in (("spack/package.py", spack.get(one)), ("conda/meta.yaml", needs.get(use, {}).get(other))):
        expect(told is None or told == least, f"packaging/{where}: {debian} from {told} on, scripts/packages.txt says {least or 'nothing'}")

# The image and the workflow: what they call is there, and no list of packages of their own.
docker = (PACKAGING / "Dockerfile").read_text()
release = yaml.safe_load((SOURCE / ".github/workflows/release.yml").read_text())
steps = [step for job in release["jobs"].values() for step in job["steps"]]
called = {path for text in (docker, *(step.get("run", "") for step in steps)) for path in re.findall(r"(?:scripts|tests|packaging)/[\w./]+", re.sub(r"#.*", "", text))}
expect({"scripts/package.sh", "tests/packages/minimal_debian.sh", "tests/packages/bare_root.sh", "packaging/Dockerfile"} <= called, f"only {sorted(called)} are called")
for path in called:
    expect((SOURCE / path).exists(), f"{path} is called and is not there")
for package in re.findall(r"apt-get install [^&\\]*?([\w.+-]+)\s*(?:\\|&|$)", docker):
    expect(package in names, f"packaging/Dockerfile: {package} is no package of scripts/packages.txt")
expect("attestations" in release["jobs"]["release"]["permissions"] and any("attest-build-provenance" in step.get("uses", "") for step in steps), "no provenance")
nightly = yaml.safe_load((SOURCE / ".github/workflows/nightly.yml").read_text())["jobs"]["part"]
parts = re.search(r"^parts=\((.*)\)$", (SOURCE / "scripts/nightly.sh").read_text(), re.MULTILINE)[1].split()
expect(nightly["strategy"]["matrix"]["part"] == parts, f"nightly.yml runs other parts than scripts/nightly.sh has: {parts}")
expect(any(step.get("run", "").startswith("scripts/nightly.sh ${{ matrix.part }}") for step in nightly["steps"]), "nightly.yml runs no part")
for message in failures:
    print(message, file=sys.stderr)
print(f"recipes: {len(names)} packages, {len(failures)} failures")
sys.exit(1 if failures else 0)
