"""Results in folders: read again, and joined of shares."""

from __future__ import annotations

import os
from typing import Any, List

from . import _core
from .result import Result, wrapped
from .scene import Scene
from .words import PathLike


def view(folder: PathLike) -> Result:
    """The result that `out` left in a folder, with its tables, document and
    pictures; nothing is computed again. How it ended says `outcome`. Events and samples of a run are
    the tables in its folder.

    Raises FileError where the folder holds no whole result of this version.
    """
    return _stored(["view", "--", os.fspath(folder)], folder)


def merge(*folders: PathLike, out: PathLike) -> Result:
    """Joins the shares (shard="1/3" and so on) of a diagram, map or comparison in these folders to the
    result of the whole, as it would be of one call, and writes it into the folder `out`.

    Raises OptionError where shares are missing, and says which.
    """
    return _stored(["merge", "--out", os.fspath(out), "--", *(os.fspath(folder) for folder in folders)], out)


def _stored(words: List[str], folder: PathLike) -> Any:
    found = _core.run_bare(words)
    # Files that a scene names are looked for beside it.
    scene = Scene.parse(found.scene_text, os.path.join(os.fspath(folder), "scene.toml"))
    return wrapped(found, scene)
