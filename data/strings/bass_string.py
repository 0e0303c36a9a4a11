#!/usr/bin/env python3
"""Writes the scene of a bass guitar string over its 20 frets, with any number of modes.

    python3 data/strings/bass_string.py --modes 862 --restitution 0.9 > string.toml
    graze simulate string.toml --duration 1 --energy --record none

The string of C. Issanchou et al. (J. Acoust. Soc. Am. 143, 2018), as Siconos ships it
(examples/mechanics/Music): 0.863 m long, 191.6 N, 0.0067 kg/m. bass_string_modes.csv holds its first
100 modes as they stand there: frequencies and damping ratios, measured up to mode 90 and computed
from there on, and the start, a string plucked near 3/4 of its length.

Beyond mode 100 (what is extrapolated, and how):
- frequencies: n f_1 (1 + B n^2/2), B = 3.5e-5, which modes 91 to 100 obey to the last digit and modes 34
  to 90 to 3e-5. `--stiffness beam` writes n f_1 sqrt(1 + B n^2) instead, of which that is the
  expansion: it is what a stiff string has, and at mode 862 the expansion is 2.7 times as high.
- losses: 1/Q = eta/(mu f) + a/sqrt(f) + delta B n^2 f0/f + c, air, viscoelastic and thermoelastic, with
  eta = 1.8e-5 Pa s and the others fitted to modes 91 to 100, which leaves 4e-11 of a 1/Q of 2.6e-3 to
  3.0e-3. Against measured modes 60 to 90 it is off by 3 % at most; below the measured ones scatter by
  more than they amount to. f0 is the frequency without stiffness.
- the start: zero. At mode 100 it is 1.2e-5 of that of mode 1.
"""
import argparse
import csv
import math
import pathlib

LENGTH = 0.863  # m
TENSION = 191.6  # N
DENSITY = 0.0067  # kg/m
INHARMONICITY = 3.5e-5  # B
AIR_VISCOSITY = 1.8e-5  # Pa s
AIR_FRICTION = 2.2282396103e-3  # a, Hz^1/2
VISCOELASTIC = 9.9976191976e-3  # delta
THERMOELASTIC = 1.39443896e-6  # c
MOST_MODES = 862

# Distance from the nut and below the string at rest, m.
FRETS = [
    (0.048, 0.00063), (0.094, 0.00088), (0.137, 0.00113), (0.178, 0.00133), (0.216, 0.00158),
    (0.253, 0.00173), (0.287, 0.00188), (0.319, 0.00198), (0.350, 0.00213), (0.379, 0.00218),
    (0.406, 0.00223), (0.432, 0.00233), (0.456, 0.00233), (0.479, 0.00233), (0.501, 0.00233),
    (0.521, 0.00233), (0.540, 0.00233), (0.558, 0.002335), (0.576, 0.002335), (0.591, 0.002335),
]


def frequency(n, stiffness):
    """Of mode n without stiffness and with it, Hz."""
    flexible = n * math.sqrt(TENSION / DENSITY) / (2 * LENGTH)
    if stiffness == "beam":
        return flexible, flexible * math.sqrt(1 + INHARMONICITY * n * n)
    return flexible, flexible * (1 + INHARMONICITY * n * n / 2)


def damping_ratio(n, stiffness):
    flexible, stiff = frequency(n, stiffness)
    losses = (AIR_VISCOSITY / (DENSITY * stiff) + AIR_FRICTION / math.sqrt(stiff)
              + VISCOELASTIC * INHARMONICITY * n * n * flexible / stiff + THERMOELASTIC)
    return losses / 2


def modes(count, stiffness):
    """Frequencies, rad/s, damping ratios and the start, m sqrt(kg)."""
    path = pathlib.Path(__file__).with_name("bass_string_modes.csv")
    with path.open(newline="") as file:
        known = [tuple(map(float, row)) for row in list(csv.reader(file))[1:]]
    omegas, ratios, start = [list(column) for column in zip(*known[:count])]
    # The table has unit mass per length.
    start = [q * math.sqrt(DENSITY) for q in start]
    for n in range(len(omegas) + 1, count + 1):
        omegas.append(2 * math.pi * frequency(n, stiffness)[1])
        ratios.append(damping_ratio(n, stiffness))
        start.append(0.0)
    return omegas, ratios, start


def scene(count, restitution, stiffness):
    omegas, ratios, start = modes(count, stiffness)
    lines = [
        f'title = "Bass string over 20 frets, {count} modes"', "", "[string]",
        f"length = {LENGTH}", f"frequencies = {omegas}", f"mass_per_length = {DENSITY}",
        f"modes = {count}", "", "[damping]", f"ratios = {ratios}", "", "[initial]", f"q = {start}",
    ]
    for position, gap in FRETS:
        lines += ["", "[[stop]]", f"position = {position}", f"gap = {gap}", 'side = "below"',
                  f"restitution = {restitution}"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--modes", type=int, default=MOST_MODES)
    parser.add_argument("--restitution", type=float, default=0.9)
    parser.add_argument("--stiffness", choices=("expansion", "beam"), default="expansion",
                        help="law of the frequencies beyond mode 100")
    arguments = parser.parse_args()
    if not 1 <= arguments.modes <= MOST_MODES:
        parser.error(f"--modes must be from 1 to {MOST_MODES}")
    print(scene(arguments.modes, arguments.restitution, arguments.stiffness), end="")


if __name__ == "__main__":
    main()
