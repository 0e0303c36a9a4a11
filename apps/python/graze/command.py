"""Functions whose keywords are the options of the program's commands."""

from __future__ import annotations

import inspect
import numbers
import os
import sys
import textwrap
import warnings
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence

from . import _core
from .errors import GrazeWarning, NumericsError, OptionError, did_you_mean, in_python
from .measurements import table_text
from .result import wrapped
from .scene import scene_from, toml_value

_POSITIONAL, _KEYWORD = inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY
#: Headings of options that are asked of a result afterwards: how it is printed, what its picture shows.
_AFTERWARDS = {"Output", "Pictures"}
#: Headings of options that many commands have; a function's own keywords come first.
_SHARED = {"Scene", "Numerics and limits", "Long work", *_AFTERWARDS}
_PATH, _SETTINGS = "Union[None, str, os.PathLike[str]]", "Settings"
#: What values of these placeholders may be besides words.
_TYPES = {
    "DIR": _PATH, "FILE": _PATH, "FILE|DIR": _PATH, "A:B": "Union[None, str, Tuple[int, int]]",
    "K|any": "Union[None, int, str]",
}
_KINDS = {"flag": "bool", "whole": "int", "number": "float", "word": "str"}


def command(
    of: str,
    returns: Any,
    text: str,
    *,
    name: str = "",
    without: Sequence[str] = (),
    required: Sequence[str] = (),
    unless_given: Mapping[str, Any] = {},
) -> Callable[..., Any]:
    """A function that does the command `of` the program, with its options as keywords but those of `without`,
    and what they mean in its docstring after `text`. `required`, `unless_given`: keywords that the
    function needs, and defaults that it has, where the command does otherwise."""
    options = {
        keyword(option["name"]): {**option, "required": option["required"] or option["name"] in required}
        for option in _core.options(of)
        if (option["heading"] not in _AFTERWARDS or option["name"] == "out")
        and option["name"] not in (*without, "parameters")
    }
    signature = _signature(options, of == "fit", returns, unless_given)
    known = signature.parameters
    needed = [key for key, option in options.items() if option["required"]]

    def run(scene: Any, *data: Any, **given: Any) -> Any:
        for key in given:
            if key not in known:
                near = did_you_mean(key + "_" if key + "_" in known else key, known)
                raise TypeError(f"graze.{run.__name__} has no keyword {key!r}{near}")
        if "data" in given and not data:
            data = (given.pop("data"),)
        if len(data) != ("data" in known) or not all(key in given for key in needed):
            signature.bind(scene, *data, **given)  # says what is wrong
        return _run(of, scene, data, {**unless_given, **given}, options)

    run.__name__ = run.__qualname__ = name or keyword(of)
    run.__module__ = "graze"
    run.__doc__ = _documented(text, signature, options)
    setattr(run, "__signature__", signature)
    return run


def keyword(option: str) -> str:
    """An option of the program as a keyword."""
    return option + "_" if option in ("from", "continue") else option


def _signature(
    options: Mapping[str, Any], takes_data: bool, returns: Any, unless_given: Mapping[str, Any]
) -> inspect.Signature:
    """The scene, and keywords: those that are required first, then the function's own."""
    listed = [inspect.Parameter("scene", _POSITIONAL, annotation="SceneLike")]
    if takes_data:
        listed.append(inspect.Parameter("data", _POSITIONAL, annotation="MeasuredLike"))
    ordered = sorted(options, key=lambda key: (not options[key]["required"], options[key]["heading"] in _SHARED))
    for key in ordered:
        default = unless_given.get(key, _default(options[key]))
        kind = _type(options[key], default)
        listed.append(inspect.Parameter(key, _KEYWORD, default=default, annotation=kind))
    listed.append(inspect.Parameter("progress", _KEYWORD, default=None, annotation="Progress"))
    return inspect.Signature(listed, return_annotation=returns)


def _default(option: Mapping[str, Any]) -> Any:
    if option["required"]:
        return inspect.Parameter.empty
    if option["kind"] == "flag":
        return False
    as_kind = {"whole": int, "number": float, "word": str}[option["kind"]]
    return as_kind(option["default"]) if option["default"] else None


def _type(option: Mapping[str, Any], default: Any) -> str:
    kind = _KINDS[option["kind"]]
    if option["name"] == "set":
        return _SETTINGS
    if option["repeated"]:
        return "Union[None, float, str, Sequence[Any], Mapping[str, Any]]"
    if option["several"]:
        return f"Union[None, {kind}, Sequence[{kind}]]"
    if option["placeholder"] in _TYPES:
        return _TYPES[option["placeholder"]]
    return kind if default is not None else f"Optional[{kind}]"


def _run(name: str, scene: Any, data: Any, values: Dict[str, Any], options: Mapping[str, Any]) -> Any:
    given = scene_from(scene, values.pop("set", None))
    progress = _progress_of(name, values.pop("progress", None))
    words = [name, "scene"]
    table: Optional[str] = None
    if data:
        if isinstance(data[0], (str, os.PathLike)):
            file = os.fspath(data[0])
            words.append(file if not file.startswith("-") else os.path.join(".", file))
        else:
            words.append("measurements")
            table = table_text(data[0])
    for key, value in values.items():
        words += option_words(key, value, options[key]["repeated"])
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


def option_words(key: str, value: Any, is_repeated: bool = False) -> List[str]:
    """An option as words of a command line; one that is repeated has each of its values by itself."""
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
    if is_repeated:
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


def _documented(text: str, signature: inspect.Signature, options: Mapping[str, Any]) -> str:
    lines = [inspect.cleandoc(text), "", "Keywords:"]
    for key, parameter in signature.parameters.items():
        what = _TOLD.get(key) or in_python(options[key]["what"] if key in options else "")
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
