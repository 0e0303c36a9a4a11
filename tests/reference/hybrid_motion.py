"""Motion with impacts, chatter, sticking and release, in extended precision.

Every smooth piece of motion, free or with any set of stops stuck, is a Taylor polynomial in time that is exact to the
working precision. With S the stuck stops,

    q'' = a - sum over S of d_k lambda_k,    a_j = g_j cos(Omega t + psi) + c_j - 2 delta_j q_j' - w_j^2 q_j,

(or a sum of such forces, system.loads) where the lambda_k keep  row_k . q'' = 0  for k in S. A stuck stop is released where its lambda falls to zero.
The first zero of a gap or of a lambda is found by polynomial_zeros.py. A zero known at the start (simple after an
impact, double or triple after a release) is divided out of the coefficients.
"""
from dataclasses import dataclass, field
from itertools import combinations

from mpmath import mp, mpf

from modal_system import dot
from polynomial_zeros import first_zero, value, value_and_rate


# ---------------------------------------------------------------- one smooth piece

def solve(matrix, rhs):
    """Small dense system; matrix as rows."""
    if len(rhs) == 1:
        return [rhs[0] / matrix[0][0]]
    return list(mp.lu_solve(mp.matrix(matrix), mp.matrix(rhs)))


def delassus(system, rows):
    """row_k . d_l for k, l in rows."""
    return [[dot(system.stops[k].row, system.stops[m].jump) for m in rows] for k in rows]


class Arc:
    """Taylor polynomials of q and of lambda over [t0, t0 + h], from the state (q, v) with the stops `stuck` closed."""

    def __init__(self, system, stuck, t0, q, v, h):
        self.system, self.stuck, self.t0, self.h = system, stuck, t0, h
        modes = range(system.modes)
        w2 = [w ** 2 for w in system.frequency]
        rows = [system.stops[k].row for k in stuck]
        jumps = [system.stops[k].jump for k in stuck]
        contact = delassus(system, stuck)
        turns, scales = [], [mpf(1)] * len(system.loads)
        for omega, psi, _ in system.loads:
            c, s = mp.cos(omega * t0 + psi), mp.sin(omega * t0 + psi)
            turns.append([c, -s, -c, s])
        self.q = [[q[j], v[j]] for j in modes]
        self.power = [[] for _ in modes]                      # what moves mode j besides its spring: gives the work
        self.push = [[] for _ in stuck]                       # lambda
        tolerance = mpf(10) ** -mp.dps
        largest, quiet, n, h_power = mpf(0), 0, 0, mpf(1)
        while quiet < 4:
            # n-th coefficient of each cos(Omega t + psi)
            forces = [(force, turn[n % 4] * scale) for (_, _, force), turn, scale in zip(system.loads, turns, scales)]
            a = [sum(force[j] * turn for force, turn in forces) - system.two_delta[j] * (n + 1) * self.q[j][n + 1] - w2[j] * self.q[j][n]
                 for j in modes]
            if n == 0:
                a = [x + y for x, y in zip(a, system.static)]
            size = max(abs(x) for x in a) * h_power
            if stuck:
                push = solve(contact, [dot(row, a) for row in rows])
                for k, p in enumerate(push):
                    self.push[k].append(p)
                    a = [x - p * d for x, d in zip(a, jumps[k])]
            for j in modes:
                self.power[j].append(a[j] + w2[j] * self.q[j][n])
                self.q[j].append(a[j] / ((n + 1) * (n + 2)))
            largest = max(largest, size)
            quiet = quiet + 1 if size <= tolerance * largest else 0
            n += 1
            scales = [scale * omega / n for (omega, _, _), scale in zip(system.loads, scales)]
            h_power *= h
            if n > 400:
                raise ArithmeticError("the series does not converge")

    def gap(self, k):
        stop = self.system.stops[k]
        poly = [-dot(stop.row, [self.q[j][n] for j in range(self.system.modes)]) for n in range(len(self.q[0]))]
        poly[0] += stop.gap
        return poly

    def state(self, s):
        pairs = [value_and_rate(poly, s) for poly in self.q]
        return [x for x, _ in pairs], [y for _, y in pairs]

    def residual(self, s):
        """Relative residual of the equations of motion at t0 + s, from the polynomials there."""
        system, (q, v) = self.system, self.state(s)
        push = [value(p, s) for p in self.push]
        turns = [(force, mp.cos(omega * (self.t0 + s) + psi)) for omega, psi, force in system.loads]
        worst = largest = mpf(0)
        for j, poly in enumerate(self.q):
            second = value([n * (n - 1) * poly[n] for n in range(2, len(poly))], s)
            parts = [second, system.two_delta[j] * v[j], system.frequency[j] ** 2 * q[j], -sum(force[j] * turn for force, turn in turns),
                     -system.static[j]] + [p * self.system.stops[k].jump[j] for p, k in zip(push, self.stuck)]
            worst = max(worst, abs(sum(parts)))
            largest = max([largest] + [abs(x) for x in parts])
        return worst / largest

    def work(self, s):
        """Work done on the structure by all but its springs (forcing, gravity, damping, push of the stops) up to s."""
        total = mpf(0)
        for poly, power in zip(self.q, self.power):
            rate = [n * poly[n] for n in range(1, len(poly))]
            backward = power[::-1]
            size = len(power)
            total += value([mpf(0)] + [dot(rate[:n + 1], backward[size - 1 - n:]) / (n + 1) for n in range(size)], s)
        return total


# ---------------------------------------------------------------- impacts

def impulses(system, touching, speeds):
    """p >= 0 per touching stop so that v+ = v - D p satisfies  v+ + r v <= 0,  p.(v+ + r v) = 0."""
    matrix = delassus(system, touching)
    wanted = [(1 + system.stops[k].restitution) * speed for k, speed in zip(touching, speeds)]
    indices = range(len(touching))
    for size in range(1, len(touching) + 1):
        for active in combinations(indices, size):
            some = solve([[matrix[i][m] for m in active] for i in active], [wanted[i] for i in active])
            p = [mpf(0)] * len(touching)
            for i, x in zip(active, some):
                p[i] = x
            left = [wanted[i] - dot(matrix[i], p) for i in indices]
            if min(p) >= 0 and all(left[i] <= 0 for i in indices if i not in active):
                return p
    raise ArithmeticError("no impulse")


def kick(system, touching, p, v):
    for k, x in zip(touching, p):
        v = [vj - x * dj for vj, dj in zip(v, system.stops[k].jump)]
    return v


# ---------------------------------------------------------------- the hybrid motion

@dataclass
class Event:
    kind: str                # impact | stick | release
    time: mpf
    stop: int                # from 0
    speed: mpf = None


@dataclass
class Phase:
    """A stretch between events that is checked against the matrix exponential."""
    stuck: tuple
    t0: mpf
    q0: list
    v0: list
    t1: mpf
    q1: list
    v1: list


@dataclass
class Motion:
    system: object
    reach: mpf = mpf(2)                                       # arc length times the fastest rate
    slow: mpf = mpf(10) ** -22                                # relative speed at which a chatter is closed
    book: bool = True                                         # keep the books for the checks
    events: list = field(default_factory=list)
    phases: list = field(default_factory=list)
    residual: mpf = mpf(0)
    violation: mpf = mpf(0)                                   # of the constraints and of contact
    balance: mpf = mpf(0)                                     # of energy
    law: mpf = mpf(0)                                         # of impact: speeds after it, and the energy it takes
    closing: mpf = mpf(0)                                     # change of the accumulation time over its last impacts
    fastest: mpf = mpf(0)                                     # largest approach speed so far

    def energy(self, q, v):
        return sum(y ** 2 + (w * x) ** 2 for x, y, w in zip(q, v, self.system.frequency)) / 2

    def keep(self, name, x):
        setattr(self, name, max(getattr(self, name), abs(x)))

    def run(self, end):
        system = self.system
        rates = system.frequency + system.two_delta + [omega for omega, _, _ in system.loads]
        longest = self.reach / max(max(rates), mpf(1))
        t, q, v, stuck, known = self.start()
        phase = (stuck, t, q, v)
        estimates = {}                                        # accumulation times, per stop
        length = longest
        spring0 = self.energy(q, v)
        scale_q = scale_v = scale_e = mpf(0)
        gained = mpf(0)                                       # energy gained since the start, from work and impacts
        while True:
            arc = Arc(system, stuck, t, q, v, min(length, longest))
            found = []
            for k, push in zip(stuck, arc.push):
                s = first_zero(push, arc.h)
                if s is not None:
                    found.append((s, 'release', k))
            for k in range(len(system.stops)):
                if k not in stuck:
                    s = first_zero(self.without_known_zero(arc, k, known.get(k, 0)), arc.h)
                    if s is not None:
                        found.append((s, 'impact', k))
            found.sort()
            if len(found) > 1 and found[1][0] - found[0][0] < mpf('1e-30'):
                raise ArithmeticError("two events at once")
            s, kind, k = found[0] if found else (arc.h, None, None)
            if t + s > end:
                break
            if self.book:
                self.keep('residual', arc.residual(s))
                gained += arc.work(s)
            t, (q, v) = t + s, arc.state(s)
            scale_q, scale_v = max([scale_q] + [abs(x) for x in q]), max([scale_v] + [abs(x) for x in v])
            for m in stuck:
                stop = system.stops[m]
                self.keep('violation', (dot(stop.row, q) - stop.gap) / (abs(stop.gap) + scale_q))
                self.keep('violation', dot(stop.row, v) / (scale_v or 1))
            length, known = longest, {}
            if kind is None:
                continue
            self.phases.append(Phase(*phase, t, q, v))
            if kind == 'release':
                self.events.append(Event('release', t, k))
                stuck = tuple(m for m in stuck if m != k)
                known = {k: 3}
                if found[0][0] > 0 and not self.pushed(stuck, t, q, v):
                    raise ArithmeticError("a release frees another stop")
            else:
                before = self.energy(q, v)
                speed = dot(system.stops[k].row, v)
                if not speed > 0:
                    raise ArithmeticError("an impact needs an approach")
                self.fastest = max(self.fastest, speed)
                self.events.append(Event('impact', t, k, speed))
                stuck, v, known, length = self.impact(k, stuck, t, q, v, speed, estimates)
                gained += self.energy(q, v) - before
            phase = (stuck, t, q, v)
            now = self.energy(q, v)
            scale_e = max(scale_e, now, spring0)
            if self.book:
                self.keep('balance', (now - spring0 - gained) / scale_e)
        return self.events

    def start(self):
        """At rest on a stop: stuck if pushed, else leaving at once. That is no event."""
        system, t = self.system, mpf(0)
        q, v = list(system.q0), list(system.v0)
        on = [k for k, stop in enumerate(system.stops) if dot(stop.row, q) == stop.gap]
        for k in on:
            if dot(system.stops[k].row, v) != 0:
                raise ArithmeticError("a start on the stop must be at rest there")
        arc = Arc(system, (), t, q, v, mpf(10) ** -30)
        stuck = tuple(k for k in on if arc.gap(k)[2] < 0)
        if len(stuck) > 1:
            raise ArithmeticError("one stop at a time at the start")
        return t, q, v, stuck, {k: 2 for k in on if k not in stuck}

    def without_known_zero(self, arc, k, order):
        poly = arc.gap(k)
        if order == 0:
            return poly
        size = max(abs(x) for x in [self.system.stops[k].gap] + [y for p in arc.q for y in p[:1]])
        rate = max(self.system.frequency + self.system.two_delta + [load[0] for load in self.system.loads] + [mpf(1)])
        for n in range(order):
            if abs(poly[n]) > size * rate ** n * mpf(10) ** (15 - mp.dps):
                raise ArithmeticError(f"the gap's coefficient {n} should be zero, is {mp.nstr(poly[n], 5)}")
        return poly[order:]

    def pushed(self, stuck, t, q, v):
        arc = Arc(self.system, stuck, t, q, v, mpf(10) ** -30)
        return all(push[0] > 0 for push in arc.push)

    def check_law(self, k, touching, before, after, speed):
        stop = self.system.stops[k]
        self.keep('law', (dot(stop.row, after) / speed + stop.restitution))
        if len(touching) == 1 and len(self.system.stops) == 1 and self.along_row(stop):
            lost = (dot(before, before) - dot(after, after)) / 2
            due = (1 - stop.restitution ** 2) * speed ** 2 / (2 * dot(stop.row, stop.row))
            self.keep('law', (lost - due) / dot(before, before))

    @staticmethod
    def along_row(stop):
        """The momentum law, not the collocation law."""
        return abs(dot(stop.jump, stop.jump) * dot(stop.row, stop.row) - 1) < mpf('1e-30')

    def impact(self, k, stuck, t, q, v, speed, estimates):
        """What is stuck afterwards, the velocities, the zeros known at the start of the next arc, its length."""
        system = self.system
        # The approach of the stuck stops is zero exactly.
        touching = tuple(sorted(stuck + (k,)))
        p = impulses(system, touching, [speed if m == k else mpf(0) for m in touching])
        after = kick(system, touching, p, v)
        self.check_law(k, touching, v, after, speed)
        known, still = {k: 1}, []
        for m, x in zip(touching, p):
            if m == k:
                continue
            leaving = -dot(system.stops[m].row, after)
            if x == 0 and leaving > speed * mpf('1e-30'):     # thrown off by the impact elsewhere
                self.events.append(Event('release', t, m))
                known[m] = 1
            else:
                still.append(m)
        still = tuple(still)
        arc = Arc(system, still, t, q, after, mpf(10) ** -30)
        for m, push in zip(still, arc.push):                  # the new velocities may pull at a stuck stop
            if push[0] < 0:
                raise ArithmeticError("an impact elsewhere frees a stuck stop without throwing it off")
        r = system.stops[k].restitution
        push = -2 * arc.gap(k)[2]                             # the acceleration into the stop
        if push <= 0:
            estimates.pop(k, None)
            if r == 0:                                        # at rest on the stop and pulled
                known[k] = 2
            return still, after, known, mpf('inf')
        tail = 2 * r * speed / (push * (1 - r))
        change = -6 * arc.gap(k)[3]
        estimates.setdefault(k, []).append(t + tail)
        if r > 0:
            if speed > self.slow * self.fastest or tail * abs(change) > push * mpf('1e-8'):
                return still, after, known, 4 * r * speed / push
            history = estimates.pop(k)
            self.keep('closing', history[-1] - history[-4])
        # To first order the tail of the chatter acts as one impact without rebound, now.
        stuck = tuple(sorted(still + (k,)))
        rest = solve(delassus(system, stuck), [dot(system.stops[m].row, v) for m in stuck])
        if min(rest) < 0 or len(still) != len(touching) - 1:
            raise ArithmeticError("a chatter that throws off another stop")
        self.events.append(Event('stick', t + tail, k))
        v = kick(system, stuck, rest, v)
        if not self.pushed(stuck, t, q, v):
            raise ArithmeticError("stuck, but not pushed")
        return stuck, v, {}, mpf('inf')


# ---------------------------------------------------------------- an independent flow

def exponential_flow(system, stuck, t0, q, v, duration):
    """State after `duration` by one matrix exponential in coordinates of the constraint's own space.

    q = q(t0) + B z  with B a basis of { z: row_k . z = 0, k in stuck }; the rows of (B, d)^-1 that belong to B take out
    the push. The forcing is carried along as an oscillator and the loads as a constant.
    """
    n, m = system.modes, len(stuck)
    rows = [system.stops[k].row for k in stuck]
    pivots = []                                               # eliminate the largest entries of the rows
    work = [list(row) for row in rows]
    for i in range(m):
        j = max((j for j in range(n) if j not in pivots), key=lambda j: abs(work[i][j]))
        pivots.append(j)
        for other in range(m):
            if other != i:
                factor = work[other][j] / work[i][j]
                work[other] = [x - factor * y for x, y in zip(work[other], work[i])]
    free = [j for j in range(n) if j not in pivots]
    basis = []
    for j in free:
        z = [mpf(0)] * n
        z[j] = mpf(1)
        for i, pivot in enumerate(pivots):
            z[pivot] = -work[i][j] / work[i][pivot]
        basis.append(z)
    size = n - m
    columns = mp.matrix(n, n)
    for j, column in enumerate(basis + [system.stops[k].jump for k in stuck]):
        for i in range(n):
            columns[i, j] = column[i]
    left = mp.inverse(columns)                                # its first n - m rows are L
    one = 2 * size + 2 * len(system.loads)
    a = mp.matrix(one + 1)
    for i in range(size):
        a[i, size + i] = 1
        for j in range(size):
            a[size + i, j] = -sum(left[i, k] * system.frequency[k] ** 2 * basis[j][k] for k in range(n))
            a[size + i, size + j] = -sum(left[i, k] * system.two_delta[k] * basis[j][k] for k in range(n))
        for h, (_, _, force) in enumerate(system.loads):
            a[size + i, 2 * size + 2 * h] = sum(left[i, k] * force[k] for k in range(n))
        a[size + i, one] = sum(left[i, k] * (system.static[k] - system.frequency[k] ** 2 * q[k]) for k in range(n))
    y = [mpf(0)] * size + [sum(left[i, k] * v[k] for k in range(n)) for i in range(size)]
    for h, (omega, psi, _) in enumerate(system.loads):
        cosine = 2 * size + 2 * h
        a[cosine, cosine + 1], a[cosine + 1, cosine] = -omega, omega
        y += [mp.cos(omega * t0 + psi), mp.sin(omega * t0 + psi)]
    y = mp.matrix(y + [mpf(1)])
    y = mp.expm(a * duration) * y
    return ([q[k] + sum(basis[i][k] * y[i] for i in range(size)) for k in range(n)],
            [sum(basis[i][k] * y[size + i] for i in range(size)) for k in range(n)])
