"""What the way through Python costs. The figures stand in docs/python.md."""

import os
import subprocess
import time

import graze
import numpy as np
import pytest
from conftest import BUILD

FILE = "data/scenes/04_impact_oscillator.toml"


def microseconds(work, calls=100, blocks=20):
    best = float("inf")
    for _ in range(blocks):
        begin = time.perf_counter()
        for _ in range(calls):
            work()
        best = min(best, 1e6 * (time.perf_counter() - begin) / calls)
    return best


def test_a_call_costs_fifty_microseconds_at_most():
    periods = 20
    timed = subprocess.run(
        [BUILD / "tests/python_call_cost", FILE, str(periods)], capture_output=True, text=True, check=True
    )
    library, command = map(float, timed.stdout.split())
    scene = graze.Scene.load(FILE)
    called = microseconds(lambda: graze.simulate(scene, periods=periods))
    print(f"library {library:.1f} us, command {command:.1f} us, Python {called:.1f} us")
    assert called - command <= 50.0


@pytest.mark.skipif(not os.environ.get("GRAZE_LONG"), reason="takes long; GRAZE_LONG=1 runs it")
def test_ten_million_rows_reach_numpy(program):
    """The program keeps no table without --out, so its run is no more than the motion itself."""
    rows, periods = 10_000_000, 100_000
    options = ["--periods", str(periods), "--record", "samples"]
    seconds = {"program": np.inf, "Python": np.inf}
    for _ in range(3):
        begin = time.perf_counter()
        subprocess.run([program, "simulate", FILE, *options, "--quiet"], check=True, capture_output=True)
        seconds["program"] = min(seconds["program"], time.perf_counter() - begin)
        begin = time.perf_counter()
        samples = graze.simulate(FILE, periods=periods, record="samples").samples
        arrays = [samples[name] for name in samples.columns]
        seconds["Python"] = min(seconds["Python"], time.perf_counter() - begin)
        assert len(arrays[0]) >= rows
        del samples, arrays
    print(seconds)
    assert seconds["Python"] <= 1.1 * seconds["program"]
