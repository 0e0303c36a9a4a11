"""graze.cost: what accuracy costs in time, flow by flow."""

from __future__ import annotations

from .result import Result, result_kind


@result_kind("cost")
class Cost(Result):
    """Errors and times: tables "costs" (a flow and setting a row), "costs_of_modes", .."""

    main_table = "costs"
