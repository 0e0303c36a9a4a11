"""graze.compare: motions of a scene and the same with another choice, side by side."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("comparison")
class Comparison(Result):
    """Motions side by side: tables "comparison" and "first_impacts" (time in s, speed in m/s)."""

    main_table = "comparison"


@result_kind("comparison_map")
class ComparisonMap(Result):
    """Two motions over a plane of two parameters: table "comparison"."""

    main_table = "comparison"


@result_kind("sensitivity")
class Sensitivity(Result):
    """s1 and s2 of the probes over a parameter: table "sensitivity"."""

    main_table = "sensitivity"


@command("compare")
def compare(
    scene: SceneLike,
    *,
    against: Union[None, str, Sequence[str], Mapping[str, Any]] = None,
    modes: Union[None, str, Tuple[int, int]] = None,
    sensitivity: bool = False,
    show: str = "attractor",
    parameter: Optional[str] = None,
    from_: Optional[float] = None,
    to: Optional[float] = None,
    points: int = 21,
    second: Optional[str] = None,
    second_from: Optional[float] = None,
    second_to: Optional[float] = None,
    second_points: int = 21,
    second_values: Optional[Sequence[float]] = None,
    reference: Optional[float] = None,
    first: int = 20,
    within: float = 0.01,
    duration: Optional[float] = None,
    last: Optional[float] = None,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    periods: int = 1000,
    samples: int = 100,
    resume: bool = False,
    restart_work: bool = False,
    shard: Optional[str] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Union[Comparison, ComparisonMap, Sensitivity]:
    """Compares motions: `against` another choice {"beam.discretisation": "galerkin"}, with `modes` (1, 8),
    over a plane of two parameters, or by `sensitivity` to a parameter.
    """
    raise NotImplementedError  # the decorator does it
