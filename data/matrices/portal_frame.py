#!/usr/bin/env python3
"""Mass and stiffness of a portal frame, as *MATRIX OUTPUT of Abaqus writes them.

Two columns of 2 m, clamped at their feet, and a girder of 3 m, of square steel tube 60 x 60 x 3 mm;
Euler-Bernoulli beam elements of 0.25 m in the plane x, y with consistent mass. Nodes go up the left
column (1 to 9), along the girder (9 to 21) and down the right one (21 to 29); degrees of freedom are
1, 2 (displacements along x, y) and 6 (rotation about z). Writes portal_frame_mass.mtx,
portal_frame_stiffness.mtx and portal_frame_nodes.csv into the folder that is given, or beside
itself.
"""
import math
import pathlib
import sys

E, RHO = 210e9, 7850.0  # Pa, kg/m^3
OUTER, WALL = 0.06, 0.003  # m
INNER = OUTER - 2 * WALL
AREA = OUTER**2 - INNER**2  # m^2
SECOND_MOMENT = (OUTER**4 - INNER**4) / 12  # m^4
HEIGHT, SPAN, LENGTH = 2.0, 3.0, 0.25  # m


def nodes():
    up, across = round(HEIGHT / LENGTH), round(SPAN / LENGTH)
    places = [(0.0, i * LENGTH) for i in range(up + 1)]
    places += [(i * LENGTH, HEIGHT) for i in range(1, across + 1)]
    places += [(SPAN, HEIGHT - i * LENGTH) for i in range(1, up + 1)]
    return places


def element(length):
    """Stiffness and mass along the element: axial, across, rotation, at both ends."""
    a, b, c = E * AREA / length, E * SECOND_MOMENT / length**3, RHO * AREA * length
    k = [[0.0] * 6 for _ in range(6)]
    m = [[0.0] * 6 for _ in range(6)]
    for i, j, value, mass in ((0, 0, a, 1 / 3), (0, 3, -a, 1 / 6), (3, 3, a, 1 / 3)):
        k[i][j] = k[j][i] = value
        m[i][j] = m[j][i] = c * mass
    l = length
    bend = [[12, 6 * l, -12, 6 * l], [6 * l, 4 * l * l, -6 * l, 2 * l * l],
            [-12, -6 * l, 12, -6 * l], [6 * l, 2 * l * l, -6 * l, 4 * l * l]]
    inert = [[156, 22 * l, 54, -13 * l], [22 * l, 4 * l * l, 13 * l, -3 * l * l],
             [54, 13 * l, 156, -22 * l], [-13 * l, -3 * l * l, -22 * l, 4 * l * l]]
    at = (1, 2, 4, 5)
    for i in range(4):
        for j in range(4):
            k[at[i]][at[j]] = b * bend[i][j]
            m[at[i]][at[j]] = c / 420 * inert[i][j]
    return k, m


def turned(matrix, cosine, sine):
    """In the axes x, y of the frame."""
    turn = [[0.0] * 6 for _ in range(6)]
    for end in (0, 3):
        turn[end][end], turn[end][end + 1] = cosine, sine
        turn[end + 1][end], turn[end + 1][end + 1] = -sine, cosine
        turn[end + 2][end + 2] = 1.0
    half = [[sum(matrix[i][p] * turn[p][j] for p in range(6)) for j in range(6)] for i in range(6)]
    return [[sum(turn[p][i] * half[p][j] for p in range(6)) for j in range(6)] for i in range(6)]


def assembled():
    places = nodes()
    stiffness, mass = {}, {}
    for first in range(len(places) - 1):
        (x0, y0), (x1, y1) = places[first], places[first + 1]
        length = math.hypot(x1 - x0, y1 - y0)
        cosine, sine = (x1 - x0) / length, (y1 - y0) / length
        names = [(first + 1 + end, dof) for end in (0, 1) for dof in (1, 2, 6)]
        for local, whole in zip(element(length), (stiffness, mass)):
            here = turned(local, cosine, sine)
            for i, row in enumerate(names):
                for j, column in enumerate(names):
                    if row >= column and here[i][j] != 0.0:
                        whole[row, column] = whole.get((row, column), 0.0) + here[i][j]
    return stiffness, mass


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    stiffness, mass = assembled()
    for name, matrix in (("stiffness", stiffness), ("mass", mass)):
        lines = [f"** {name} of a portal frame, by portal_frame.py"]
        lines += [f"{r[0]},{r[1]}, {c[0]},{c[1]}, {value:.15e}"
                  for (r, c), value in sorted(matrix.items()) if value != 0.0]
        (folder / f"portal_frame_{name}.mtx").write_text("\n".join(lines) + "\n")
    lines = ["# node, x, y, z in m"]
    lines += [f"{i + 1}, {x:g}, {y:g}, 0" for i, (x, y) in enumerate(nodes())]
    (folder / "portal_frame_nodes.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
