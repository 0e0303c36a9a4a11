#!/usr/bin/env python3
"""Makes the measurements of this folder anew: closed forms and simulations with known parameters,
with normal noise from fixed seeds. Needs nothing but Python and the program:

    python3 data/measurements/make_measurements.py build/graze
"""
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def simulated(graze, scene, settings, options, table):
    """The rows of a table of `graze simulate` on a scene of this folder."""
    with tempfile.TemporaryDirectory() as out:
        line = [graze, "simulate", str(HERE / scene), "--quiet", "--out", out, *options]
        for setting in settings:
            line += ["--set", setting]
        subprocess.run(line, check=True, stdout=subprocess.DEVNULL)
        with open(pathlib.Path(out) / table, newline="") as rows:
            return list(csv.DictReader(rows))


def write(name, header, rows):
    with open(HERE / name, "w", newline="") as file:
        file.write(header + "\n")
        for row in rows:
            file.write(",".join(f"{value:.10g}" for value in row) + "\n")


def restitution():
    noise = random.Random(1)
    speeds = [0.125 * k for k in range(1, 25)]
    law = lambda v: 0.92 - 0.11 * v - 0.015 * v * v
    write("restitution.csv", "speed,restitution",
          [(v, round(law(v) + noise.gauss(0.0, 0.008), 4)) for v in speeds])


def contact(graze):
    noise = random.Random(2)
    rows = simulated(graze, "contact.toml",
                     ["stop.spring.stiffness=2e7", "stop.spring.exponent=1.5",
                      "stop.spring.damping.coefficient=1.5e7"],
                     ["--duration", "4e-3", "--record", "samples", "--sample-rate", "1e5"],
                     "samples.csv")
    write("contact.csv", "time,force1",
          [(float(row["time"]), round(float(row["force1"]) + noise.gauss(0.0, 0.5), 2))
           for row in rows])


def vibration():
    """The frequency that Yigit, Ulsoy and Scott (1990) print, as a record."""
    noise = random.Random(5)
    write("vibration.csv", "time,probe_1",
          [(1e-3 * k, round(1e-4 * math.cos(2.0 * math.pi * 66.5 * 1e-3 * k)
                            + noise.gauss(0.0, 2e-6), 8)) for k in range(101)])


def impacts():
    """Impact k of a ball dropped from h: sqrt(2 h/g) (1 + 2 r + .. + 2 r^(k-1))."""
    noise = random.Random(3)
    height, r, late = 1.2, 0.83, 0.15
    fall = math.sqrt(2.0 * height / 9.81)
    times = [fall * (1.0 + 2.0 * sum(r**j for j in range(1, k))) - late for k in range(1, 15)]
    write("impacts.csv", "time", [(round(t + noise.gauss(0.0, 1e-3), 4),) for t in times])


def response(graze):
    noise = random.Random(4)
    gap = 5.2e-3
    rows = simulated(graze, "response.toml", ["damping.viscous=0.05", f"stop.gap={gap}"],
                     ["--duration", "0.6", "--record", "samples", "--sample-rate", "500"],
                     "samples.csv")
    write("response.csv", "time,displacement1",
          [(float(row["time"]), round(gap - float(row["gap1"]) + noise.gauss(0.0, 5e-5), 7))
           for row in rows])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    restitution()
    contact(sys.argv[1])
    vibration()
    impacts()
    response(sys.argv[1])
