"""Periodic motions with several impacts, or several contacts with springs, at any number of digits.

Modes q_j'' + 2 delta_j q_j' + w_j^2 q_j = f_j A cos(Omega t + psi), or a sum of such forces. A stop at b.q = a (side +1) or b.q = -a (side -1):
with x = side b.q - a either rigid, x' turned into -r x' at x = 0 by an impulse along b, or a spring with a dashpot,
force F = k x + c x' from x = 0 on until F = 0. Between such events the motion is linear and is carried on exactly. Given the
sequence of events and rough times, the state at force phase 0 that comes back after p periods is found by
Newton's method; the multipliers are those of this map.
"""
from mpmath import mp, mpf, matrix, eye, lu_solve, pi

from one_impact import number, show

mp.dps = 40


class System:
    def __init__(self, w, zeta, f, A, omega, psi, stops, further=()):
        """stops: (b, a, side, r) or (b, a, side, k, c). further: (order, f_j A, phase) of forces at multiples of Omega,
        whose phases are at the time at which that of the first is psi."""
        self.n, self.omega, self.psi = len(w), number(omega), number(psi)
        self.w, self.zeta = [number(x) for x in w], [number(x) for x in zeta]
        self.loads = [(1, [number(x) * number(A) for x in f], self.psi)]
        self.loads += [(order, [number(x) for x in force], number(phase)) for order, force, phase in further]
        self.stops = [([number(x) for x in s[0]], number(s[1]), s[2]) + tuple(number(x) for x in s[3:]) for s in stops]
        self.systems = {}

    def at(self, omega):
        self.omega = omega
        self.systems = {}
        return self

    def piece(self, contact):
        """Matrix, constant part and forced response of the motion, in contact with a spring or free (None)."""
        if contact not in self.systems:
            n = self.n
            G, constant = matrix(2 * n, 2 * n), matrix(2 * n, 1)
            for j in range(n):
                G[j, n + j] = mpf(1)
                G[n + j, j] = -self.w[j] ** 2
                G[n + j, n + j] = -2 * self.zeta[j] * self.w[j]
            if contact is not None:
                b, a, side, k, c = self.stops[contact]
                for i in range(n):
                    constant[n + i] = side * b[i] * k * a
                    for j in range(n):
                        G[n + i, j] -= b[i] * b[j] * k
                        G[n + i, n + j] -= b[i] * b[j] * c
            forced = [lu_solve(1j * order * self.omega * eye(2 * n) - G, matrix([mpf(0)] * n + force))
                      for order, force, _ in self.loads]
            rates, shapes = mp.eig(G)
            self.systems[contact] = (G, lu_solve(G, -constant), forced, (rates, shapes, shapes ** -1))
        return self.systems[contact]

    def particular(self, contact, t):
        G, rest, forced = self.piece(contact)[:3]
        turns = [mp.expj(order * self.omega * t + phase) for order, _, phase in self.loads]
        return matrix([rest[i] + sum((response[i] * turn).real for response, turn in zip(forced, turns))
                       for i in range(2 * self.n)])

    def flow(self, contact, z, t, end):
        y, h = z - self.particular(contact, t), end - t
        if contact is not None:
            rates, shapes, inverse = self.piece(contact)[3]
            parts = inverse * y
            for i in range(2 * self.n):
                parts[i] *= mp.exp(rates[i] * h)
            moved, rest = shapes * parts, self.particular(contact, end)
            return matrix([rest[i] + moved[i].real for i in range(2 * self.n)])
        free = self.particular(None, end)
        for j in range(self.n):
            d = self.zeta[j] * self.w[j]
            root, decay = mp.sqrt(self.w[j] ** 2 - d ** 2), mp.exp(-d * h)
            c, s = decay * mp.cos(root * h), decay * mp.sin(root * h) / root
            free[j] += (c + d * s) * y[j] + s * y[self.n + j]
            free[self.n + j] += (c - d * s) * y[self.n + j] - self.w[j] ** 2 * s * y[j]
        return free

    def overlap(self, stop, z):
        b, a, side = self.stops[stop][:3]
        return (side * sum(b[j] * z[j] for j in range(self.n)) - a,
                side * sum(b[j] * z[self.n + j] for j in range(self.n)))

    def rate(self, contact, z, t):
        G, rest, forced = self.piece(contact)[:3]
        value = G * (z - rest)
        for j in range(self.n):
            value[self.n + j] += sum(force[j] * mp.cos(order * self.omega * t + phase)
                                     for order, force, phase in self.loads)
        return value

    def event(self, contact, z, t, guess, kind, stop):
        """Time at which the event happens, and the state there, by Newton's method from the guess."""
        u = guess
        for _ in range(60):
            y = self.flow(contact, z, t, u)
            x, v = self.overlap(stop, y)
            d, acceleration = self.overlap_rates(contact, stop, y, u)
            if kind == 'leave':
                k, c = self.stops[stop][3:]
                value, slope = k * x + c * v, k * v + c * acceleration
            else:
                value, slope = x, v
            step = value / slope
            u -= step
            if abs(step) < mpf(10) ** (-mp.dps + 5):
                return u, self.flow(contact, z, t, u)
        raise ValueError('an event was not found')

    def overlap_rates(self, contact, stop, z, t):
        b, a, side = self.stops[stop][:3]
        y = self.rate(contact, z, t)
        return tuple(side * sum(b[j] * y[i * self.n + j] for j in range(self.n)) for i in (0, 1))

    def run(self, z, start, end, events, watch=None):
        """From force phase 0 at the time start; events are (kind, stop, rough time)."""
        t, contact, told = start, None, []
        for kind, stop, guess in events:
            u, y = self.event(contact, z, t, mpf(guess), kind, stop)
            if watch:
                watch(contact, z, t, u)
            told.append((kind, stop, u, self.overlap(stop, y)[1], y))
            if kind == 'impact':
                b, a, side, r = self.stops[stop]
                speed = sum(b[j] * y[self.n + j] for j in range(self.n))
                bb = sum(x * x for x in b)
                for j in range(self.n):
                    y[self.n + j] -= (1 + r) * b[j] * speed / bb
            contact = stop if kind == 'enter' else None
            z, t = y, u
        if watch:
            watch(contact, z, t, end)
        return self.flow(contact, z, t, end), told

    def derivative(self, z, start, end, events):
        h, n2 = mpf(10) ** (-mp.dps // 2), 2 * self.n
        base = self.run(z, start, end, events)[0]
        M = matrix(n2, n2)
        for j in range(n2):
            y = z.copy()
            y[j] += h
            column = (self.run(y, start, end, events)[0] - base) / h
            for i in range(n2):
                M[i, j] = column[i]
        return base, M

    def orbit(self, z, periods, events):
        """State at force phase 0 of the motion that repeats after that many periods; its events; its multipliers."""
        start = -self.psi / self.omega
        end = start + 2 * pi * periods / self.omega
        z = matrix([mpf(x) for x in z])
        events = [(kind, stop, start + mpf(phase) / self.omega) for kind, stop, phase in events]
        for _ in range(20):
            base, M = self.derivative(z, start, end, events)
            z -= lu_solve(M - eye(2 * self.n), base - z)
            told = self.run(z, start, end, events)[1]
            events = [(kind, stop, u) for kind, stop, u, v, y in told]
            if mp.norm(base - z) < mpf(10) ** -24:
                break
        else:
            raise ValueError('no orbit was found')
        assert mp.norm(self.run(z, start, end, events)[0] - z) < mpf(10) ** -28
        self.check(z, start, end, events)
        turns = sorted(mp.eig(M, left=False, right=False), key=lambda x: (-abs(x), x.imag))
        phases = [((self.omega * (u - start)) % (2 * pi), int((u - start) * self.omega / (2 * pi)), kind, stop, v, u, y)
                  for kind, stop, u, v, y in self.run(z, start, end, events)[1]]
        return z, phases, turns

    def check(self, z, start, end, events):
        """No stop is overrun between events, and springs push while they are touched, at 30 places of each piece."""
        def watch(contact, y, t, u):
            for i in range(1, 30):
                s = t + (u - t) * i / 30
                x = self.flow(contact, y, t, s)
                for stop in range(len(self.stops)):
                    over, v = self.overlap(stop, x)
                    if stop == contact:
                        k, c = self.stops[stop][3:]
                        assert k * over + c * v > 0, 'a spring pulls'
                    elif len(self.stops[stop]) == 4:
                        assert over < 0, 'a stop is overrun'
                    else:
                        k, c = self.stops[stop][3:]
                        assert over < 0 or k * over + c * v < 0, 'a spring is overrun'
        self.run(z, start, end, events, watch)
