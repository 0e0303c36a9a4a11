"""Functions whose keywords are the options of the program's commands."""

from __future__ import annotations

import functools
import inspect
import numbers
import os
import sys
import textwrap
import warnings
from typing import Any, Callable, Dict, List, Mapping, Optional, Type, TypeVar

from . import _core
from .errors import GrazeWarning, NumericsError, OptionError, did_you_mean, in_python
from .measurements import table_text
from .result import Result
from .scene import scene_from, toml_value

Function = TypeVar("Function", bound=Callable[..., Any])

#: Options that are given once for each of their values; others take them with commas.
_REPEATED = {"against", "parameter", "sigma"}
#: Keywords that are none of the program's options.
_OWN = {"scene", "data", "set", "progress"}

_kinds: Dict[str, Type[Result]] = {}


def result_kind(kind: str) -> Callable[[Type[Result]], Type[Result]]:
    """The class of results that the compiled part calls so."""

    def register(made: Type[Result]) -> Type[Result]:
        _kinds[kind] = made
        return made

    return register


def command(name: str, **unless_given: Any) -> Callable[[Function], Function]:
    """A function whose signature names options of a command of the program. Its docstring ends with
    what they mean. `unless_given`: options that the function has and the program
    does not."""

    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        known = set(signature.parameters)
        takes_data = "data" in known

        @functools.wraps(function)
        def run(scene: Any, *data: Any, **options: Any) -> Any:
            for key in options:
                if key not in known:
                    near = did_you_mean(key + "_" if key + "_" in known else key, known)
                    raise TypeError(f"graze.{function.__name__} has no keyword {key!r}{near}")
            if takes_data and not data and "data" in options:
                data = (options.pop("data"),)
            missing = [
                key
                for key, parameter in signature.parameters.items()
                if parameter.default is parameter.empty and key not in _OWN and key not in options
            ]
            if missing or len(data) != takes_data:
                signature.bind(scene, *data, **options)  # says what is wrong
            return _run(name, scene, data, {**unless_given, **options})

        run.__doc__ = _documented(name, function.__doc__ or "", signature)
        return run  # type: ignore[return-value]

    return decorate


def _run(name: str, scene: Any, data: Any, options: Dict[str, Any]) -> Any:
    given = scene_from(scene, options.pop("set", None))
    progress = _progress_of(name, options.pop("progress", None))
    words = [name, "scene"]
    table: Optional[str] = None
    if data:
        if isinstance(data[0], (str, os.PathLike)):
            file = os.fspath(data[0])
            words.append(file if not file.startswith("-") else os.path.join(".", file))
        else:
            words.append("measurements")
            table = table_text(data[0])
    for key, value in options.items():
        words += option_words(key, value)
    try:
        found = _core.run(words, given._named, progress, table)
    except BaseException as error:  # Ctrl-C, or what `progress` raised
        reached = getattr(error, "result", None)
        if isinstance(reached, _core.FoundResult):
            setattr(error, "result", wrapped(reached, given))
        raise
    result = wrapped(found, given)
    if result is None:
        return None
    for warning in result.warnings:
        warnings.warn(warning, GrazeWarning, stacklevel=3)
    if result.message:
        raise NumericsError(result.message, result)
    return result


def wrapped(found: "_core.FoundResult", scene: Any) -> Optional[Result]:
    """The result in the class of its kind."""
    return _kinds[found.kind](found, scene) if found.kind is not None else None


def option_words(key: str, value: Any) -> List[str]:
    """An option as words of a command line."""
    option = "--" + key.rstrip("_").replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, Mapping):
        return [f"{option}={name}={_entry(key, entry)}" for name, entry in value.items()]
    if option == "--modes" and isinstance(value, (tuple, range)):
        value = f"{value[0]}:{value[-1]}"
    if hasattr(value, "tolist"):  # NumPy
        value = value.tolist()
    if not isinstance(value, (list, tuple, set, frozenset)):
        return [f"{option}={_text(key, value)}"]
    if key in _REPEATED:
        return [f"{option}={_text(key, entry)}" for entry in value]
    return [f"{option}={','.join(_text(key, entry) for entry in value)}"]


def _text(key: str, value: Any) -> str:
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        text = os.fspath(value)
        if isinstance(text, str):
            return text
    raise TypeError(f"{key}: a number, a word or a list of such is wanted, not {type(value).__name__}")


def _entry(key: str, value: Any) -> str:
    if isinstance(value, tuple) and len(value) == 2:  # a range
        return f"{_text(key, value[0])}:{_text(key, value[1])}"
    return toml_value(value) if key == "against" else _text(key, value)


def _progress_of(name: str, progress: Any) -> Optional[Callable[[float], None]]:
    if progress is None or progress is False:
        return None
    if progress is not True:
        if not callable(progress):
            raise OptionError("progress: True or a function of a number from 0 to 1 is wanted")
        return progress

    return _line_of(name) if sys.stderr.isatty() else _tenths_of(name)


def _line_of(name: str) -> Callable[[float], None]:
    """One line of a terminal, written over and over."""

    def show(fraction: float) -> None:
        end = "\r\033[K" if fraction >= 1.0 else ""
        sys.stderr.write(f"\r{name} {100.0 * fraction:3.0f} %\033[K{end}")
        sys.stderr.flush()

    return show


def _tenths_of(name: str) -> Callable[[float], None]:
    """A line for every tenth, for a file, a pipe or a notebook."""
    told = 0

    def show(fraction: float) -> None:
        nonlocal told
        if int(10.0 * fraction) > told:
            told = int(10.0 * fraction)
            sys.stderr.write(f"{name} {10 * told} %\n")
            sys.stderr.flush()

    return show


#: In place of what the program says of its options.
_TOLD = {
    "set": 'keys of the scene to replace or add, {"stop.gap": 2e-3}',
    "progress": "True for a line on stderr, or a function that is called with a number from 0 to 1",
}


def _documented(name: str, text: str, signature: inspect.Signature) -> str:
    told = {option.replace("-", "_"): what for option, what, _, _ in _core.options(name)}
    lines = [inspect.cleandoc(text), "", "Keywords:"]
    for key, parameter in signature.parameters.items():
        what = _TOLD.get(key) or in_python(told.get(key.rstrip("_"), ""))
        if not what:
            continue
        what = what[0].lower() + what[1:] if what[1:2].islower() else what
        default = parameter.default
        if "default" not in what and default is not parameter.empty and default not in (None, False):
            what += f" (default: {default!r})"
        lines += textwrap.wrap(
            f"{key}: {what}", 96, initial_indent="    ", subsequent_indent="        "
        )
    return "\n".join(lines) + "\n"
