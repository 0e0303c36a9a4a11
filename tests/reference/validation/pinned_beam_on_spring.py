"""Code_Aster SDNL32 (V5.02.032): a beam pinned at x = 0 turns with -3.8 rad/s until its free tip meets a spring.

The beam is Timoshenko's, as the source's elements are: square section c = 14 mm, shear coefficient 5/6, G = E/2. With
v(x) the deflection, th(x) the rotation of the section, and harmonic motion of frequency w,

    kappa G A (v'' - th') + rho A w^2 v = 0,   E I th'' + kappa G A (v' - th) + rho I w^2 th = 0,

pinned: v = th' = 0 at x = 0; free: th' = v' - th = 0 at x = L. Modes have mass rho A int v^2 + rho I int th^2 = 1; the
first one is the rigid rotation v = x, th = 1. The source takes the ten modes next to 10 Hz: the rotation, eight bending
modes and one longitudinal mode, which the spring does not reach. Each is damped by one per cent of critical.

The tip touches the spring at t = 0. While u = sum b_j q_j < 0,   q_j'' + 2 zeta w_j q_j' + w_j^2 q_j = -k b_j u,   and
without the right side after that. Every step is a Taylor polynomial of the modal coordinates, exact to the working
precision; the end of the contact is the zero of the polynomial of u.

Prints frequencies (rad/s) and tip values (kg^-1/2) of the modes, the tip's displacement every millisecond for springs of
18000 and 45000 N/m, and, to show how far the choice of the model moves it, the largest change of these displacements
with ten bending modes, and with eight Euler-Bernoulli modes.
"""
from mpmath import mp, mpf, cos, cosh, findroot, pi, sin, sinh, sqrt, tan, tanh

from timoshenko import waves

mp.dps = 30

E, rho, side, L, turn, ratio = mpf("6.7e10"), mpf(2400), mpf("0.014"), mpf("0.783"), mpf("-3.8"), mpf("0.01")
A, I = side ** 2, side ** 4 / 12
shear = mpf(5) / 6 * (E / 2)                                        # kappa G
mass = rho * A * L


# ------------------------------------------------------------------ modes
class Shape:
    """v = sin(a x) + r sinh(b x), th = p cos(a x) + r s cosh(b x) of frequency w: pinned at 0, no moment at L."""

    def __init__(self, w):
        self.a, self.b, self.p, self.s = waves(w, E, rho, A, I, shear)
        self.r = self.p * self.a * sin(self.a * L) / (self.s * self.b * sinh(self.b * L))

    def shear_at_tip(self):
        return (self.a - self.p) * cos(self.a * L) + self.r * (self.b - self.s) * cosh(self.b * L)

    def tip(self):
        """|v(L)| of the mode of mass 1; the integrals of products of sin, cos, sinh and cosh in closed form."""
        a, b, p, r, s = self.a, self.b, self.p, self.r, self.s
        sa, ca, sb, cb = sin(a * L), cos(a * L), sinh(b * L), cosh(b * L)
        sin2, cos2 = (L - sa * ca / a) / 2, (L + sa * ca / a) / 2
        sinh2, cosh2 = (sb * cb / b - L) / 2, (sb * cb / b + L) / 2
        sin_sinh = (b * sa * cb - a * ca * sb) / (a ** 2 + b ** 2)
        cos_cosh = (b * ca * sb + a * sa * cb) / (a ** 2 + b ** 2)
        v2 = sin2 + 2 * r * sin_sinh + r ** 2 * sinh2
        th2 = p ** 2 * cos2 + 2 * p * r * s * cos_cosh + (r * s) ** 2 * cosh2
        return abs(sa + r * sb) / sqrt(rho * A * v2 + rho * I * th2)


def timoshenko(count):
    found = [(mpf(0), L / sqrt(mass * L ** 2 / 3 + rho * I * L))]
    for j in range(1, count + 1):
        number = (j + mpf(1) / 4) * pi / L
        near = number ** 2 * sqrt(E * I / (rho * A) / (1 + number ** 2 * I / A * (1 + E / shear)))
        w = findroot(lambda w: Shape(w).shear_at_tip() / cosh(Shape(w).b * L), (near * mpf("0.999"), near * mpf("1.001")))
        found.append((w, Shape(w).tip()))
    assert all(one[0] < other[0] for one, other in zip(found, found[1:]))
    return found


def euler_bernoulli(count):
    """tan y = tanh y; |v(L)| = 2/sqrt(mass)."""
    found = [(mpf(0), sqrt(3 / mass))]
    for j in range(1, count + 1):
        y = findroot(lambda y: tan(y) - tanh(y), (j + mpf(1) / 4) * pi)
        found.append(((y / L) ** 2 * sqrt(E * I / (rho * A)), 2 / sqrt(mass)))
    return found


# ----------------------------------------------------------------- motion
ORDER = 32


def value(poly, s):
    total = mpf(0)
    for c in reversed(poly):
        total = total * s + c
    return total


def tip_motion(modes, k, instants):
    """u at the instants, and the times at which the contact ends or begins."""
    w, b = [one[0] for one in modes], [one[1] for one in modes]
    q, rate = [mpf(0)] * len(w), [turn * L / b[0]] + [mpf(0)] * (len(w) - 1)
    longest = 2 / max(w)
    t, contact, told, changes = mpf(0), True, [], []
    while len(told) < len(instants):
        poly = [[x, y] for x, y in zip(q, rate)]
        u = [sum(c * p[m] for c, p in zip(b, poly)) for m in (0, 1)]
        for m in range(ORDER - 1):
            for p, w_j, b_j in zip(poly, w, b):
                pull = w_j ** 2 * p[m] + 2 * ratio * w_j * (m + 1) * p[m + 1] + (k * b_j * u[m] if contact else 0)
                p.append(-pull / ((m + 1) * (m + 2)))
            u.append(sum(c * p[m + 2] for c, p in zip(b, poly)))
        h = min(longest, instants[len(told)] - t)
        reached, changed = h < longest, False
        for i in range(1, 9):                                       # an eighth of a step is 1/25 of the shortest period
            if (value(u, h * i / 8) > 0) == contact:
                low, h, reached, changed = h * (i - 1) / 8, h * i / 8, False, True
                for _ in range(110):
                    middle = (low + h) / 2
                    if (value(u, middle) > 0) == contact:
                        h = middle
                    else:
                        low = middle
                break
        q = [value(p, h) for p in poly]
        rate = [value([n * c for n, c in enumerate(p)][1:], h) for p in poly]
        t = instants[len(told)] if reached else t + h
        if reached:
            told.append(value(u, h))
        if changed:
            contact = not contact
            changes.append(t)
    return told, changes


instants = [mpf(i) / 1000 for i in range(1, 13)]
modes = timoshenko(8)
for j, (w, tip) in enumerate(modes, 1):
    print(f"frequency_{j}", mp.nstr(w, 20))
    print(f"tip_{j}", mp.nstr(tip, 20))
models = {"ten_bending_modes": timoshenko(10), "euler_bernoulli": euler_bernoulli(8)}
for k in (18000, 45000):
    told, changes = tip_motion(modes, mpf(k), instants)
    for i, u in enumerate(told, 1):
        print(f"tip_{k}_at_{i}_ms", mp.nstr(u, 20))
    for t in changes:
        print(f"contact_{k}_changes_at", mp.nstr(t, 20))
    for name, others in models.items():
        mp.dps = 15                                                 # a difference needs no more
        moved = max(abs(x - y) for x, y in zip(told, tip_motion(others, mpf(k), instants)[0]))
        mp.dps = 30
        print(f"moved_{k}_by_{name}", mp.nstr(moved, 2))
