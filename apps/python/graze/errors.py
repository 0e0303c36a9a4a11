"""What goes wrong, as exceptions. All of them are a graze.Error."""

from __future__ import annotations

import re
from difflib import get_close_matches
from typing import Any, Iterable, Optional


_COMMANDS = "check|modes|simulate|orbit|continue|diagram|map|merge|view|cost|fit|compare"


class Error(Exception):
    """Anything that Graze could not do. What its sentence calls as the program does, "--from", it
    calls as the package does, "from_"."""

    def __init__(self, sentence: str = "") -> None:
        super().__init__(in_python(sentence))


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


class NoSuchName(Error, KeyError):
    """A table, column or value that a result does not have."""

    __str__ = Exception.__str__  # that of KeyError puts the sentence in quotes


class GrazeWarning(UserWarning):
    """What is to be known of a result that was computed all the same."""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Behind what says that there is no such name: the nearest that there is."""
    near = get_close_matches(name, list(known), 1)
    return f"; did you mean {near[0]!r}?" if near else ""


def unknown_name(what: str, name: Any, known: Iterable[str]) -> NoSuchName:
    """What is raised for it, with all names where none is near."""
    names = [str(one) for one in known]
    near = did_you_mean(str(name), names)
    others = f"; there is {', '.join(names)}" if names else "; there is none"
    return NoSuchName(f"there is no {what} {name!r}{near or others}")


def in_python(sentence: str) -> str:
    """What the program says of its options and commands, of keywords and functions."""
    sentence = re.sub(r"--([a-z][a-z-]*)", _as_keyword, sentence)
    sentence = re.sub(rf"\bgraze ({_COMMANDS})\b", lambda at: f"graze.{_keyword(at.group(1))}", sentence)
    sentence = sentence.replace("several, separated by commas", "one or a list of them")
    return sentence.replace("separated by commas", "a list")


def _as_keyword(option: "re.Match[str]") -> str:
    return _keyword(option.group(1))


def _keyword(option: str) -> str:
    name = option.replace("-", "_")
    return name + "_" if name in ("from", "continue") else name
