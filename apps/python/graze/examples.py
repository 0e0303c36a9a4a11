"""Files of the examples, which come with the package."""

from __future__ import annotations

import pathlib

from .errors import unknown_name

_DATA = pathlib.Path(__file__).resolve().parent / "data"


def example(name: str) -> str:
    """The path of a file of the examples: example("scenes/05_wagg_one_mode.toml"). Raises NoSuchName, which
    tells the nearest."""
    if not (_DATA / name).is_file():
        known = (path.relative_to(_DATA).as_posix() for path in sorted(_DATA.glob("*/*.*")))
        raise unknown_name("example", name, known)
    return str(_DATA / name)
