"""graze.fit: parameters of the scene from measurements."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("fit")
class Fit(Result):
    """Fitted parameters: tables "parameters" and "fit" (a measured value a row, SI units)."""

    main_table = "parameters"


@command("fit")
def fit(
    scene: SceneLike,
    data: PathLike,
    *,
    parameter: Union[None, str, Sequence[str], Mapping[str, Tuple[float, float]]] = None,
    column: Union[None, str, Sequence[str]] = None,
    sigma: Union[None, float, str, Sequence[Any], Mapping[str, float]] = None,
    algorithm: str = "local",
    max_evaluations: int = 5000,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Fit:
    """Identifies parameters of the scene from measurements in the file `data` (CSV): `parameter` names
    them with the values between which each is sought, {"stop.spring.stiffness": (1e6, 1e9)}.
    """
    raise NotImplementedError  # the decorator does it
