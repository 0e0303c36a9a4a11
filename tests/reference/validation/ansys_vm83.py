#!/usr/bin/env python3
"""A block that falls onto a spring scale: data/validation/ansys_vm83.toml.

    m x'' = -K x - m g + F,   M y'' = -M g - F,   F = k d + c d',   d = x - y - gap,

with F from d = 0 until it would pull, every piece a matrix exponential. Printed is the lowest place of the pan
and, at that instant, of the block.

    python3 ansys_vm83.py
"""
from mpmath import expm, matrix, mp, mpf

mp.dps = 30
g, m, M, K, k, c, gap = mpf(386), mpf(25) / 386, mpf(50) / 386, mpf(100), mpf(10) ** 4, mpf("50.899"), mpf("71.75")


def system(closed):
    """Of x, y, x', y', 1."""
    push = [k, -k, c, -c, -k * gap] if closed else [0] * 5
    pan = [-f / m for f in push]
    block = [f / M for f in push]
    pan[0] -= K / m
    pan[4] -= g
    block[4] -= g
    return matrix([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], pan, block, [0] * 5])


def force(z):
    return k * (z[0] - z[1] - gap) + c * (z[2] - z[3])


def crossing(a, z, step, until):
    """The next zero of `until`, looked for every step, by halves."""
    s, e = mpf(0), expm(a * step)
    side = until(expm(a * step / 1024) * z) > 0
    while True:
        new = e * z
        if (until(new) > 0) != side:
            break
        z, s = new, s + step
    low, high = mpf(0), step
    for _ in range(110):
        middle = (low + high) / 2
        if (until(expm(a * middle) * z) > 0) == side:
            low = middle
        else:
            high = middle
    return expm(a * high) * z, s + high


t, closed, z = mpf(0), False, matrix([-m * g / K, 0, 0, 0, 1])
while True:
    what = force if closed else (lambda z: z[0] - z[1] - gap)
    a = system(closed)
    new, passed = crossing(a, z, mpf(1) / 1024, what)
    if z[2] < 0 < new[2]:
        low, at = crossing(a, z, mpf(1) / 1024, lambda z: z[2])
        print("lowest place of the pan, in", mp.nstr(low[0], 20), "at", mp.nstr(t + at, 10))
        print("block then, in", mp.nstr(low[1], 20))
        break
    # A spring that is left before it is relaxed is met again only after the block has risen from it.
    closed = not closed and z[0] - z[1] - gap < mpf(10) ** -20
    t, z = t + passed, new
    print("changes at", mp.nstr(t, 10))
