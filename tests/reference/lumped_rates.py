#!/usr/bin/env python3
"""Modes of masses and springs and their derivatives by every mass, stiffness and dashpot, to 20 digits.

Central differences of step 1e-15 at 60 digits. Modes are those of M^-1/2 K M^-1/2, mass-normalised, each with its first
mass moving along +u.

    python3 lumped_rates.py              writes lumped_rates.csv
"""
import csv
import pathlib
import tomllib

from mpmath import mp, mpf

HERE = pathlib.Path(__file__).resolve().parent


def modes(masses, springs, row, pushed):
    """Numbers of the modes: frequencies, Phi^T C Phi by rows, shapes along the row, shapes of the pushed mass."""
    n = len(masses)
    damping, stiffness = mp.zeros(n), mp.zeros(n)
    for ends, k, c in springs:
        ends = [end - 1 for end in ends]
        for matrix, value in ((stiffness, k), (damping, c)):
            for i in ends:
                if i >= 0:
                    matrix[i, i] += value
            if min(ends) >= 0:
                matrix[ends[0], ends[1]] -= value
                matrix[ends[1], ends[0]] -= value
    root = mp.diag([1 / mp.sqrt(m) for m in masses])
    squares, vectors = mp.eigsy(root * stiffness * root)
    shapes = root * vectors
    for j in range(n):
        if shapes[0, j] < 0:
            for i in range(n):
                shapes[i, j] = -shapes[i, j]
    modal = shapes.T * damping * shapes
    numbers = [mp.sqrt(abs(w)) for w in squares]
    numbers += [modal[i, j] for i in range(n) for j in range(n)]
    numbers += [sum(sign * shapes[i, j] for i, sign in row) for j in range(n)]
    numbers += [shapes[pushed, j] for j in range(n)]
    return numbers


def main():
    mp.dps = 60
    with open(HERE / "cases" / "coupled" / "three_masses.toml", "rb") as file:
        scene = tomllib.load(file)
    masses = [mpf(m) for m in scene["lumped"]["masses"]]
    springs = [[s["between"], mpf(s.get("stiffness", 0.0)), mpf(s.get("damping", 0.0))] for s in scene["lumped"]["spring"]]
    stop = scene["stop"][0]
    row = [(stop["mass"] - 1, 1), (stop["against"] - 1, -1)]
    pushed = scene["forcing"]["mass"] - 1
    h = mpf(10) ** -15

    def moved(kind, at, by):
        changed, others = list(masses), [list(s) for s in springs]
        if kind == "masses":
            changed[at] += by
        else:
            others[at][1 if kind == "stiffness" else 2] += by
        return modes(changed, others, row, pushed)

    names = [(f"lumped.masses.{i + 1}", "masses", i) for i in range(len(masses))]
    for i in range(len(springs)):
        for key in ("stiffness", "damping"):
            names.append((f"lumped.spring.{i + 1}.{key}", key, i))
    with open(HERE / "lumped_rates.csv", "w") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["parameter", "number", "value", "rate"])
        here = modes(masses, springs, row, pushed)
        for name, kind, at in names:
            above, below = moved(kind, at, h), moved(kind, at, -h)
            for k, value in enumerate(here):
                table.writerow([name, k, mp.nstr(value, 20), mp.nstr((above[k] - below[k]) / (2 * h), 20)])


if __name__ == "__main__":
    main()
