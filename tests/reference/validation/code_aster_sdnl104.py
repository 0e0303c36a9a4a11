#!/usr/bin/env python3
"""A cantilever that is pressed against an elastic stop: data/validation/code_aster_sdnl104.toml.

Sixty modes of the Euler-Bernoulli cantilever: cos y cosh y = -1, frequency (y/L)^2 sqrt(E I/(rho A)), 2/sqrt(mass) at the
tip. Printed beside them is what ten elements and 1600 steps of Newmark's rule, which the source uses, make of it.

    python3 code_aster_sdnl104.py
"""
from mpmath import cos, cosh, findroot, mp, mpf, pi, sqrt

from modes_on_spring import motion

mp.dps = 25
E, rho, radius, length = mpf(10) ** 10, mpf(10) ** 6, mpf("0.1"), mpf(1)
area, inertia = pi * radius**2, pi * radius**4 / 4
COUNT = 60


def squares(count):
    for j in range(count):
        # 1/cosh y is below the last digit from about y = 60 on, where cos y = 0.
        near = (j + mpf(1) / 2) * pi
        y = findroot(lambda y: cos(y) + 1 / cosh(y), near) if near < 70 else near
        yield (y / length) ** 4 * E * inertia / (rho * area)


signs = [(-1) ** j for j in range(COUNT)]
b = [2 * sign / sqrt(rho * area * length) for sign in signs]
modes = list(squares(COUNT))
# Downwards is positive here: the stop is below.
force = [1000 * b_j for b_j in b]
for until in ("0.1315", "0.1566"):
    q, v, met = motion(modes, b, force, mpf(10) ** 8, mpf("1e-4"), [mpf(0)] * COUNT, [mpf(0)] * COUNT, mpf(until))
    print(f"displacement at {until} s, m", mp.nstr(-sum(x * y for x, y in zip(b, q)), 20))
    print(f"velocity at {until} s, m/s", mp.nstr(-sum(x * y for x, y in zip(b, v)), 20))
    print("contacts", met)
