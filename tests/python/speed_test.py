"""What the way through Python costs. The figures stand in docs/python.md."""

import os
import statistics
import subprocess
import time

import graze
import pytest
from conftest import BUILD

FILE = "data/scenes/04_impact_oscillator.toml"


def microseconds(work, calls=10, blocks=300):
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
def test_ten_million_rows_reach_numpy(program, tmp_path):
    """The program keeps its rows as arrays; without a folder it computes them and lets them go."""
    rows, periods = 10_000_000, 100_000
    words = [program, "simulate", FILE, "--periods", str(periods), "--record", "samples", "--quiet"]
    seconds = {"program": [], "program that keeps nothing": [], "Python": []}

    def timed(name, words):
        begin = time.perf_counter()
        subprocess.run(words, check=True, capture_output=True)
        seconds[name].append(time.perf_counter() - begin)

    for _ in range(5):
        timed("program", [*words, "--sample-format", "npz", "--out", str(tmp_path)])
        timed("program that keeps nothing", words)
        begin = time.perf_counter()
        samples = graze.simulate(FILE, periods=periods, record="samples").samples
        arrays = [samples[name] for name in samples.columns]
        seconds["Python"].append(time.perf_counter() - begin)
        assert len(arrays[0]) >= rows
        del samples, arrays
    medians = {name: statistics.median(times) for name, times in seconds.items()}
    print(medians)
    assert medians["Python"] <= 1.1 * medians["program"]
