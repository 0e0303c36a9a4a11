"""What the program's commands do, a function each, whose keywords are the options of the command."""

from __future__ import annotations

from typing import Callable, Union

from .command import command
from .kinds import (
    Branches, Check, Comparison, ComparisonMap, Cost, Diagram, Fit, Loci, Map, Modes, Orbits, RunDiagram,
    Sensitivity, Simulation,
)

check: Callable[..., Check] = command(
    "check", Check, "Says what is simulated: modes, frequencies, conditioning, flow.")
modes: Callable[..., Modes] = command(
    "modes", Modes, "Finds the natural modes of the structure: frequencies, effective masses, shapes.")
simulate: Callable[..., Simulation] = command("simulate", Simulation, """\
Follows the motion from the scene's initial state, every impact certified.

Raises NumericsError with what was reached where a budget ended it.""")
orbit: Callable[..., Orbits] = command(
    "orbit", Orbits, "Finds periodic orbits, stable or not. Raises NumericsError where there is none.")
continue_: Callable[..., Branches] = command("continue", Branches, """\
Traces branches of periodic orbits over a parameter of the scene, from `from_` to `to` in the unit of that
parameter.""", without=("locus", "second", "second_from", "second_to", "slices", "regions"))
loci: Callable[..., Loci] = command(
    "continue", Loci, "Traces loci of special points (LP, PD, NS, GR, CH) over two parameters of the scene.",
    name="loci", without=("amplitudes", "show", "at", "switch"),
    required=("second", "second_from", "second_to"), unless_given={"locus": "all"})
diagram: Callable[..., Union[Diagram, RunDiagram]] = command("diagram", Union[Diagram, RunDiagram], """\
Sweeps a parameter and traces the branches over it. Without forcing, one run of `duration` s at each value.""")
map: Callable[..., Map] = command("map", Map, """\
Maps the attractors over a plane of two numbers of the scene, "initial.q.1" and the like among them.""")
cost: Callable[..., Cost] = command(
    "cost", Cost, "Measures what accuracy costs in computing time, flow by flow.")
fit: Callable[..., Fit] = command("fit", Fit, """\
Identifies parameters of the scene from measurements: `parameter` names them with the values between which
each is sought, {"stop.spring.stiffness": (1e6, 1e9)}.

`data` is a file (CSV), a DataFrame, or a dict of arrays (any mapping from names of columns, or a structured
array), in SI units: speed and restitution; time and stop of impacts; or time and force1, gap1,
displacement1, velocity1, penetration1, q1, qdot1, ..""")
compare: Callable[..., Union[Comparison, ComparisonMap, Sensitivity]] = command(
    "compare", Union[Comparison, ComparisonMap, Sensitivity], """\
Compares motions: `against` another choice {"beam.discretisation": "galerkin"}, with `modes` (1, 8), over a
plane of two parameters, or by `sensitivity` to a parameter.""")
