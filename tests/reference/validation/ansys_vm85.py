#!/usr/bin/env python3
"""A bar that flies at a stiff spring: data/validation/ansys_vm85.toml, in the modes of a free bar.

    python3 ansys_vm85.py
"""
from mpmath import mp, mpf, pi, sqrt

from modes_on_spring import motion

mp.dps = 20
E, rho, length, speed, count = mpf(30) * 10**6, mpf("7.3e-4"), mpf(10) ** 4, mpf(100), 200
squares = [(j * pi / length) ** 2 * E / rho for j in range(count)]
near = [sqrt((1 if j == 0 else 2) / (rho * length)) for j in range(count)]      # at the far end
b = [x * (-1) ** j for j, x in enumerate(near)]
none = [mpf(0)] * count
v = [speed / near[0]] + none[1:]
q, v, met = motion(squares, b, none, mpf(3) * 10**7, mpf("0.64"), none, v, mpf("0.05573"))
print("displacement of the far end, in", mp.nstr(sum(x * y for x, y in zip(near, q)), 17))
print("contacts", met)
