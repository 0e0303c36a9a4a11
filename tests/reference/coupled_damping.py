#!/usr/bin/env python3
"""Structures whose damping couples the modes: impacts, orbits and multipliers to 20 digits.

In first order, x' = A x + b + Re(B e^{i(Omega t + psi)}) with x = (u, u') of the masses themselves, so nothing is
shared with a program that works in natural modes. Between impacts the motion is a sum of exponentials about its
harmonic response; the first contact is found by steps of a part of the quickest period, bisection and a check of
every minimum of the gap in between. With E the free motion over a period, J the impact and P the harmonic response
the (1, 1) orbits are the solutions of

    (I - E J) x- = (I - E) Re(P e^{i phi}),     c.u = gap,

and their multipliers the eigenvalues of E S, S = J + (f+ - J f-) c^T/(c^T f-).

    python3 coupled_damping.py           writes coupled_impacts.csv, coupled_orbits.csv and coupled_rates.csv,
                                         the exponents of the free motion
"""
import csv
import pathlib
import tomllib

from mpmath import mp, mpf

HERE = pathlib.Path(__file__).resolve().parent
CASES = ["dashpot", "free", "gyroscopic", "defective"]
IMPACTS = 20


def read(case):
    with open(HERE / "cases" / "coupled" / f"{case}.toml", "rb") as file:
        return tomllib.load(file)


class Structure:
    def __init__(self, scene):
        lumped = scene["lumped"]
        n = self.n = len(lumped["masses"])
        mass, damping, stiffness = mp.zeros(n), mp.zeros(n), mp.zeros(n)
        for i, value in enumerate(lumped["masses"]):
            mass[i, i] = mpf(value)
        for spring in lumped.get("spring", []):
            ends = [end - 1 for end in spring["between"]]
            for matrix, value in ((stiffness, spring.get("stiffness", 0.0)), (damping, spring.get("damping", 0.0))):
                for i in ends:
                    if i >= 0:
                        matrix[i, i] += mpf(value)
                if min(ends) >= 0:
                    matrix[ends[0], ends[1]] -= mpf(value)
                    matrix[ends[1], ends[0]] -= mpf(value)
        for pair in lumped.get("gyroscopic", []):
            i, j = (end - 1 for end in pair["between"])
            damping[i, j] += mpf(pair["coefficient"])
            damping[j, i] -= mpf(pair["coefficient"])
        inverse = mass ** -1
        self.a = mp.zeros(2 * n)
        for i in range(n):
            self.a[i, n + i] = 1
        self.lower(self.a, -inverse * stiffness, 0)
        self.lower(self.a, -inverse * damping, n)
        forcing = scene.get("forcing")
        self.omega = mpf(forcing["frequency"]) if forcing else mpf(0)
        self.response = mp.zeros(2 * n, 1)
        if forcing:
            push = mp.zeros(2 * n, 1)
            push[n + forcing["mass"] - 1] = mpf(forcing["amplitude"]) * inverse[forcing["mass"] - 1, forcing["mass"] - 1]
            self.response = mp.lu_solve(1j * self.omega * mp.eye(2 * n) - self.a, push)
        self.values, vectors = mp.eig(self.a)
        self.vectors, self.inverse = vectors, vectors ** -1
        stop = scene["stop"][0]
        self.row = mp.zeros(1, 2 * n)
        self.row[stop["mass"] - 1] = 1
        if "against" in stop:
            self.row[stop["against"] - 1] = -1
        self.gap = mpf(stop["gap"])
        self.r = mpf(stop.get("restitution", 0.0))
        self.direction = inverse * self.row[:, :n].T
        self.direction /= (self.row[:, :n] * self.direction)[0]
        self.jump = mp.eye(2 * n)
        self.lower(self.jump, mp.eye(n) - (1 + self.r) * self.direction * self.row[:, :n], n)
        initial = scene.get("initial", {})
        self.start = mp.matrix([mpf(x) for x in initial.get("displacement", [0.0] * n) +
                                initial.get("velocity", [0.0] * n)])

    def lower(self, matrix, block, column):
        for i in range(self.n):
            for j in range(self.n):
                matrix[self.n + i, column + j] = block[i, j]

    def forced(self, t):
        return (self.response * mp.expj(self.omega * t)).apply(mp.re)

    def rate(self, x, t):
        push = 1j * self.omega * self.response - self.a * self.response
        return self.a * x + (push * mp.expj(self.omega * t)).apply(mp.re)


class Flight:
    """From x at time t0."""

    def __init__(self, of, t0, x):
        self.of, self.t0 = of, t0
        amplitudes = of.inverse * (x - of.forced(t0))
        self.terms = [(of.vectors[:, k] * amplitudes[k], of.values[k]) for k in range(2 * of.n)]
        self.gap_terms = [((of.row * v)[0], rate) for v, rate in self.terms]

    def state(self, s):
        x = self.of.forced(self.t0 + s)
        for v, rate in self.terms:
            x += (v * mp.exp(rate * s)).apply(mp.re)
        return x

    def gap(self, s, order=0):
        of = self.of
        sum_ = sum((size * rate ** order * mp.exp(rate * s)).real for size, rate in self.gap_terms)
        turn = (of.row * of.response)[0] * (1j * of.omega) ** order * mp.expj(of.omega * (self.t0 + s))
        return (of.gap if order == 0 else 0) - sum_ - mp.re(turn)

    def first_contact(self, touching, longest):
        quickest = max([abs(v) for v in self.of.values] + [self.of.omega])
        step = mpf(1) / (16 * quickest)
        s = mpf(0)
        skip = touching
        while s < longest:
            there = s + step
            low, high = self.gap(s), self.gap(there)
            if skip:
                low, skip = mpf(1), False
            if high < 0:
                return self.bisect(s if low > 0 else s + step / 64, there)
            if self.gap(s, 1) < 0 < self.gap(there, 1):       # a minimum lies between
                a, b = s, there
                for _ in range(3 * mp.dps):
                    middle = (a + b) / 2
                    a, b = (middle, b) if self.gap(middle, 1) < 0 else (a, middle)
                if self.gap(a) < 0:
                    return self.bisect(s, a)
            s = there
        return None

    def bisect(self, a, b):
        assert self.gap(b) < 0
        if self.gap(a) <= 0:                                  # has just left the stop
            while self.gap(a) <= 0:
                a += (b - a) / 1024
        for _ in range(4 * mp.dps):
            middle = (a + b) / 2
            a, b = (a, middle) if self.gap(middle) < 0 else (middle, b)
        return a


def impacts(of):
    t, x, touching, rows = mpf(0), of.start, False, []
    while len(rows) < IMPACTS:
        flight = Flight(of, t, x)
        s = flight.first_contact(touching, mpf(200))
        if s is None:
            break
        before = flight.state(s)
        speed = (of.row[:, :of.n] * before[of.n:, :])[0]
        if speed < mpf(10) ** -6:
            break
        t, x, touching = t + s, of.jump * before, True
        rows.append((t, speed))
    return rows


def orbits(of):
    size = 2 * of.n
    period = 2 * mp.pi / of.omega
    free = (of.vectors * mp.diag([mp.exp(v * period) for v in of.values]) * of.inverse).apply(mp.re)
    complete = mp.lu_solve(mp.eye(size) - free * of.jump, (mp.eye(size) - free) * of.response)
    kappa = (of.row * complete)[0]
    if abs(kappa) < abs(of.gap):
        return
    for sign in (1, -1):
        phi = (sign * mp.acos(of.gap / abs(kappa)) - mp.arg(kappa)) % (2 * mp.pi)
        x = (complete * mp.expj(phi)).apply(mp.re)
        speed = (of.row[:, :of.n] * x[of.n:, :])[0]
        flight = Flight(of, phi / of.omega, of.jump * x)
        clear = min(flight.gap(period * k / 2000) for k in range(1, 2000))
        f, after = of.rate(x, phi / of.omega), of.rate(of.jump * x, phi / of.omega)
        saltation = of.jump + (after - of.jump * f) * of.row / (of.row * f)[0]
        values = sorted(mp.eig(free * saltation, left=False, right=False), key=lambda v: (-abs(v), -mp.im(v)))
        yield phi, speed, clear, values


def text(x):
    return mp.nstr(x, 20, strip_zeros=False)


def main():
    mp.dps = 50
    with open(HERE / "coupled_impacts.csv", "w") as first, open(HERE / "coupled_orbits.csv", "w") as second, \
            open(HERE / "coupled_rates.csv", "w") as third:
        times, found, rates = (csv.writer(file, lineterminator="\n") for file in (first, second, third))
        times.writerow(["case", "impact", "time", "speed"])
        found.writerow(["case", "phase", "speed", "clearance"] + [f"{part}{k}" for k in range(1, 5) for part in ("re", "im")])
        rates.writerow(["case", "re", "im"])
        for case in CASES:
            of = Structure(read(case))
            for value in sorted(of.values, key=lambda v: (mp.im(v), mp.re(v))):
                rates.writerow([case, text(mp.re(value)), text(mp.im(value))])
            for k, (t, speed) in enumerate(impacts(of)):
                times.writerow([case, k + 1, text(t), text(speed)])
            if of.omega > 0:
                for phi, speed, clear, values in orbits(of):
                    found.writerow([case, text(phi), text(speed), mp.nstr(clear, 6)] +
                                   [text(part) for v in values for part in (mp.re(v), mp.im(v))])


if __name__ == "__main__":
    main()
