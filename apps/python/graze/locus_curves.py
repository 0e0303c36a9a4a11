"""graze.loci: loci of special points over two parameters."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from .command import command, result_kind
from .result import Result
from .table import Table
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("loci")
class Loci(Result):
    """Loci, each a table of its points; all of them in the table "loci", points of codimension two in
    "special" (value, second in the parameters' units), and "regions"."""

    main_table = "loci"
    asked_by = {"regions": "regions=100"}

    def _list(self) -> Sequence[Table]:
        return self._by("locus")


@command("continue", locus="all")
def loci(
    scene: SceneLike,
    *,
    parameter: str,
    from_: float,
    to: float,
    second: str,
    second_from: float,
    second_to: float,
    locus: Union[str, Sequence[str]] = "all",
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    period: int = 1,
    virtual: bool = False,
    start: Union[None, str, Sequence[str]] = None,
    random_seed: int = 1,
    max_step: Optional[float] = None,
    impacts: Optional[int] = None,
    follow: str = "none",
    depth: int = 2,
    slices: int = 8,
    regions: Optional[int] = None,
    restart: Optional[PathLike] = None,
    label: Optional[str] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Loci:
    """Traces loci of special points (LP, PD, NS, GR, CH) over two parameters of the scene."""
    raise NotImplementedError  # the decorator does it
