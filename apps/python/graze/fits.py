"""graze.fit: parameters of the scene from measurements."""

from __future__ import annotations

from .result import Result, result_kind


@result_kind("fit")
class Fit(Result):
    """Fitted parameters, a list of them; tables "parameters" and "fit" (a measured value a row, SI
    units)."""

    main_table = "parameters"
