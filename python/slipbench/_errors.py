# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, as exceptions and warnings."""
import sys
import warnings
from typing import List, NamedTuple


class Message(NamedTuple):
    """A message on the text of a case: where it is, what it says, and what to do."""

    severity: str
    file: str
    line: int
    column: int
    path: str
    message: str
    hint: str
    text: str

    def __str__(self) -> str:
        return self.text


class SlipbenchError(Exception):
    """What slipbench raises."""


class CaseError(SlipbenchError, ValueError):
    """A text that makes no case. `messages` are all its errors and warnings; `file`, `line`, `column`, `path` and `hint`
    those of the first error."""

    def __init__(self, messages):
        self.messages: List[Message] = [one if isinstance(one, Message) else Message(**one) for one in messages]
        errors = [one for one in self.messages if one.severity == "error"] or self.messages
        first = errors[0]
        self.file, self.line, self.column = first.file, first.line, first.column
        self.path, self.hint = first.path, first.hint
        super().__init__("".join(one.text for one in errors).rstrip("\n"))

    def __reduce__(self):
        return (CaseError, (self.messages,))


class RunError(SlipbenchError, RuntimeError):
    """A run that did not come to its end."""


class SlipbenchWarning(UserWarning):
    """What is doubtful about a case; `message` has its place."""

    def __init__(self, text, message=None):
        super().__init__(text)
        self.message = message


def warn(entry) -> None:
    """Issues the warning of a message of the compiled part, at the line that called this package."""
    one = Message(**entry)
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(SlipbenchWarning(one.text.rstrip("\n"), one), stacklevel=level)
