"""A wrong argument never ends the interpreter: it is an exception of a known kind. The work is done in
a process of its own, whose end by a signal would be seen. FUZZ_CALLS says how many."""

import os
import pathlib
import subprocess
import sys

CALLS = int(os.environ.get("FUZZ_CALLS", 20_000 if os.environ.get("GRAZE_LONG") else 1500))

SCRIPT = r"""
import inspect, os, random, sys, tempfile, warnings
import graze, numpy as np
warnings.simplefilter("ignore")
seed, calls = int(sys.argv[1]), int(sys.argv[2])
draw = random.Random(seed)
FILE = "data/scenes/04_impact_oscillator.toml"
SCENE = graze.Scene.load(FILE)
text = SCENE.to_toml()
folder = tempfile.mkdtemp()
functions = [graze.simulate, graze.orbit, graze.continue_, graze.loci, graze.diagram, graze.map,
             graze.fit, graze.compare, graze.cost, graze.modes, graze.check]
values = [None, True, False, 0, 1, -1, 2, 3, 7, 10**30, -10**30, 1e300, -1e300, float("nan"), float("inf"),
          0.0, 1e-300, 0.5, 2.7, "", " ", "a", "none", "all", "events", "samples", "LP", "PD,GR", "x" * 5000,
          "\0", "\u2028\udc80", "-", "--", "--help", "--version", "-h", "=", "1:2", "3/8", "nan", "1e400",
          "forcing.frequency", "stop.gap", "initial.q.1", "stop.gap=0.1", [], [[]], [None], [1, 2], ["a"],
          (1, 2), {}, {"stop.gap": 0.1}, {"stop.gap": (0.0, 1.0)}, {1: 2}, set(), object(), lambda: 0, b"x",
          np.float64(0.5), np.int64(3), np.array([1.0, 2.0]), np.array("x"), 1j, range(3), folder,
          "/nowhere", FILE, "data/measurements/restitution.csv", type, Ellipsis]
scenes = [SCENE, SCENE, SCENE, FILE, None, 3, "", "/nowhere", {}, {"beam": 3}, {"beam": {"length": object()}},
          "data/scenes/06_bouncing_ball.toml", b"x", [], "data/measurements/restitution.toml"]
known = (graze.Error, TypeError, ValueError, KeyError, OverflowError, MemoryError, NotImplementedError,
         AttributeError)
kinds = {}
def called(work):
    try:
        work()
        kind = "done"
    except known as error:
        kind = type(error).__name__
        str(error), repr(error)
    kinds[kind] = kinds.get(kind, 0) + 1
for count in range(calls):
    function = draw.choice(functions)
    names = [n for n in inspect.signature(function).parameters if n not in ("scene", "progress", "out")]
    given = {n: draw.choice(values) for n in draw.sample(names, draw.randint(0, min(4, len(names))))}
    right = dict(parameter="forcing.frequency", from_=2.7, to=2.72, second="stop.gap", second_from=0.0,
                 second_to=0.02, data="data/measurements/restitution.csv", points=2, second_points=2,
                 slices=0)
    if function is graze.compare and draw.random() < 0.7:
        right = dict(against="stop.gap=0.1")
    for name, value in right.items():
        if name in names and draw.random() < 0.8:
            given.setdefault(name, value)
    if "max_seconds" in names:
        given["max_seconds"] = 0.02
    for name in ("threads",):
        if name in given and isinstance(given[name], (int, float)) and not 0 <= given[name] <= 4:
            pass
    where = draw.choice(scenes)
    called(lambda: function(where, **given))
    if count % 5 == 0:  # scenes with a letter, a line or a piece changed
        letters = list(text)
        for _ in range(draw.randint(1, 4)):
            at = draw.randrange(len(letters))
            letters[at:at + draw.randint(0, 3)] = draw.choice(["", "9", "-", "e", "\n", "[", "\"", "\0", "nan", "="])
        def read():
            scene = graze.Scene.parse("".join(letters))
            scene._repr_html_(), scene.parameters, scene.to_toml()
        called(read)
        called(lambda: SCENE.changed(draw.choice(values)))
        called(lambda: SCENE[draw.choice(values)])
        called(lambda: graze.continuation(draw.choice([lambda u, p: u - p, *values]), draw.choice(values),
               draw.choice([0.1, *values]), from_=draw.choice([-1.0, *values]), to=draw.choice([1.0, *values]),
               max_seconds=0.02, max_points=draw.choice([10, *values])))
print(kinds)
assert kinds["done"] > calls // 50, kinds
"""


def test_wrong_arguments_are_exceptions(program):
    root = pathlib.Path(__file__).resolve().parents[2]
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(program).parent / "python")}
    for seed in (1, 2):
        done = subprocess.run([sys.executable, "-X", "faulthandler", "-c", SCRIPT, str(seed), str(CALLS // 2)],
                              cwd=root, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, (done.returncode, done.stdout[-2000:], done.stderr[-4000:])
