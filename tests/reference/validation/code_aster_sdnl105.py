#!/usr/bin/env python3
"""Three clamped tubes side by side that touch at their middles: data/validation/code_aster_sdnl105.toml.

Each tube is ten Euler-Bernoulli elements, as in the source, and moves in its five lowest modes. Between contacts the modes
of tubes and closed springs together carry the motion exactly; contacts are found by bisection.

    python3 code_aster_sdnl105.py [FOLDER]      also writes the matrices of the scene to FOLDER
"""
import sys

from mpmath import cos, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 30
E, RHO, LENGTH, RADIUS, WALL = mpf(10) ** 10, mpf(10) ** 8, mpf(1), mpf("0.1"), mpf("0.01")
SPRING, GAP, FORCE = mpf(10) ** 8, mpf("1e-3"), mpf(10) ** 6
AREA, INERTIA = pi * (RADIUS**2 - (RADIUS - WALL) ** 2), pi * (RADIUS**4 - (RADIUS - WALL) ** 4) / 4
ELEMENTS, MODES, TUBES = 10, 5, 3
FREE = 2 * (ELEMENTS - 1)                                       # deflection and slope of the nodes between the clamps
MIDDLE = 2 * (ELEMENTS // 2 - 1)


def tube():
    """Mass and stiffness of one tube, its ends held."""
    h = LENGTH / ELEMENTS
    mass, stiffness = mp.zeros(FREE + 4), mp.zeros(FREE + 4)
    m = [[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]
    k = [[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]]
    for e in range(ELEMENTS):
        for i in range(4):
            for j in range(4):
                scale = h ** (i % 2 + j % 2)
                mass[2 * e + i, 2 * e + j] += RHO * AREA * h / 420 * m[i][j] * scale
                stiffness[2 * e + i, 2 * e + j] += E * INERTIA / h**3 * k[i][j] * scale
    return mass[2 : FREE + 2, 2 : FREE + 2], stiffness[2 : FREE + 2, 2 : FREE + 2]


def write(folder, name, one, what):
    """Lower triangle of the three tubes, Matrix Market."""
    entries = [(t * FREE + i + 1, t * FREE + j + 1, one[i, j])
               for t in range(TUBES) for j in range(FREE) for i in range(j, FREE) if one[i, j]]
    with open(f"{folder}/three_tubes_{name}.mtx", "w") as out:
        out.write("%%MatrixMarket matrix coordinate real symmetric\n")
        out.write(f"% {what} of three clamped tubes of ten elements: tests/reference/validation/code_aster_sdnl105.py\n")
        out.write(f"{TUBES * FREE} {TUBES * FREE} {len(entries)}\n")
        out.writelines(f"{i} {j} {mp.nstr(x, 17)}\n" for i, j, x in entries)


def lowest(mass, stiffness):
    """Squared frequencies of the lowest modes, and what they are at the middle, for a modal mass of 1."""
    inverse = mp.cholesky(mass) ** -1
    squares, shapes = mp.eigsy(inverse * stiffness * inverse.T)
    shapes = inverse.T * shapes
    return [squares[j] for j in range(MODES)], [shapes[MIDDLE, j] for j in range(MODES)]


class Piece:
    """The motion while these springs are pressed: x'' + K x = f in coordinates that do not couple."""

    def __init__(self, squares, rows, force, closed):
        n = len(squares)
        k = mp.diag(squares)
        f = matrix(force)
        for row in closed:
            for i in range(n):
                f[i] += SPRING * GAP * rows[row][i]
                for j in range(n):
                    k[i, j] += SPRING * rows[row][i] * rows[row][j]
        self.squares, self.shapes = mp.eigsy(k)
        self.rest = [x / s for x, s in zip(self.shapes.T * f, self.squares)]

    def flow(self, q, v, t):
        p, r = self.shapes.T * q, self.shapes.T * v
        a, b = p.copy(), r.copy()
        for i, (s, rest) in enumerate(zip(self.squares, self.rest)):
            w = sqrt(s)
            a[i] = rest + (p[i] - rest) * cos(w * t) + r[i] / w * sin(w * t)
            b[i] = r[i] * cos(w * t) - (p[i] - rest) * w * sin(w * t)
        return self.shapes * a, self.shapes * b


def motion(squares, at_middle, until):
    """Displacements and velocities of the middles at that instant, and the instants of contacts and separations."""
    n = TUBES * MODES
    place = [[at_middle[j - t * MODES] if t * MODES <= j < (t + 1) * MODES else mpf(0) for j in range(n)]
             for t in range(TUBES)]
    rows = [[x - y for x, y in zip(place[t], place[t + 1])] for t in range(TUBES - 1)]
    pieces = {}

    def dot(row, q):
        return sum(x * y for x, y in zip(row, q))

    def closed(q):
        return tuple(t for t, row in enumerate(rows) if dot(row, q) > GAP)

    q, v, t, events = mp.zeros(n, 1), mp.zeros(n, 1), mpf(0), []
    pressed = ()
    while t < until:
        if pressed not in pieces:
            pieces[pressed] = Piece(squares * TUBES, rows, [FORCE * x for x in place[0]], pressed)
        step = min(mpf(1) / 2048, until - t)
        if closed(pieces[pressed].flow(q, v, step)[0]) != pressed:
            low = mpf(0)
            while step - low > mpf(10) ** -28:
                middle = (low + step) / 2
                low, step = (middle, step) if closed(pieces[pressed].flow(q, v, middle)[0]) == pressed else (low, middle)
        q, v = pieces[pressed].flow(q, v, step)
        t += step
        if closed(q) != pressed:
            pressed = closed(q)
            events.append((t, pressed))
    return [dot(row, q) for row in place], [dot(row, v) for row in place], events


if __name__ == "__main__":
    mass, stiffness = tube()
    if len(sys.argv) > 1:
        write(sys.argv[1], "mass", mass, "Mass")
        write(sys.argv[1], "stiffness", stiffness, "Stiffness")
    displacements, velocities, events = motion(*lowest(mass, stiffness), mpf(1))
    for i, (u, rate) in enumerate(zip(displacements, velocities), 1):
        print(f"displacement of tube {i} at 1 s, m", mp.nstr(u, 20))
        print(f"velocity of tube {i} at 1 s, m/s", mp.nstr(rate, 20))
    for t, pressed in events:
        print("at", mp.nstr(t, 20), "s the springs pressed are", [i + 1 for i in pressed])
