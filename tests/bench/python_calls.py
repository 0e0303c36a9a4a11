"""What the way through Python costs; the figures stand in docs/python.md. From the project's root, of a
build with GRAZE_PYTHON and GRAZE_BENCH: python3 tests/bench/python_calls.py build"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

BUILD = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(BUILD / "python"))

import graze  # noqa: E402

FILE = "data/scenes/04_impact_oscillator.toml"


def microseconds(work, calls=10, blocks=300):
    """A call, in the quickest of the blocks: whatever else the machine does adds to it."""
    best = float("inf")
    for _ in range(blocks):
        begin = time.perf_counter()
        for _ in range(calls):
            work()
        best = min(best, 1e6 * (time.perf_counter() - begin) / calls)
    return best


def a_call(periods=20):
    timed = subprocess.run(
        [BUILD / "tests/bench/python_call_cost", FILE, str(periods)],
        capture_output=True, text=True, check=True,
    )
    library, command = map(float, timed.stdout.split())
    scene = graze.Scene.load(FILE)
    called = microseconds(lambda: graze.simulate(scene, periods=periods))
    print(f"{periods} periods: library {library:.1f} us, command {command:.1f} us, Python {called:.1f} us")


def ten_million_rows(periods=100_000, runs=5):
    """The program keeps its rows as arrays; without a folder it computes them and lets them go."""
    words = [str(BUILD / "graze"), "simulate", FILE, "--periods", str(periods), "--record", "samples", "--quiet"]
    seconds = {"program": [], "program that keeps nothing": [], "Python": []}

    def timed(name, words):
        begin = time.perf_counter()
        subprocess.run(words, check=True, capture_output=True)
        seconds[name].append(time.perf_counter() - begin)

    with tempfile.TemporaryDirectory() as folder:
        for _ in range(runs):
            timed("program", [*words, "--sample-format", "npz", "--out", folder])
            timed("program that keeps nothing", words)
            begin = time.perf_counter()
            samples = graze.simulate(FILE, periods=periods, record="samples").samples
            arrays = [samples[name] for name in samples.columns]
            seconds["Python"].append(time.perf_counter() - begin)
            del samples, arrays
    print("10^7 rows:", {name: f"{statistics.median(times):.2f} s" for name, times in seconds.items()})


a_call()
ten_million_rows()
