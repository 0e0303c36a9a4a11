"""Graze: motions, periodic orbits, branches and bifurcations of impacting flexible structures.

>>> import graze
>>> scene = graze.Scene.load(graze.example("scenes/05_wagg_one_mode.toml"))
>>> graze.simulate(scene, periods=20).events["speed"]  # m/s

Every function takes a scene (a Scene, a file or a dict) and the options of the program's command of
that name as keywords. Units are SI, angles in radians; docs/python.md tells the rest.
"""

from ._core import version as __version__
from .equations import Branch, SpecialPoint, continuation
from .entry import Entry
from .errors import (
    Error, FileError, GrazeWarning, NoSuchName, NumericsError, OptionError, SceneError,
)
from .examples import example
from .functions import (
    check, compare, continue_, cost, diagram, fit, loci, map, modes, orbit, simulate,
)
from .kinds import (
    Branches, Check, Comparison, ComparisonMap, Cost, Diagram, Fit, Loci, Map, Modes, Orbits, RunDiagram,
    Sensitivity, Simulation,
)
from .result import Result
from .scene import Scene
from .stored import merge, view
from .table import Table

__all__ = [
    "Branch", "Branches", "Check", "Comparison", "ComparisonMap", "Cost", "Diagram", "Entry",
    "Error", "FileError", "Fit", "GrazeWarning", "Loci", "Map", "Modes", "NoSuchName", "NumericsError",
    "OptionError",
    "Orbits", "Result", "RunDiagram", "Scene", "SceneError", "Sensitivity", "Simulation",
    "SpecialPoint", "Table", "__version__", "check", "compare", "continuation", "continue_", "cost",
    "diagram", "example", "fit", "loci", "map", "merge", "modes", "orbit", "simulate", "view",
]
