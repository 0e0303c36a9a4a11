"""Code_Aster SDNL301: a tube, clamped at x = 0, whose four spans end at supports with play.

The tube is Timoshenko's, as the source's elements are: radius 7.95 mm, wall 1.15 mm, length 4 spans of 0.609 m, E, nu, rho
of steel, shear coefficient of a thick tube (Cowper's), thirty modes of mass 1, Rayleigh damping. Forces of 4.138 sin
(251.2 t) N act at eleven points of each span, twelfths of it apart, upwards in spans 1 and 3, downwards in 2 and 4. At the
end of each span stands a stop 0.406 mm away on both sides with the force max(0, k x + C x') while the depth x > 0,
k = 1e5 N/m, C = 0.28 N s/m. With v the deflection and th the rotation of the section,

    kappa G A (v'' - th') + rho A w^2 v = 0,   E I th'' + kappa G A (v' - th) + rho I w^2 th = 0,

clamped: v = th = 0; free: th' = v' - th = 0. Modes in 60 digits, motion by Taylor polynomials in double precision, ends of
contacts by bisection. The source prints the root mean square of the force at the free end from 0.17 s to 0.25 s, both
sides together: 23.98 N with k = 1e5 N/m and thirty modes. k = 1.75e6 N/m is not the source's.

The motion is sensitive: a change of 1e-8 of the play changes the forces by some 1e-5. A root mean square over 0.08 s is
one number of a motion that does not repeat; that of the next four windows of the same length is printed with it.
"""
import math
from mpmath import mp, mpf, cos, cosh, exp, findroot, pi, sin, sinh, sqrt

from timoshenko import waves

mp.dps = 60

E, nu, rho, L = mpf("2.07e11"), mpf("0.3"), mpf(7870), 4 * mpf("0.609")
outer = mpf("0.00795")
inner = outer - mpf("0.00115")
A, I = pi * (outer ** 2 - inner ** 2), pi / 4 * (outer ** 4 - inner ** 4)
r2 = (inner / outer) ** 2
kappa = 6 * (1 + nu) * (1 + r2) ** 2 / ((7 + 6 * nu) * (1 + r2) ** 2 + (20 + 12 * nu) * r2)
shear = kappa * E / (2 * (1 + nu))
MODES, SPAN = 30, 12


class Shape:
    """v = cos ax - cosh bx + r (sin ax - p/s sinh bx), th = -p sin ax - s sinh bx + r p (cos ax - cosh bx)."""

    def __init__(self, w):
        self.a, self.b, self.p, self.s = waves(w, E, rho, A, I, shear)
        a, b, p, s = self.a, self.b, self.p, self.s
        sa, ca, sb, cb = sin(a * L), cos(a * L), sinh(b * L), cosh(b * L)
        self.moment = (-p * a * ca - s * b * cb, -p * a * sa - p * b * sb)           # th' at L, parts of 1 and of r
        force = ((p - a) * sa - (b - s) * sb, (a - p) * ca - p / s * (b - s) * cb)   # v' - th
        self.determinant = (self.moment[0] * force[1] - self.moment[1] * force[0]) / (cb * p * b ** 2)
        self.r = -self.moment[0] / self.moment[1]

    def at(self, x):
        a, b, p, s, r = self.a, self.b, self.p, self.s, self.r
        sa, ca, grow, fall = sin(a * x), cos(a * x), exp(b * x) / 2, exp(-b * x) / 2
        sb, cb = grow - fall, grow + fall
        return ca - cb + r * (sa - p / s * sb), -p * sa - s * sb + r * p * (ca - cb)


# Gauss's rule on [-1, 1]
NODES = [mpf(x) for x in mp.polyroots(mp.taylor(lambda x: mp.legendre(10, x), 0, 10)[::-1], maxsteps=200, extraprec=200)]
WEIGHTS = [2 / ((1 - x ** 2) * mp.diff(lambda y: mp.legendre(10, y), x) ** 2) for x in NODES]


def modes():
    """Frequencies, and the mode shapes at the 48 points of the spans."""
    found = []
    for j in range(1, MODES + 1):
        number = findroot(lambda y: cos(y) + 1 / cosh(y), (2 * j - 1) * pi / 2) / L
        near = number ** 2 * sqrt(E * I / (rho * A) / (1 + number ** 2 * I / A * (1 + E / shear)))
        w = findroot(lambda w: Shape(w).determinant, (near * mpf("0.9995"), near * mpf("1.0005")), tol=mpf(10) ** -90)
        shape, cells = Shape(w), j + 2
        norm = mpf(0)
        for i in range(cells):
            for x, weight in zip(NODES, WEIGHTS):
                v, th = shape.at(L * (i + (x + 1) / 2) / cells)
                norm += weight * L / (2 * cells) * (rho * A * v ** 2 + rho * I * th ** 2)
        found.append((w, [shape.at(L * i / (4 * SPAN))[0] / sqrt(norm) for i in range(4 * SPAN + 1)]))
    assert all(one[0] < other[0] for one, other in zip(found, found[1:]))
    return found


# ----------------------------------------------------------------- motion
ORDER = 24


def value(poly, s):
    total = 0.0
    for c in reversed(poly):
        total = total * s + c
    return total


def rate_of(poly):
    return [n * c for n, c in enumerate(poly)][1:]


class Tube:
    def __init__(self, found, stiffness, play=0.406e-3):
        self.k, self.c, self.play = stiffness, 0.28, play
        self.w2 = [float(w ** 2) for w, _ in found]
        self.d2 = [0.1526 + 1.79e-5 * w2 for w2 in self.w2]                        # 2 delta
        self.force = [4.138 * float(sum((1 if i // SPAN % 2 == 0 else -1) * shape[i] for i in range(4 * SPAN) if i % SPAN))
                      for _, shape in found]
        self.rows = [(side, [side * float(shape[SPAN * n]) for _, shape in found]) for n in (1, 2, 3, 4) for side in (1, -1)]
        self.longest = 2 / math.sqrt(max(self.w2))
        self.q, self.v, self.t = [0.0] * len(found), [0.0] * len(found), 0.0
        self.closed = [False] * 8
        self.contacts = []  # instants at which contacts begin, and stops from 1

    def series(self):
        """Taylor polynomials of the modes, of the depths and of the laws k x + C x'."""
        omega = 251.2
        n = range(len(self.q))
        q = [[x, y] for x, y in zip(self.q, self.v)]
        depth = [[sum(b * p[m] for b, p in zip(row, q)) - (self.play if m == 0 else 0.0) for m in (0, 1)]
                 for _, row in self.rows]
        law = [[] for _ in self.rows]
        wave, factor = (math.sin(omega * self.t), math.cos(omega * self.t)), 1.0
        for m in range(ORDER - 1):
            sine = (wave[0], wave[1], -wave[0], -wave[1])[m % 4] * factor
            factor *= omega / (m + 1)
            for i, x in enumerate(depth):
                law[i].append(self.k * x[m] + self.c * (m + 1) * x[m + 1])
            pulls = [(law[i][m], row) for i, (_, row) in enumerate(self.rows) if self.closed[i]]
            below = 1.0 / ((m + 1) * (m + 2))
            for j in n:
                p = q[j]
                total = self.force[j] * sine - self.d2[j] * (m + 1) * p[m + 1] - self.w2[j] * p[m]
                for pull, row in pulls:
                    total -= pull * row[j]
                p.append(total * below)
            for x, (_, row) in zip(depth, self.rows):
                x.append(sum(b * p[m + 2] for b, p in zip(row, q)))
        return q, depth, law

    def step(self, until, record):
        q, depth, law = self.series()
        h, changed = min(self.longest, until - self.t), None
        # A step is 2 rad of the fastest mode at most; depths and laws are looked at sixteen times a step.
        checks = [(i, law[i] if self.closed[i] else depth[i]) for i in range(8)]
        for n in range(1, 17):
            s = h * n / 16
            crossed = []
            for i, poly in checks:
                y = value(poly, s)
                if (y < 0) if self.closed[i] else (y > 0):
                    low, high = h * (n - 1) / 16, s
                    for _ in range(60):
                        middle = (low + high) / 2
                        y = value(poly, middle)
                        if (y < 0) if self.closed[i] else (y > 0):
                            high = middle
                        else:
                            low = middle
                    crossed.append((high, i))
            if crossed:
                h, changed = min(crossed)
                break
        record(self, law, h)
        self.q = [value(p, h) for p in q]
        self.v = [value(rate_of(p), h) for p in q]
        self.t = until if changed is None and h < self.longest else self.t + h
        if changed is not None:
            self.closed[changed] = not self.closed[changed]
            if self.closed[changed]:
                self.contacts.append((self.t, changed + 1))


GAUSS = [(float(x), float(weight)) for x, weight in zip(NODES, WEIGHTS)]


def root_mean_squares(tube, windows):
    """Of the force at the free end in windows one after the other: of both sides together, and of each."""
    told = []
    for start, end in windows:
        total = [0.0, 0.0]

        def record(tube, law, h):
            for i in (6, 7):
                if tube.closed[i]:
                    total[i - 6] += sum(weight * h / 2 * value(law[i], h * (x + 1) / 2) ** 2 for x, weight in GAUSS)

        while tube.t < start:
            tube.step(start, lambda *_: None)
        while tube.t < end:
            tube.step(end, record)
        told.append([math.sqrt(part / (end - start)) for part in (sum(total), *total)])
    return told


found = modes()
for j, (w, _) in enumerate(found, 1):
    print(f"frequency_{j}", mp.nstr(w, 20))
stiff = Tube(found, 1.75e6)
print("rms_1.75e6", *(f"{rms:.12g}" for rms in root_mean_squares(stiff, [(0.17, 0.25)])[0]))
tube = Tube(found, 1e5)
windows = [(0.17 + 0.08 * n, 0.25 + 0.08 * n) for n in range(5)]
for (start, end), rms in zip(windows, root_mean_squares(tube, windows)):
    print("rms_1e5" + ("" if start == 0.17 else f"_from_{start:.2f}_to_{end:.2f}"), *(f"{part:.12g}" for part in rms))
for name, motion, shown in (("1e5", tube, (1, 2, 5, 10, 20, 40, 60, 80, 98)), ("1.75e6", stiff, (1, 2, 5, 10, 20))):
    print(f"contacts_{name}_until_0.25", sum(1 for t, _ in motion.contacts if t <= 0.25))
    for n in shown:
        print(f"contact_{n}_{name}", f"{motion.contacts[n - 1][0]:.14g}", "stop", motion.contacts[n - 1][1])
