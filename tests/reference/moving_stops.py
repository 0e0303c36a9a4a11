#!/usr/bin/env python3
"""Motions against stops that move, in inertial coordinates: the stop's motion stands explicitly in the contact conditions.

    M x'' + C x' + K x = forces,     stop k:  side (s_k(t) - x_p) >= 0,     s_k = side gap + m_k(t)  (or gap in space),

with a rigid stop (v - s') -> -r (v - s'), or a massless spring K_s side (s - x_p) while side (x_p - s) > 0. No change
to the stop's coordinate is made anywhere. Every piece (free, on a spring, stuck to a moving stop) is a finite sum of
exponentials and a polynomial, from the eigenvectors of the first order system and its harmonic responses. Events are
first zeros of its Taylor polynomials (polynomial_zeros.py, proved to be the first).

Stuck: x_p = s(t) as long as the push  side (a_p - s'')  is positive, a_p the acceleration that the point would have
without the stop. A chatter is closed where an impact is slower than 1e-18 of the fastest: the rest takes
2 v r/(push (1 - r)), to first order in v.

Decimal numbers are the doubles nearest to them; 20 pi is exact. All is computed at two precisions, which must agree in
the 20 digits of the table.

    python3 moving_stops.py [file.csv]
"""
import csv
import sys
from collections import namedtuple

from mpmath import binomial, cos, exp, expj, lu_solve, matrix, mp, mpc, mpf, nstr, pi, sin, sqrt

from polynomial_zeros import first_zero, value


def number(text):
    return mpf(float(text))


# Sums of exponentials

class Signal:
    """f(t0 + s) = sum poly_n s^n + real part of sum a e^(mu s), over the terms (a, mu)."""

    def __init__(self, poly, terms):
        self.poly, self.terms = list(poly), list(terms)
    def __add__(self, other):
        size = max(len(self.poly), len(other.poly))
        padded = [p + [mpf(0)] * (size - len(p)) for p in (self.poly, other.poly)]
        return Signal([x + y for x, y in zip(*padded)], self.terms + other.terms)
    def __rmul__(self, factor):
        return Signal([factor * p for p in self.poly], [(factor * a, mu) for a, mu in self.terms])
    def __sub__(self, other):
        return self + (-1) * other
    def rate(self):
        return Signal([n * p for n, p in enumerate(self.poly)][1:], [(mu * a, mu) for a, mu in self.terms])
    def at(self, s):
        return value(self.poly, s) + sum((a * exp(mu * s)).real for a, mu in self.terms)
    def taylor(self, s, h):
        """Coefficients about t0 + s, all that count over a step h."""
        size = len(self.poly)
        out = [sum(binomial(k, n) * self.poly[k] * s ** (k - n) for k in range(n, size)) for n in range(size)]
        parts = [a * exp(mu * s) for a, mu in self.terms]
        largest, n, power, quiet = mpf(0), 0, mpf(1), 0
        while quiet < 3:
            c = sum(p.real for p in parts)
            out[n:n + 1] = [out[n] + c if n < len(out) else c]
            size = sum(abs(p) for p in parts) * power
            largest = max(largest, size)
            quiet = quiet + 1 if size <= largest * mpf(10) ** (-mp.dps - 8) else 0
            n, power = n + 1, power * h
            parts = [p * mu / n for p, (_, mu) in zip(parts, self.terms)]
        return out


class Prescribed:
    """A motion or force given for all time: a + b t + sum A cos(w t + phase)."""

    def __init__(self, a=0, b=0, harmonics=()):
        self.a, self.b, self.harmonics = mpf(a), mpf(b), list(harmonics)
    def signal(self, t0):
        return Signal([self.a + self.b * t0, self.b],
                      [(A * expj(w * t0 + phase), mpc(0, w)) for A, w, phase in self.harmonics])
    def shifted(self, a):
        return Prescribed(self.a + a, self.b, self.harmonics)
    def derivative(self):
        return Prescribed(self.b, 0, [(A * w, w, phase + pi / 2) for A, w, phase in self.harmonics])
    def scaled(self, f):
        return Prescribed(f * self.a, f * self.b, [(f * A, w, phase) for A, w, phase in self.harmonics])


Stop = namedtuple('Stop', 'point side place r k', defaults=(None, None))     # side +1: above; r: rigid, or k: a spring


# What moves

class Structure:
    def __init__(self, masses, K, C, forces):
        """forces: (point, Prescribed)."""
        self.m, self.K, self.C, self.forces, self.n = masses, K, C, forces, len(masses)
        self.eigen = {}

    def solve(self, name, points, K, t0, x, v, loads):
        """Motion of some points, the loads (point, Signal) given; K with the contact springs."""
        n, M = len(points), [self.m[i] for i in points]
        C = [[self.C[i][j] for j in points] for i in points]
        K = [[K[i][j] for j in points] for i in points]
        if name not in self.eigen:
            with mp.extradps(15):
                A = matrix(2 * n, 2 * n)
                for i in range(n):
                    A[i, n + i] = mpf(1)
                    for j in range(n):
                        A[n + i, j], A[n + i, n + j] = -K[i][j] / M[i], -C[i][j] / M[i]
                self.eigen[name] = mp.eig(A)
        rates, vectors = self.eigen[name]
        out = [Signal([], []) for _ in points]
        for p, load in loads:
            b = [mpf(i == p) for i in points]
            for a, mu in load.terms:
                G = matrix([[K[i][j] + mu * C[i][j] + (mu ** 2 * M[i] if i == j else 0) for j in range(n)]
                            for i in range(n)])
                X = lu_solve(G, matrix([a * z for z in b]))
                out = [o + Signal([], [(X[i], mu)]) for i, o in enumerate(out)]
            level, slope = (load.poly + [mpf(0)] * 2)[:2]
            X1 = lu_solve(matrix(K), matrix([slope * z for z in b]))
            X0 = lu_solve(matrix(K), level * matrix(b) - matrix(C) * X1)
            out = [o + Signal([X0[i], X1[i]], []) for i, o in enumerate(out)]
        left = [x[i] - o.at(0) for i, o in zip(points, out)] + [v[i] - o.rate().at(0) for i, o in zip(points, out)]
        c = lu_solve(vectors, matrix(left))
        return [o + Signal([], [(c[k] * vectors[i, k], rates[k]) for k in range(2 * n)]) for i, o in enumerate(out)]

    def free(self, t0, x, v, stop=None):
        """Without contact, or on the spring of one stop."""
        K, loads = [list(row) for row in self.K], [(p, f.signal(t0)) for p, f in self.forces]
        if stop:
            K[stop.point][stop.point] += stop.k
            loads.append((stop.point, stop.k * stop.place.signal(t0)))
        return self.solve(stop, list(range(self.n)), K, t0, x, v, loads)

    def acceleration(self, t0, xs, i):
        """The acceleration of point i from all but the stops."""
        total = sum((f.signal(t0) for p, f in self.forces if p == i), Signal([], []))
        for j in range(self.n):
            total = total - self.K[i][j] * xs[j] - self.C[i][j] * xs[j].rate()
        return (1 / self.m[i]) * total

    def stuck(self, t0, x, v, stop):
        i, s = stop.point, stop.place.signal(t0)
        others = [j for j in range(self.n) if j != i]
        loads = [(p, f.signal(t0)) for p, f in self.forces if p != i]
        loads += [(j, -self.K[j][i] * s - self.C[j][i] * s.rate()) for j in others]
        xs = dict(zip(others, self.solve(('stuck', i), others, self.K, t0, x, v, loads))) if others else {}
        xs[i] = s
        return [xs[j] for j in range(self.n)]


class Ball:
    def __init__(self, g):
        self.g = g
    def free(self, t0, x, v):
        return [Signal([x[0], v[0], -self.g / 2], [])]
    def acceleration(self, t0, xs, i):
        return Signal([-self.g], [])
    def stuck(self, t0, x, v, stop):
        return [stop.place.signal(t0)]


# The motion

def march(watched, limit):
    """(s, which) of the earliest zero of the watched (signal, number of zeros at the start) before `limit`, or none."""
    fastest = max([abs(mu) for f, _ in watched for _, mu in f.terms] + [mpf(1)])
    h, s, first = 1 / fastest, mpf(0), True
    while s < limit:
        found = []
        for which, (f, zeros) in enumerate(watched):
            zero = first_zero(f.taylor(s, h)[zeros if first else 0:], h)
            found += [(s + zero, which)] if zero is not None and s + zero < limit else []
        if found:
            return min(found)
        s, first = s + h, False
    return limit, None


def simulate(body, stops, x, v, instants=(), impacts=20, end=None, t=mpf(0), known=None, listed=20):
    """Rows (event, time, speed, value) until so many impacts (or contacts) and until `end`; of them the first `listed`."""
    rows, mode, stop, known = [], 'free', None, known or {}
    left = sorted(instants)
    end, fastest, count = max([end or mpf(0)] + left), mpf(0), 0
    while count < impacts or t < end:
        if mode == 'free':
            xs = body.free(t, x, v)
            watched = [(k.side * (k.place.signal(t) - xs[k.point]), known.get(k, 0)) for k in stops]
        elif mode == 'spring':
            xs = body.free(t, x, v, stop)
            watched = [(stop.side * (xs[stop.point] - stop.place.signal(t)), 1)]
        else:
            xs = body.stuck(t, x, v, stop)
            push = stop.side * (body.acceleration(t, xs, stop.point) - stop.place.signal(t).rate().rate())
            watched = [(push, 0)]
        s, which = march(watched, mpf(20) if count < impacts else end - t)
        while left and left[0] <= t + s:
            now = left.pop(0)
            for i, f in enumerate(xs):
                rows += [(f'u{i + 1}', now, '', f.at(now - t)), (f'v{i + 1}', now, '', f.rate().at(now - t))]
        if which is None:
            break
        t = t + s
        x, v, known = [f.at(s) for f in xs], [f.rate().at(s) for f in xs], {}
        if mode == 'stuck':
            rows.append(('release', t, '', ''))
            mode, known = 'free', {stop: 3}
            continue
        stop = stops[which] if mode == 'free' else stop
        i, place = stop.point, stop.place.signal(t)
        speed = stop.side * (v[i] - place.rate().at(0))
        if mode == 'spring':
            if count <= listed:
                rows.append(('separation', t, -speed, ''))
            mode, known = 'free', {stop: 1}
            continue
        count, fastest = count + 1, max(fastest, speed)
        if count <= listed:
            rows.append(('contact' if stop.k else 'impact', t, speed, ''))
        if stop.k:
            mode = 'spring'
            continue
        v[i] = place.rate().at(0) - stop.r * (v[i] - place.rate().at(0))
        known = {stop: 1}
        if stop.r == 0 or speed < fastest * mpf(10) ** -18:
            xs = body.free(t, x, v)
            push = stop.side * (body.acceleration(t, xs, i) - place.rate().rate()).at(0)
            if push <= 0:                                     # r = 0: leaves at once, without speed
                known = {stop: 2}
                continue
            tail = 2 * speed * stop.r / (push * (1 - stop.r))
            t, x, v = t + tail, [f.at(tail) for f in xs], [f.rate().at(tail) for f in xs]
            place, mode = stop.place.signal(t), 'stuck'
            x[i], v[i] = place.at(0), place.rate().at(0)
            rows.append(('stick', t, '', ''))
    return rows


# The cases

def sdnd102(out):
    """A: Code_Aster SDND102, a foot shaken by y with the acceleration sin W t, a stop with a spring in space. Printed are
    absolute displacements and velocities, x = u + y."""
    m, k, gap, ks, W = number(25), number(98696), number('5e-4'), number('5.76e7'), 20 * pi
    c = 2 * number('0.07') * sqrt(k * m)
    y = Prescribed(0, 0, [(1 / W ** 2, W, pi / 2)])                       # -sin(W t)/W^2
    body = Structure([m], [[k]], [[c]], [(0, y.scaled(k)), (0, y.derivative().scaled(c))])
    start = y.signal(0)
    times = [mpf(x) for x in ('0.05', '0.156', '0.25', '0.4', '0.5', '0.8', '0.9', '1')]
    for row in simulate(body, [Stop(0, 1, Prescribed(gap), k=ks)], [start.at(0)], [start.rate().at(0)], times, impacts=0):
        out('A', 'in_space', *row)


def ball(out):
    """B: table A sin(w t). One impact per period T: the ball leaves and comes with g T/2 (the table is at the same height),
    so that  A w^2 cos p = pi g (1 - r)/(1 + r), V = g T/(1 + r). The linearised map (time, speed after the impact) has
    determinant r^2 and trace 1 + r^2 - (1 + r)^2 A w^2 sin p/g: a multiplier 1 at sin p = 0 (the saddle-node), -1 at
    A w^2 sin p = 2 g (1 + r^2)/(1 + r)^2 (the doubling). Then a chatter, A w^2 = 1.3 g."""
    g, w, T = number('9.81'), number(60), 2 * pi / number(60)
    for r, A in (('0.5', '0.0035'), ('0.8', '0.002')):
        variant, r, A, V = f'r{r}', number(r), number(A), g * T / (1 + number(r))
        c, d = pi * g * (1 - r) / (1 + r), 2 * g * (1 + r * r) / (1 + r) ** 2       # A w^2 cos p; sin p: the doubling
        out('B', variant, 'saddle_node_amplitude', '', '', c / w ** 2)
        out('B', variant, 'doubling_amplitude', '', '', sqrt(c * c + d * d) / w ** 2)
        out('B', variant, 'doubling_phase', '', '', mp.atan2(d, c))
        for name, sign in (('stable', 1), ('saddle', -1)):
            p = sign * mp.acos(c / (A * w * w))
            half = (1 + r * r - (1 + r) ** 2 * A * w * w * sin(p) / g) / 2
            root = sqrt(mpc(half ** 2 - r * r))
            label = f'A{nstr(A, 5)}_{name}_'
            out('B', variant, label + 'phase', '', V, p)
            for i, z in enumerate((half + root, half - root)):
                out('B', variant, f'{label}multiplier_{i + 1}_re', '', '', z.real)
                out('B', variant, f'{label}multiplier_{i + 1}_im', '', '', z.imag)
            check_orbit(g, w, A, r, p, V, 2 * half)
        check_orbit(g, w, sqrt(c * c + d * d) / w ** 2, r, mp.atan2(d, c), V, -1 - r * r)
    table = Prescribed(0, 0, [(number('0.0035425'), w, -pi / 2)])
    stop = Stop(0, -1, table, number('0.5'))
    for row in simulate(Ball(g), [stop], [number('0.01')], [mpf(0)], [mpf('0.05'), mpf('0.1')], end=mpf('0.3')):
        out('B', 'chatter_r0.5', *row)


def check_orbit(g, w, A, r, p, V, trace):
    """The flight is admissible and comes back after T; trace and determinant of the map from differences."""
    stop = Stop(0, -1, Prescribed(0, 0, [(A, w, -pi / 2)]), r)

    def step(t, u):
        (_, after, speed, _), = simulate(Ball(g), [stop], [A * sin(w * t)], [u], impacts=1, t=t, known={stop: 1})
        return after, A * w * cos(w * after) + r * speed
    t, u = p / w, g * pi / w
    after, up = step(t, u)
    h = mpf(10) ** (-mp.dps // 3)
    a, b, c, d = ((x - y) / (2 * h) for e, f in ((h, 0), (0, h)) for x, y in zip(step(t + e, u + f), step(t - e, u - f)))
    errors = after - t - 2 * pi / w, up - u, a + d - trace, a * d - b * c - r * r
    assert max(abs(x) for x in errors) < mpf(10) ** -20, errors


def structures(out):
    """C: two masses in a row, a stop at the second that moves with the orders 1 and 1.5 of the force. (With a force of 3 N
    instead of 20 N the mass stays 2 mm away from it.)"""
    k1, k2, c1, c2 = number(8000), number(5000), number('1.5'), number('0.8')
    force = Prescribed(0, 0, [(number(20), number(30), number('0.4'))])
    place = Prescribed(number('0.004'), 0, [(number('0.001'), number(30), number('1.1')),
                                            (number('0.0006'), number(45), number('-0.3'))])
    body = Structure([number(2), number(1)], [[k1 + k2, -k2], [-k2, k2]], [[c1 + c2, -c2], [-c2, c2]], [(0, force)])
    times = [number(x) for x in ('0.25', '0.5', '1', '2')]
    stops = [(f'r{r}', Stop(1, 1, place, number(r))) for r in ('0', '0.5', '1')]
    for variant, stop in stops + [('k4e4', Stop(1, 1, place, k=number('4e4')))]:
        for row in simulate(body, [stop], [mpf(0)] * 2, [mpf(0)] * 2, times):
            out('C', variant, *row)

    # D: an oscillator that only the stop moves
    place = Prescribed(number('0.002'), 0, [(number('0.003'), number(18), 0)])
    body = Structure([number(1)], [[number(400)]], [[number('0.8')]], [])
    for row in simulate(body, [Stop(0, 1, place, number('0.6'))], [mpf(0)], [mpf(0)], times):
        out('D', 'r0.6', *row)


def table(digits):
    rows = []
    with mp.workdps(digits):
        def out(*row):
            rows.append([x if isinstance(x, str) else nstr(x, 20) for x in row])
        for case in (sdnd102, ball, structures):
            case(out)
    return rows


if __name__ == '__main__':
    rows = table(50)
    assert rows == table(70), "the two precisions differ"
    with open(sys.argv[1], 'w', newline='') if len(sys.argv) > 1 else sys.stdout as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(['case', 'variant', 'event', 'time', 'speed', 'value'])
        writer.writerows(rows)
