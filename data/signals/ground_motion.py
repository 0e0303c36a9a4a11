#!/usr/bin/env python3
"""An earthquake that was never measured: white noise through the ground's filter (K. Kanai 1957, H. Tajimi 1960: 15.6 rad/s,
damping 0.6, which suits the firm ground of El Centro), which rises over 2 s, stays, and dies away from 10 s on. The largest
acceleration is 3.13 m/s^2, that of the record of 1940.

    python3 data/signals/ground_motion.py > data/signals/quake.csv
"""
import math
import random

GROUND, DAMPING, STEP, DURATION, PEAK = 15.6, 0.6, 0.02, 20.0, 3.13
PARTS = 20  # steps of the filter in one of the table


def envelope(t):
    return (t / 2) ** 2 if t < 2 else 1.0 if t < 10 else math.exp(-0.35 * (t - 10))


draw = random.Random(1940)
x = v = 0.0
rows = []
for k in range(round(DURATION / STEP) + 1):
    t = k * STEP
    rows.append((t, -envelope(t) * (2 * DAMPING * GROUND * v + GROUND**2 * x)))
    noise = draw.gauss(0.0, 1.0)
    h = STEP / PARTS
    for _ in range(PARTS):
        v += h * (noise - 2 * DAMPING * GROUND * v - GROUND**2 * x)
        x += h * v
largest = max(abs(a) for _, a in rows)
print("time (s),acceleration (m/s^2)")
for t, a in rows:
    print(f"{t:.2f},{PEAK * a / largest:.5f}")
