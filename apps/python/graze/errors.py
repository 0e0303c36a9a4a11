"""What goes wrong, as exceptions. All of them are a graze.Error."""

from __future__ import annotations

import re
from typing import Any, Optional


class Error(Exception):
    """Anything that Graze could not do. What its sentence calls as the program does, "--from", it
    calls as the package does, "from_"."""

    def __init__(self, sentence: str = "") -> None:
        super().__init__(re.sub(r"--([a-z][a-z-]*)", _as_keyword, sentence))


class SceneError(Error, ValueError):
    """A scene that cannot be used.

    `file`, `line` and `column` say where, counting from 1; they are None where what is wrong has no
    place in a file.
    """

    file: Optional[str] = None
    line: Optional[int] = None
    column: Optional[int] = None


class OptionError(Error, ValueError):
    """An argument that cannot be used, or does not go with the others."""


class FileError(Error, OSError):
    """A file or folder that cannot be read or written."""


class NumericsError(Error, ArithmeticError):
    """The numerics could not do what was asked. `result` holds what was reached, or is None."""

    def __init__(self, sentence: str, result: Any = None) -> None:
        super().__init__(sentence)
        self.result = result


class GrazeWarning(UserWarning):
    """What is to be known of a result that was computed all the same."""


def _as_keyword(option: "re.Match[str]") -> str:
    name = option.group(1).replace("-", "_")
    return name + "_" if name in ("from", "continue") else name
