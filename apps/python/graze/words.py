"""Types of keywords that several functions have."""

from __future__ import annotations

import os
from typing import Callable, Optional, Union

from .scene import SceneLike, Settings

PathLike = Union[str, "os.PathLike[str]"]
#: True for a line on stderr, or a function that is told a number from 0 to 1.
Progress = Union[None, bool, Callable[[float], object]]

__all__ = ["Optional", "PathLike", "Progress", "SceneLike", "Settings"]
