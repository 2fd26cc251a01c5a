# SPDX-License-Identifier: Apache-2.0
"""Commands with their exit code and everything that they say on standard error, kept as text and tried again.

An .expected file has one command or several:

    # What is wrong, where the command alone does not say it.
    $ slipbench check wrong_case.yaml
    exit 2
    wrong_case.yaml:8:5: error: friction[0].Coefficient: unknown key; did you mean 'coefficient'?
    ...

Commands are for bash; one that goes on in further lines has '> ' before each of them. `slipbench` is the program that
is tested, and `unprivileged` before a command lets access rights hold for root, too.
"""

import dataclasses
import os
import pathlib
import signal
import subprocess
import tempfile
import threading

SECONDS = 20 * int(os.environ.get("SLIPBENCH_PATIENCE", 1))  # a command that takes longer hangs
PRELUDE = """unprivileged() {
  if [ $EUID = 0 ]; then setpriv --bounding-set=-dac_override,-dac_read_search,-fowner "$@"; else "$@"; fi
}
"""


@dataclasses.dataclass
class Entry:
    comments: list
    command: str
    code: int = None
    said: str = ""


@dataclasses.dataclass
class Outcome:
    code: int
    said: str
    seconds: float  # of processor time
    megabytes: float


def read(text):
    """The entries of an .expected file."""
    entries, comments = [], []
    lines = text.rstrip("\n").split("\n")
    for n, line in enumerate(lines):
        # Lines with '#' are comments if a command follows them: the program may say such lines as well.
        after = next((later for later in lines[n:] if not later.startswith("# ")), "")
        if line.startswith("$ "):
            entries.append(Entry(comments, line[2:]))
            comments = []
        elif line.startswith("# ") and after.startswith("$ "):
            comments.append(line)
        elif entries and entries[-1].code is None:
            if line.startswith("> "):
                entries[-1].command += "\n" + line[2:]
            else:
                entries[-1].code = int(line.removeprefix("exit "))
        elif entries:
            entries[-1].said += line + "\n"
    for entry in entries[:-1]:
        entry.said = entry.said.removesuffix("\n")  # the blank line before the next one
    return entries


def write(entries):
    return "\n".join("".join([*(f"{comment}\n" for comment in entry.comments),
                              "$ " + entry.command.replace("\n", "\n> ") + "\n", f"exit {entry.code}\n", entry.said])
                     for entry in entries)


class Stage:
    """Where commands are tried: every one with the same environment, whoever's machine it is."""

    def __init__(self, program, folder):
        # What is the user's own and may change what the program says.
        odd = ("GITHUB_", "LC_", "SLIPBENCH", "XDG_", "COLUMNS", "LINES", "LANG", "TERM", "NO_COLOR", "CLICOLOR")
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith(odd)}
        home = pathlib.Path(folder) / "home"
        home.mkdir()
        self.environment.update(HOME=str(home), PATH=f"{pathlib.Path(program).parent}:{os.environ['PATH']}")

    def execute(self, command, folder):
        # A build with counters says which of them do not fit into a file, and leaves them cut off.
        counters = {"GCOV_PREFIX": self.environment["HOME"], "GCOV_ERROR_FILE": "/dev/null"} if "ulimit -f" in command else {}
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen(["bash", "-c", PRELUDE + command], cwd=folder, env={**self.environment, **counters},
                                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=said,
                                       start_new_session=True)
            clock = threading.Timer(SECONDS, os.killpg, (process.pid, signal.SIGKILL))
            clock.start()
            _, status, usage = os.wait4(process.pid, 0)
            clock.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            said.seek(0)
            # What cannot be shown in UTF-8 is shown as \x..: the program is never to say such a thing.
            text = said.read().decode(errors="backslashreplace")
        code = process.returncode if process.returncode >= 0 else 128 - process.returncode
        return Outcome(code, text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
