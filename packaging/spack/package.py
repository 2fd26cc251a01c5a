# SPDX-License-Identifier: Apache-2.0
"""slipbench for Spack, of a clone: `spack repo create repo slipbench`, this file as repo/packages/slipbench/package.py, then
`spack dev-build -d CLONE slipbench@0.1.0 chart_js=/path/to/chart.min.js`. Not tried: no Spack where this was written.
"""
import os

from spack.package import *


class Slipbench(CMakePackage):
    """A test bench for connector friction: Abaqus connectors, Radioss contacts, stick and slip."""

    version("0.1.0")
    license("Apache-2.0")

    variant("python", default=True, description="Build the Python module")
    variant("chart_js", default="none", values=lambda given: given == "none" or os.path.isabs(given), description="chart.min.js of Chart.js 3, which report pages carry along")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.4:3")
    depends_on("yaml-cpp@0.7:")
    depends_on("fmt@9:")
    depends_on("cli11@2:")
    depends_on("tl-expected@1:")
    depends_on("muparser@2.3:")
    depends_on("udunits@2:")
    depends_on("gsl@2:")
    depends_on("libmd@1:")
    depends_on("minizip@1:")
    depends_on("gnuplot@5.4:", type="run")
    with when("+python"):
        depends_on("python@3.9:", type=("build", "link", "run"))
        depends_on("py-pybind11@2.10:")
        depends_on("py-numpy", type=("build", "run"))
        extends("python")

    generator("ninja")
    conflicts("%gcc@:11", msg="C++20: g++ 12 or later")

    def cmake_args(self):
        given = [
            self.define("SLIPBENCH_BUILD_TESTS", False),
            self.define("SLIPBENCH_BUILD_BENCH", False),
            self.define_from_variant("SLIPBENCH_PYTHON", "python"),
        ]
        if self.spec.variants["chart_js"].value != "none":
            given.append(self.define_from_variant("SLIPBENCH_CHART_JS", "chart_js"))
        if self.spec.satisfies("+python"):
            given.append(self.define("SLIPBENCH_PYTHON_DIR", python_platlib))
        return given
