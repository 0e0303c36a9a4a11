"""graze.continuation: solutions of F(u, p) = 0 for a function of your own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from .errors import NumericsError, OptionError

Numbers = Union[float, Sequence[float], np.ndarray]


@dataclass(frozen=True)
class SpecialPoint:
    """A fold ("LP") or branch point ("BP")."""

    label: str
    p: float
    u: np.ndarray
    after: int  #: it lies between points `after` and `after + 1` of the branch


class Branch:
    """Solutions in order along their branch: `p` (n), `u` (n, unknowns), in the units of F."""

    def __init__(self, found: dict) -> None:
        self.p: np.ndarray = found["p"]
        self.u: np.ndarray = found["u"]
        self.special: List[SpecialPoint] = [SpecialPoint(**point) for point in found["special"]]
        #: Why it ends at either end: "parameter_limit", "closed", "step_limit", "not_converged", ..
        self.ends: Tuple[str, str] = found["ends"]
        self.evaluations: int = found["evaluations"]

    @property
    def is_closed(self) -> bool:
        return self.ends[1] == "closed"

    def to_pandas(self) -> Any:
        """A DataFrame with columns p, u1, u2, .."""
        import pandas

        columns = {f"u{i + 1}": self.u[:, i] for i in range(self.u.shape[1])}
        return pandas.DataFrame({"p": self.p, **columns})

    def plot(self, axes: Any = None, unknown: int = 0) -> Any:
        """An unknown over the parameter, with the special points; returns the Figure."""
        from .equation_plot import plot_equations

        return plot_equations(self, unknown, axes)

    def __repr__(self) -> str:
        labels = ", ".join(f"{point.label} at {point.p:.6g}" for point in self.special)
        return f"<graze.Branch: {len(self.p)} points, {labels or 'no special points'}>"

    def _repr_html_(self) -> str:
        from .table import html_rows

        rows = [(point.label, point.p, np.array2string(point.u, precision=6)) for point in self.special]
        return html_rows(f"a branch of {len(self.p)} points", ("label", "p", "u"), rows)


def continuation(
    F: Callable[[np.ndarray, float], Optional[Numbers]],
    u0: Numbers,
    p0: float,
    *,
    from_: float,
    to: float,
    jacobian: Optional[Callable[[np.ndarray, float], Any]] = None,
    by_parameter: Optional[Callable[[np.ndarray, float], Numbers]] = None,
    max_step: float = 0.0,
    max_distance: float = 0.05,
    max_turn: float = 0.3,
    residual_tolerance: float = 1e-11,
    max_points: int = 20000,
    max_seconds: float = 3600.0,
) -> Branch:
    """Continues the solution of F(u, p) = 0 near (u0, p0) both ways along its branch, by
    pseudo-arclength, for p between `from_` and `to`; folds and branch points are located.

    F returns as many numbers as u has, or None where it cannot be evaluated. `jacobian` returns
    dF/du (n, n) and `by_parameter` dF/dp (n); without them central differences stand in, with about
    ten digits. Scale the unknowns so that a change of one is large.

    max_step: largest change of p in one step (0: a fiftieth of the range); max_distance: of the
    unknowns, relative to 1 + their norm; max_turn: of the tangent, rad; residual_tolerance: largest
    entry of F at a point; or, where F is so large that its rounding is more, of the last correction
    of u, relative to 1 + its norm; max_points: in each direction; max_seconds: of computing time.

    Raises NumericsError where no solution lies near the start, and whatever F raises.
    """
    start = np.atleast_1d(np.asarray(u0, dtype=float))
    if start.ndim != 1 or start.size == 0 or not np.all(np.isfinite(start)):
        raise OptionError("u0: a list of finite numbers is wanted")
    limits = {"p0": p0, "from_": from_, "to": to, "max_step": max_step}
    for name, value in limits.items():
        if not math.isfinite(value):
            raise OptionError(f"{name}: {value!r} is not a finite number")
    if from_ == to:
        raise OptionError("from_, to: the range must not be empty")
    if not min(from_, to) <= p0 <= max(from_, to):
        raise OptionError(f"p0: {p0!r} does not lie between from_ and to")
    if max_step < 0.0 or not max_distance > 0.0 or not max_turn > 0.0 or not residual_tolerance > 0.0:
        raise OptionError(
            "max_step, max_distance, max_turn, residual_tolerance: numbers above 0 are wanted"
        )
    if not 1 <= int(max_points) <= 10_000_000:
        raise OptionError("max_points: a whole number from 1 to 10000000 is wanted")
    if not 0.0 < max_seconds <= 1e9:
        raise OptionError("max_seconds: a number above 0 is wanted")
    for name, function in (("F", F), ("jacobian", jacobian), ("by_parameter", by_parameter)):
        if not callable(function) and not (function is None and name != "F"):
            raise TypeError(f"{name}: a function of (u, p) is wanted")
    wanted = {
        "from": float(from_),
        "to": float(to),
        "max_step": float(max_step),
        "max_distance": float(max_distance),
        "max_turn": float(max_turn),
        "residual_tolerance": float(residual_tolerance),
        "max_points": int(max_points),
        "max_seconds": float(max_seconds),
    }
    found = _core.trace(F, start, float(p0), jacobian, by_parameter, wanted)
    if found is None:
        raise NumericsError(f"no solution of F(u, p) = 0 was found near u0 at p = {p0:g}")
    return Branch(found)
