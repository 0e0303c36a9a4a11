#!/usr/bin/env python3
"""The spool of a valve between two plates that a spring presses apart: data/validation/modelica_pre_load.toml.

Four pads, each with the force c y + clip(d y', -c y, c y) at the depth y, as in modelica_elasto_gap.py. While every pad keeps
its sign the motion is linear; it is carried on by exponentials of 2^-k s, which grow from event to event, and an event is
enclosed by halving them.

    python3 modelica_pre_load.py
"""
from mpmath import mp, mpf, pi

mp.dps = 40
MASS = [mpf("0.01"), mpf("0.15"), mpf("0.01")]                  # plate A, spool, plate B
C, D, SPRING, DASHPOT, PRELOAD = mpf(10) ** 6, mpf(250), mpf(20000), mpf(2500), mpf(65)
OMEGA = 2 * pi / 100
PADS = [((-1, 0, 0), mpf(0)), ((0, 0, 1), mpf("1.75e-3")), ((-1, 1, 0), mpf(0)), ((0, -1, 1), mpf("1.75e-3"))]
SIZE, LARGEST, SMALLEST = 9, 5, 110                             # of u, u', sin, cos, 1; steps of 2^-5 s to 2^-110 s
steps = {}


def pad(y, row, gap):
    depth = sum(r * u for r, u in zip(row, y[:3])) - gap
    rate = sum(r * v for r, v in zip(row, y[3:6]))
    if depth < 0:
        return "free"
    return "in" if D * rate >= C * depth else "out" if -D * rate >= C * depth else "damped"


def signs(y):
    return tuple(pad(y, *one) for one in PADS)


def rates(piece):
    a = mp.zeros(SIZE)
    for i in range(3):
        a[i, 3 + i] = 1

    def add(row, stiffness, damping, constant):
        """The force -(stiffness x + damping x' + constant) along the row, x the sum of row and u."""
        for i in range(3):
            for j in range(3):
                a[3 + i, j] -= row[i] * stiffness * row[j] / MASS[i]
                a[3 + i, 3 + j] -= row[i] * damping * row[j] / MASS[i]
            a[3 + i, 8] -= row[i] * constant / MASS[i]

    add((-1, 0, 1), SPRING, 0, -PRELOAD)
    add((0, 1, 0), 0, DASHPOT, 0)
    for kind, (row, gap) in zip(piece, PADS):
        stiffness, damping = {"free": (0, 0), "out": (0, 0), "in": (2 * C, 0), "damped": (C, D)}[kind]
        add(row, stiffness, damping, -stiffness * gap)
    a[4, 6] = 150 / MASS[1]
    a[6, 7], a[7, 6] = OMEGA, -OMEGA
    return a


def step(piece, k):
    if (piece, k) not in steps:
        steps[piece, k] = mp.expm(rates(piece) * mpf(2) ** -k)
    return steps[piece, k]


def motion(instants):
    y = mp.matrix([0] * 7 + [1, 1])
    # Plate A is pushed into both of its pads from rest, faster than it is deep.
    piece, t, k = ("in", "free", "in", "free"), mpf(0), 40
    events = []
    for until in instants:
        while t < until:
            if mpf(2) ** -k > until - t:
                k += 1
                if k > SMALLEST:
                    break
                continue
            new = step(piece, k) * y
            if signs(new) == piece:
                y, t, k = new, t + mpf(2) ** -k, max(k - 1, LARGEST)
            else:                                               # up to the event by halves, and past it
                for k in range(k + 1, SMALLEST + 1):
                    if signs(step(piece, k) * y) == piece:
                        y, t = step(piece, k) * y, t + mpf(2) ** -k
                y, t = step(piece, SMALLEST) * y, t + mpf(2) ** -SMALLEST
                events.append((t, piece, signs(y)))
                piece, k = signs(y), 50
        k = 50
        print(f"plate A against spool at {until} s, m", mp.nstr(y[0] - y[1], 20))
        print(f"spool against plate B at {until} s, m", mp.nstr(y[1] - y[2], 20))
    for t, before, after in events:
        print("event at", mp.nstr(t, 20), "s:", *before, "->", *after)


if __name__ == "__main__":
    motion([mpf(30), mpf(100)])
