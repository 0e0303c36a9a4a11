#!/usr/bin/env python3
"""Modes of beams, strings and bars from the closed solutions of their equations, in 40 digits.

Writes beams.csv (frequency and mass-normalised shape at three places, modes 1 to 8) and the scenes
of the same structures, cases/beams/*.toml. Nothing of Graze is used.

Uniform pieces of a beam: EI w'''' - T w'' = m w0^2 w, solved by cosh(a x), sinh(a x), cos(b x),
sin(b x); of a string or a bar: cos(k x), sin(k x). Wedge (I ~ x^3, A ~ x):
x^-1/2 Z_1(2 k x^1/2), cone (I ~ x^4, A ~ x^2): x^-1 Z_2(2 k x^1/2), Z = J, Y, I, K, k^4 = m w0^2/EI
at x = 1 (H. H. Mabie, C. B. Rogers, J. Acoust. Soc. Am. 36, 1964). The coefficients of all pieces
solve a homogeneous system: conditions at the ends and at the joints of pieces, where springs,
masses and supports are. Its determinant is scanned for changes of sign.
"""
import csv
import os
import sys

import mpmath as mp

mp.mp.dps = 40
HERE = os.path.dirname(os.path.abspath(__file__))
MODES = 8
L = mp.mpf("0.8")


class Uniform:
    """Uniform piece of a beam: d-th derivatives of four solutions at x from its start."""

    def __init__(self, length, EI, m, T=0):
        self.length, self.EI0, self.m0, self.T = mp.mpf(length), mp.mpf(EI), mp.mpf(m), mp.mpf(T)
        self.order = 2

    def EI(self, x):
        return self.EI0

    def m(self, x):
        return self.m0

    def set(self, w):
        root = mp.sqrt(self.T**2 + 4 * self.EI0 * self.m0 * w**2)
        self.a = mp.sqrt((root + self.T) / (2 * self.EI0))
        self.b = mp.sqrt((root - self.T) / (2 * self.EI0))

    def solutions(self, x, d):
        a, b, back = self.a, self.b, self.length - x
        # e^{-a x} and e^{-a (l - x)} in place of cosh and sinh: the system stays well scaled.
        return [(-a) ** d * mp.exp(-a * x), a**d * mp.exp(-a * back),
                b**d * mp.cos(b * x + d * mp.pi / 2), b**d * mp.sin(b * x + d * mp.pi / 2)]

    def shear(self, x):  # (EI w'')' - T w'
        return [self.EI0 * s3 - self.T * s1
                for s3, s1 in zip(self.solutions(x, 3), self.solutions(x, 1))]


class Bessel:
    """Tapered piece: EI = c xi^(n+2), m = m1 xi^n; n = 1 wedge, 2 cone; xi from `start`, rising
    or falling with x."""

    def __init__(self, length, xi0, xi1, c, m1, n):
        self.length, self.xi0, self.xi1, self.c, self.m1, self.n = (
            mp.mpf(length), mp.mpf(xi0), mp.mpf(xi1), mp.mpf(c), mp.mpf(m1), n)
        self.order = 2
        self.T = 0
        self.slope = (self.xi1 - self.xi0) / self.length

    def xi(self, x):
        return self.xi0 + self.slope * x

    def EI(self, x):
        return self.c * self.xi(x) ** (self.n + 2)

    def m(self, x):
        return self.m1 * self.xi(x) ** self.n

    def set(self, w):
        # in xi: (c xi^(n+2) W'')'' slope^4 = m1 xi^n w^2 W
        self.k = mp.root(self.m1 * w**2 / (self.c * self.slope**4), 4)

    def base(self, z):
        n = self.n
        return [lambda x: mp.besselj(n, z(x)), lambda x: mp.bessely(n, z(x)),
                lambda x: mp.besseli(n, z(x)), lambda x: mp.besselk(n, z(x))]

    def solutions(self, x, d):
        # xi^(-n/2) Z_n(2 k sqrt(xi)) has d-th derivative (-+k)^d xi^(-(n+d)/2) Z_(n+d).
        xi, k, n = self.xi(x), self.k, self.n + d
        z = 2 * k * mp.sqrt(xi)
        f = xi ** (-mp.mpf(n) / 2) * k**d * self.slope**d
        return [f * (-1) ** d * mp.besselj(n, z), f * (-1) ** d * mp.bessely(n, z),
                f * mp.besseli(n, z), f * (-1) ** d * mp.besselk(n, z)]

    def shear(self, x):
        dEI = (self.n + 2) * self.c * self.xi(x) ** (self.n + 1) * self.slope
        return [self.EI(x) * s3 + dEI * s2
                for s3, s2 in zip(self.solutions(x, 3), self.solutions(x, 2))]


class Line:
    """Piece of a string or a bar, uniform or a conical bar (area ~ xi^2, u = sin(k xi)/xi)."""

    def __init__(self, length, stiffness, m, xi=None):
        self.length, self.S0, self.m0, self.xis, self.order = (
            mp.mpf(length), mp.mpf(stiffness), mp.mpf(m), xi, 1)
        if xi:
            self.slope = (mp.mpf(xi[1]) - mp.mpf(xi[0])) / self.length

    def scale(self, x):
        return (mp.mpf(self.xis[0]) + self.slope * x) if self.xis else mp.mpf(1)

    def S(self, x):
        return self.S0 * self.scale(x) ** 2

    def m(self, x):
        return self.m0 * self.scale(x) ** 2

    def set(self, w):
        self.k = w * mp.sqrt(self.m0 / self.S0)

    def solutions(self, x, d):
        k = self.k
        own = lambda e: [k**e * mp.cos(k * x + e * mp.pi / 2), k**e * mp.sin(k * x + e * mp.pi / 2)]
        if not self.xis:
            return own(d)
        xi, s = self.scale(x), self.slope
        if d == 0:
            return [u / xi for u in own(0)]
        return [u1 / xi - s * u0 / xi**2 for u1, u0 in zip(own(1), own(0))]


def conditions(case, w):
    """Rows of the homogeneous system."""
    pieces = case["pieces"]
    for p in pieces:
        p.set(w)
    order = pieces[0].order
    per = 2 * order
    n = per * len(pieces)
    rows = []

    def put(k, numbers, sign=1, row=None):
        row = row if row is not None else [mp.mpf(0)] * n
        for i, number in enumerate(numbers):
            row[per * k + i] += sign * number
        return row

    def joint(left, right, at):
        """What holds between piece `left` (None) at its end and `right` (None) at its start."""
        k_t, k_r = at.get("kt", 0), at.get("kr", 0)
        M, J = at.get("M", 0), at.get("J", 0)
        held_value, held_slope = at.get("value", False), at.get("slope", False)
        one, x1 = (left, pieces[left].length) if left is not None else (right, mp.mpf(0))
        both = left is not None and right is not None
        derivatives = [(0, held_value)] + ([(1, held_slope)] if order == 2 else [])
        for d, held in derivatives:
            here = pieces[one].solutions(x1, d)
            if held:
                rows.append(put(one, here))
                if both:
                    rows.append(put(right, pieces[right].solutions(mp.mpf(0), d)))
                continue
            if both:
                rows.append(put(right, pieces[right].solutions(mp.mpf(0), d), -1, put(one, here)))
            row = [mp.mpf(0)] * n
            if order == 1:  # force balance: S u'(right) - S u'(left) = (k - M w^2) u
                if right is not None:
                    p = pieces[right]
                    put(right, [p.S(0) * s for s in p.solutions(mp.mpf(0), 1)], 1, row)
                if left is not None:
                    p = pieces[left]
                    put(left, [p.S(p.length) * s for s in p.solutions(p.length, 1)], -1, row)
                put(one, [(k_t - M * w**2) * s for s in here], -1, row)
            elif d == 0:  # shear: Q(left) - Q(right) = (k - M w^2) w, Q = (EI w'')' - T w'
                if left is not None:
                    put(left, pieces[left].shear(pieces[left].length), 1, row)
                if right is not None:
                    put(right, pieces[right].shear(mp.mpf(0)), -1, row)
                put(one, [(k_t - M * w**2) * s for s in here], -1, row)
            else:  # moment: EI w''(right) - EI w''(left) = (k - J w^2) w'
                if right is not None:
                    p = pieces[right]
                    put(right, [p.EI(0) * s for s in p.solutions(mp.mpf(0), 2)], 1, row)
                if left is not None:
                    p = pieces[left]
                    put(left, [p.EI(p.length) * s for s in p.solutions(p.length, 2)], -1, row)
                put(one, [(k_r - J * w**2) * s for s in here], -1, row)
            rows.append(row)

    joints = case["joints"]
    joint(None, 0, joints[0])
    for k in range(1, len(pieces)):
        joint(k - 1, k, joints[k])
    joint(len(pieces) - 1, None, joints[-1])
    matrix = mp.matrix(rows)
    for i in range(n):  # rows of one size
        size = max(abs(matrix[i, j]) for j in range(n))
        for j in range(n):
            matrix[i, j] /= size
    return matrix


def frequencies(case):
    found = []
    f = lambda w: mp.det(conditions(case, w))
    w = mp.mpf(case["step"]) / 50
    last = f(w)
    while len(found) < MODES:
        step = mp.mpf(case["step"]) * (mp.sqrt(len(found) + 1) if case["pieces"][0].order == 2 else 1)
        here = f(w + step)
        if mp.sign(here) != mp.sign(last):
            found.append(mp.findroot(f, (w, w + step), solver="anderson", tol=1e-60, verify=False))
        w, last = w + step, here
    return found


def shape(case, w):
    """Coefficients of unit modal mass, positive at the left end in what it is free to do."""
    A = conditions(case, w)
    n = A.rows
    with mp.workdps(60):
        x = mp.matrix([mp.mpf(1) / (i + 2) for i in range(n)])
        # an exactly singular matrix has no solution
        B = A + mp.mpf(10) ** -38 * mp.eye(n)
        for _ in range(3):
            x = mp.lu_solve(B, x)
            x = x / mp.norm(x, mp.inf)
    per = 2 * case["pieces"][0].order

    def value(k, at, d=0):
        return mp.fsum(x[per * k + i] * s for i, s in enumerate(case["pieces"][k].solutions(at, d)))

    mass = mp.mpf(0)
    for k, p in enumerate(case["pieces"]):
        parts = [p.length * i / 6 for i in range(7)]
        mass += mp.quad(lambda t: p.m(t) * value(k, t) ** 2, parts)
    for k, at in enumerate(case["joints"]):
        piece, t = (k, mp.mpf(0)) if k < len(case["pieces"]) else (k - 1, case["pieces"][-1].length)
        mass += at.get("M", 0) * value(piece, t) ** 2
        if at.get("J", 0):
            mass += at["J"] * value(piece, t, 1) ** 2
    size = max(abs(value(0, case["pieces"][0].length * i / 9)) for i in range(10))
    sign = 1
    for d in range(3):
        end = value(0, mp.mpf(0), d) * L**d
        if abs(end) > size * mp.mpf("1e-6"):
            sign = mp.sign(end)
            break

    def at(place):
        for k, p in enumerate(case["pieces"]):
            if place <= p.length or k == len(case["pieces"]) - 1:
                return sign * value(k, min(place, p.length)) / mp.sqrt(mass)
            place -= p.length

    return at


# Steel: E = 2e11, rho = 7800; a strip of 20 mm by 4 mm.
E, RHO, B_, H = mp.mpf("2e11"), mp.mpf(7800), mp.mpf("0.02"), mp.mpf("0.004")


def EI(b, h):
    return E * b * h**3 / 12


def per_length(b, h):
    return RHO * b * h


STRIP = """[beam]
length = 0.8
youngs_modulus = 2e11
density = 7800
section = { shape = "rectangle", width = 0.02, height = 0.004 }
modes = 8
"""
FREE, PINNED = {}, {"value": True}
CLAMPED, SLIDING = {"value": True, "slope": True}, {"slope": True}


def strip(length, T=0):
    return Uniform(length, EI(B_, H), per_length(B_, H), T)


def ended(ends, left, right):
    return (STRIP + f"ends = {ends}\n", [strip(L)], [left, right], 4)


CASES = {
    "pinned_pinned": ended('["pinned", "pinned"]', PINNED, PINNED),
    "clamped_clamped": ended('["clamped", "clamped"]', CLAMPED, CLAMPED),
    "clamped_pinned": ended('["clamped", "pinned"]', CLAMPED, PINNED),
    "sliding_pinned": ended('["sliding", "pinned"]', SLIDING, PINNED),
    "free_free": ended('["free", "free"]', FREE, FREE),
    "tip_mass": (STRIP + "[[beam.mass]]\nmass = 0.3\ninertia = 2e-4\n", [strip(L)],
                 [CLAMPED, {"M": mp.mpf("0.3"), "J": mp.mpf("2e-4")}], 1),
    "two_spans": (STRIP + 'ends = ["pinned", "pinned"]\n[[beam.support]]\nposition = 0.32\n'
                  'kind = "pinned"\n', [strip("0.32"), strip("0.48")], [PINNED, PINNED, PINNED], 8),
    "stepped": ("""[beam]
length = 0.8
youngs_modulus = 2e11
density = 7800
modes = 8
[[beam.piece]]
to = 0.5
section = { shape = "rectangle", width = 0.03, height = 0.006 }
[[beam.piece]]
section = { shape = "tube", diameter = 0.008, inner_diameter = 0.006 }
youngs_modulus = 7e10
density = 2700
""", [Uniform("0.5", EI(mp.mpf("0.03"), mp.mpf("0.006")), per_length(mp.mpf("0.03"), mp.mpf("0.006"))),
      Uniform("0.3", mp.mpf("7e10") * mp.pi / 64 * (mp.mpf("0.008")**4 - mp.mpf("0.006")**4),
              2700 * mp.pi / 4 * (mp.mpf("0.008")**2 - mp.mpf("0.006")**2))],
                [CLAMPED, FREE, FREE], 4),
    "on_springs": (STRIP + """ends = ["free", "free"]
[[beam.support]]
position = 0
translational = 800
[[beam.support]]
position = 0.5
translational = 3e3
rotational = 25
[[beam.support]]
rotational = 10
""", [strip("0.5"), strip("0.3")],
                   [{"kt": mp.mpf(800)}, {"kt": mp.mpf(3000), "kr": mp.mpf(25)}, {"kr": mp.mpf(10)}], 2),
    "tensioned": (STRIP + 'ends = ["pinned", "pinned"]\ntension = 900\n', [strip(L, 900)],
                  [PINNED, PINNED], 4),
    "compressed": (STRIP + 'ends = ["clamped", "pinned"]\ntension = -400\n'
                   '[[beam.mass]]\nposition = 0.3\nmass = 0.1\n', None,
                   [CLAMPED, {"M": mp.mpf("0.1")}, PINNED], 2),
    # Apex beyond the right end: thickness from 6 mm to 1.2 mm.
    "wedge": (STRIP.replace("height = 0.004", "height = [0.006, 0.0012]"),
              [Bessel(L, 1, "0.2", EI(B_, mp.mpf("0.006")), per_length(B_, mp.mpf("0.006")), 1)],
              [CLAMPED, FREE], 4),
    "cone": (STRIP.replace('"rectangle", width = 0.02, height = 0.004',
                           '"circle", diameter = [0.001, 0.008]') + 'ends = ["free", "clamped"]\n',
             [Bessel(L, "0.125", 1, E * mp.pi / 64 * mp.mpf("0.008")**4,
                     RHO * mp.pi / 4 * mp.mpf("0.008")**2, 2)], [FREE, CLAMPED], 4),
    # To a ten thousandth of the thickness.
    "sharp_wedge": (STRIP.replace("height = 0.004", "height = [0.01, 1e-6]"),
                    [Bessel(L, 1, "0.0001", EI(B_, mp.mpf("0.01")),
                            per_length(B_, mp.mpf("0.01")), 1)], [CLAMPED, FREE], 4),
    "string_with_mass": ("""[string]
length = 0.8
tension = 190
mass_per_length = 0.0067
modes = 8
[[string.mass]]
position = 0.3
mass = 0.004
[[string.support]]
position = 0.6
translational = 2500
""", [Line("0.3", 190, "0.0067"), Line("0.3", 190, "0.0067"), Line("0.2", 190, "0.0067")],
                         [PINNED, {"M": mp.mpf("0.004")}, {"kt": mp.mpf(2500)}, PINNED], 30),
    "bar_on_spring": ("""[bar]
length = 0.8
youngs_modulus = 2e11
density = 7800
modes = 8
[[bar.piece]]
to = 0.5
area = 2e-4
[[bar.piece]]
section = { shape = "circle", diameter = [0.02, 0.005] }
[[bar.support]]
translational = 3e7
""", [Line("0.5", E * mp.mpf("2e-4"), RHO * mp.mpf("2e-4")),
      Line("0.3", E * mp.pi / 4 * mp.mpf("0.02")**2, RHO * mp.pi / 4 * mp.mpf("0.02")**2, (1, "0.25"))],
                      [PINNED, FREE, {"kt": mp.mpf("3e7")}], 900),
}


def compressed():
    text, _, joints, step = CASES["compressed"]
    return text, [strip("0.3", -400), strip("0.5", -400)], joints, step


CASES["compressed"] = compressed()
PLACES = [mp.mpf("0.13"), mp.mpf("0.55"), mp.mpf("0.71")]


def main():
    os.makedirs(os.path.join(HERE, "cases", "beams"), exist_ok=True)
    chosen = sys.argv[1:]  # cases to print alone; nothing is written then
    with open(os.devnull if chosen else os.path.join(HERE, "beams.csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["case", "mode", "omega", "at_013", "at_055", "at_071"])
        for name, (text, pieces, joints, step) in CASES.items():
            if chosen and name not in chosen:
                continue
            with open(os.path.join(HERE, "cases", "beams", name + ".toml"), "w") as scene:
                scene.write("# Written by tests/reference/beams.py.\n" + text)
            case = {"pieces": pieces, "joints": joints, "step": mp.mpf(step)}
            for j, w in enumerate(frequencies(case)):
                at = shape(case, w)
                row = [name, j + 1, mp.nstr(w, 20)] + [mp.nstr(at(x), 18) for x in PLACES]
                table.writerow(row)
                print(*row, flush=True)


if __name__ == "__main__":
    main()
