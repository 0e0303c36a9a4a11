"""graze.fit: parameters of the scene from measurements."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from .command import command, result_kind
from .measurements import MeasuredLike
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("fit")
class Fit(Result):
    """Fitted parameters, a list of them; tables "parameters" and "fit" (a measured value a row, SI
    units)."""

    main_table = "parameters"


@command("fit")
def fit(
    scene: SceneLike,
    data: MeasuredLike,
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
    """Identifies parameters of the scene from measurements: `parameter` names them with the values
    between which each is sought, {"stop.spring.stiffness": (1e6, 1e9)}.

    `data` is a file (CSV), a DataFrame, or a dict of arrays (any mapping from names of columns, or a
    structured array), in SI units: speed and restitution; time and stop of impacts; or time and
    force1, gap1, displacement1, velocity1, penetration1, q1, qdot1, ..
    """
    raise NotImplementedError  # the decorator does it
