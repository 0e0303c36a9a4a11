"""graze.modes and graze.check: natural modes, and what a scene simulates."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from .entry import Entry
from .result import Result, result_kind


@result_kind("modes")
class Modes(Result):
    """Natural modes, a list of them: `frequencies` in rad/s, `decay_rates` in 1/s; document["directions"]
    holds effective masses in kg."""

    main_table = ""

    def _list(self) -> Sequence[Entry]:
        return self._of_document("modes")

    @property
    def frequencies(self) -> np.ndarray:
        """Angular frequencies, rad/s."""
        return np.array([mode["frequency"] for mode in self.document["modes"]], dtype=float)

    @property
    def decay_rates(self) -> np.ndarray:
        """Decay rates, 1/s; NaN where there is none."""
        return np.array([mode["decay_rate"] for mode in self.document["modes"]], dtype=float)

    def to_pandas(self, table: str = "") -> Any:
        import pandas

        return pandas.DataFrame(self.document["modes"])

    def _repr_html_(self) -> str:
        from .table import html_rows

        rows = list(zip(range(1, 1 + len(self.frequencies)), self.frequencies, self.decay_rates))
        return html_rows("natural modes", ("mode", "rad/s", "1/s"), rows)


@result_kind("check")
class Check(Result):
    """What a scene simulates; `print` it."""

    main_table = ""
