#!/usr/bin/env python3
"""A mass between two elastic gaps: data/validation/modelica_elasto_gap.toml.

On a pad of depth y the force is c y + clip(d y', -c y, c y), so that the motion is that of a linear oscillator between
the instants at which the mass meets or leaves a pad or the damper meets or leaves its bound. Each piece is a matrix
exponential; its end is found by bisection.

    python3 modelica_elasto_gap.py
"""
from mpmath import mp, mpf

C, D, GAP = mpf(10), mpf("1.5"), mpf("0.5")


def piece(x, v):
    """x'' = -k x - b v + p, and the signs that hold it."""
    side = 1 if x > 0 else -1
    depth, rate = side * x - GAP, side * v
    if depth < 0 or (depth == 0 and rate < 0):
        return "free", mpf(0), mpf(0), mpf(0)
    if D * rate >= C * depth:
        return "in" + str(side), 2 * C, mpf(0), side * 2 * C * GAP
    if -D * rate >= C * depth:
        return "out" + str(side), mpf(0), mpf(0), mpf(0)
    return "damped" + str(side), C, D, side * C * GAP


def flow(x, v, part, s):
    _, k, b, p = part
    a = mp.matrix([[0, 1, 0], [-k, -b, p], [0, 0, 0]])
    y = mp.expm(a * s, method="taylor") * mp.matrix([x, v, 1])
    return y[0], y[1]


def motion(until):
    t, x, v = mpf(0), mpf(2), mpf(0)
    step = mpf(1) / 256
    part = piece(x, v)
    while t < until:
        s = min(step, until - t)
        x1, v1 = flow(x, v, part, s)
        if piece(x1, v1)[0] != part[0]:
            low, high = mpf(0), s
            for _ in range(3 * mp.dps):
                middle = (low + high) / 2
                if piece(*flow(x, v, part, middle))[0] == part[0]:
                    low = middle
                else:
                    high = middle
            s = high
            x1, v1 = flow(x, v, part, s)
        t, x, v = t + s, x1, v1
        part = piece(x, v)
    return x, v


if __name__ == "__main__":
    mp.dps = 30
    for t in (1, 2):
        x, v = motion(mpf(t))
        print(f"displacement at {t} s, m", mp.nstr(x, 20))
