# SPDX-License-Identifier: Apache-2.0
"""The Python blocks of the guide and the tutorials, run in order; and the notebooks, held against their pages.

usage: guide_test.py SLIPBENCH GUIDE_FOLDER [unittest words]   (PYTHONPATH has the module)

On a page a text block right below a Python block is what that prints. A page may use the files that it and those before it in its folder show.
"""
import contextlib
import importlib.util
import io
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

SLIPBENCH, GUIDE = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1)).resolve()
NOTEBOOKS, TUTORIALS = GUIDE.parent / "notebooks", GUIDE.parent / "tutorials"
FENCE = re.compile(r"^```(\w+) ?([^\n]*)\n(.*?)^```\n(?:\n```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)
sys.dont_write_bytecode = True  # beside render.py
os.environ["PATH"] = f"{SLIPBENCH.parent.resolve()}{os.pathsep}{os.environ['PATH']}"

try:
    import matplotlib
    import pandas  # noqa: F401
    import scipy  # noqa: F401
    import xarray  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
matplotlib.use("Agg")


OF_FARMS = "scaling.md"  # its engines are there only with the packages of tests/farm, which runs its examples


def pages(folder):
    """The pages of the guide or of the tutorials, in their order."""
    names = dict.fromkeys(re.findall(r"\]\((\w[\w-]*\.md)\)", (folder / "README.md").read_text()))
    return [folder / name for name in names if name != OF_FARMS]


def render_module():
    spec = importlib.util.spec_from_file_location("render", NOTEBOOKS / "render.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Pages(unittest.TestCase):
    def run_blocks(self, pages):
        """Runs the Python blocks of pages, and holds what they print against what the pages show; how many there are."""
        blocks = 0
        with tempfile.TemporaryDirectory() as folder, in_folder(folder):
            for page in pages:
                names = {"__name__": page.stem}
                for kind, title, body, shown in FENCE.findall(page.read_text()):
                    if kind == "csv" or kind == "yaml" and re.match(r"(case|file) ", title):
                        pathlib.Path(title.split(" ")[-1]).write_text(body)
                    elif kind == "python":
                        printed = io.StringIO()
                        with contextlib.redirect_stdout(printed):
                            exec(compile(body, page.name, "exec"), names)
                        self.assertEqual(printed.getvalue().strip(), shown.strip(), f"{page.name}:\n{body}")
                        blocks += 1
        matplotlib.pyplot.close("all")
        return blocks

    def test_python_blocks_run_and_print_what_the_page_shows(self):
        self.assertGreater(self.run_blocks(pages(GUIDE)), 10)
        self.assertGreater(self.run_blocks(pages(TUTORIALS)), 7)


class Notebooks(unittest.TestCase):
    def test_notebooks_print_what_their_pages_show(self):
        render = render_module()
        count = 0
        with tempfile.TemporaryDirectory() as folder, in_folder(folder):
            for file in sorted(NOTEBOOKS.glob("*.py")):
                if file.name != "render.py":
                    self.assertEqual(render.faults_of(file), [], f"after a change of a notebook: docs/notebooks/render.py {file.stem}")
                    count += 1
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [], "a notebook writes into the folder that it is run in")
        self.assertGreaterEqual(count, 5)

    def test_a_page_with_another_number_or_without_its_picture_is_told(self):
        render = render_module()
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            shutil.copytree(NOTEBOOKS / "images", folder / "images")
            page = (NOTEBOOKS / "first_steps.md").read_text()
            (folder / "first_steps.md").write_text(page.replace("run 6.4000 N mm", "run 6.5000 N mm"))
            (folder / "images/first_steps_2.svg").unlink()
            changed, missing = render.faults_of(NOTEBOOKS / "first_steps.py", folder)
        self.assertIn("-run 6.5000 N mm", changed)
        self.assertIn("+run 6.4000 N mm", changed)
        self.assertIn("first_steps_2.svg", missing)


@contextlib.contextmanager
def in_folder(folder):
    """Works in a folder, and then where it was before."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


if __name__ == "__main__":
    unittest.main(verbosity=1)
