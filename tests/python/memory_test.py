"""Calls leave nothing behind. GRAZE_LONG=1 makes a thousand of each function, else a hundred."""

import ctypes
import gc
import os
import tempfile
import time

import graze
import pytest

CALLS = 1000 if os.environ.get("GRAZE_LONG") else 100
#: The calls come in blocks. A heap grows now and then, a leak in every block, so the block that grew
#: least tells: by four pages at most, which is 80 bytes a call of a thousand.
BLOCKS = 5
MOST = 4 * os.sysconf("SC_PAGE_SIZE")

FILE = "data/scenes/04_impact_oscillator.toml"
OVER = dict(parameter="forcing.frequency", from_=2.7, to=2.72)
PLANE = dict(second="stop.gap", second_from=0.0, second_to=0.02)


def refused():
    for wrong in (dict(periods=-1), dict(record="all"), dict(resume="/nowhere")):
        try:
            graze.simulate(FILE, **wrong)
        except graze.Error:
            pass


def refused_scene():
    try:
        graze.Scene.parse("[beam]\nlength = -1\n")
    except graze.SceneError:
        pass


def simulated():
    result = graze.simulate(FILE, periods=50, record="samples", energy=True)
    result.to_json()
    result.to_pandas("samples")
    return result.events["kind"], result.samples["q1"]


def numerics_error():
    try:
        graze.simulate(FILE, periods=1000, max_impacts=5)
    except graze.NumericsError as error:
        error.result.to_json()


WORK = {
    "simulate": simulated,
    "orbit": lambda: graze.orbit(FILE, impacts=1, start="closed-form").to_json(),
    "continue_": lambda: graze.continue_(FILE, **OVER, max_step=0.01).to_pandas(),
    "loci": lambda: graze.loci(
        FILE, parameter="forcing.frequency", from_=2.6, to=2.9, second="stop.gap", second_from=0.0,
        second_to=0.05, slices=0, locus="PD", start="closed-form",
    ).to_pandas(),
    "diagram": lambda: graze.diagram(FILE, **OVER, points=2, periods=20, branches="none").to_pandas(),
    "map": lambda: graze.map(FILE, **OVER, **PLANE, points=2, second_points=2, periods=20).to_pandas(),
    "compare": lambda: graze.compare(FILE, against={"stop.restitution": 0.5}, periods=20, max_seconds=0.05),
    "fit": lambda: graze.fit("data/measurements/restitution.toml", "data/measurements/restitution.csv"),
    "cost": lambda: graze.cost("data/scenes/06_bouncing_ball.toml", max_seconds=0.02),
    "modes": lambda: graze.modes(FILE).frequencies,
    "check": lambda: str(graze.check(FILE)),
    "scene": lambda: graze.Scene.load(FILE).changed({"stop.gap": 0.1}).parameters,
    "refused": refused,
    "refused_scene": refused_scene,
    "numerics_error": numerics_error,
    "continuation": lambda: graze.continuation(lambda u, p: u**2 + p**2 - 1, 0.9, 0.1, from_=-2, to=2),
}


def resident():
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize("name", WORK)
def test_a_call_leaves_nothing_behind(name):
    work = WORK[name]

    def called(count):
        for _ in range(count):
            try:
                work()
            except graze.NumericsError:
                pass

    # Caches fill, and the heaps of threads, of which every one grows to what its largest call needs.
    end = time.monotonic() + 10.0
    for _ in range(1000):
        called(1)
        if time.monotonic() > end:
            break
    sizes = [resident()]
    for _ in range(BLOCKS):
        called(CALLS // BLOCKS)
        sizes.append(resident())
    assert min(after - before for before, after in zip(sizes, sizes[1:])) <= MOST, sizes


def test_a_leak_would_be_seen():
    leaked = []
    sizes = [resident()]
    for _ in range(BLOCKS):
        leaked.append(b"x" * 1000 * (CALLS // BLOCKS))  # a kilobyte a call
        sizes.append(resident())
    assert min(after - before for before, after in zip(sizes, sizes[1:])) > MOST or CALLS < 200


def test_files_of_out_are_closed():
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(20):
            graze.simulate(FILE, periods=5, out=folder, record="samples")
        before = len(os.listdir("/proc/self/fd"))
        for _ in range(50):
            graze.simulate(FILE, periods=5, out=folder, record="samples")
        assert len(os.listdir("/proc/self/fd")) <= before
