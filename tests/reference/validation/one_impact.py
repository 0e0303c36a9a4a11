"""Motions with one impact per p forcing periods, in closed form, at any number of digits.

Modes  q_j'' + 2 delta_j q_j' + w_j^2 q_j = f_j A cos(phase),  phase' = Omega,  and one rigid stop:  b.q <= a, speed v = b.q'
turned into -r v by an impulse along b. With E the free flow over p periods, J the impact, and Re(p_hat e^{i phi}) the
forced motion for A = 1, an impact that repeats every p periods at phase phi comes in with the state

    y = A (I - E J)^-1 (I - E) Re(p_hat e^{i phi}),          contact:  A |kappa| cos(phi + arg kappa) = a.

So the phase tells everything: A (or a) follows from it, two motions meet (fold) at phi = -arg kappa, and the
linearised map over one repetition is E S with the saltation matrix S = J + (f+ - J f-) (b, 0)/v.
"""
from mpmath import mp, mpf, mpc, matrix, lu_solve, findroot, det, eye, pi, sqrt

mp.dps = 40


def number(text):
    """The double nearest to a decimal number, which is what a program reads, taken as exact."""
    return mpf(float(text))


class OneImpact:
    def __init__(self, w, delta, f, b, omega, r, p=1):
        self.n, self.b, self.r, self.omega, self.p = len(w), b, mpf(r), mpf(omega), p
        self.w, self.delta, self.f = w, delta, f
        n = self.n
        self.period = 2 * pi * p / self.omega
        self.J = eye(2 * n)
        bb = sum(x * x for x in b)
        for i in range(n):
            for j in range(n):
                self.J[n + i, n + j] -= (1 + self.r) * b[i] * b[j] / bb
        response = [f[j] / (w[j] ** 2 - self.omega ** 2 + 2j * delta[j] * self.omega) for j in range(n)]
        self.forced = matrix(response + [1j * self.omega * z for z in response])
        self.close()
        self.kappa = sum(b[j] * self.before[j] for j in range(n))

    def close(self):
        """The free flow between impacts and the state before them, for the force e^{i phi}."""
        one = eye(2 * self.n)
        self.E = self.flow(self.period)
        self.before = lu_solve(one - self.E * self.J, (one - self.E) * self.forced)

    def flow(self, t):
        """Free motion over the time t (mode by mode; a mode may be undamped, free or overdamped)."""
        n, E = self.n, matrix(2 * self.n, 2 * self.n)
        for j in range(n):
            d, root = self.delta[j], sqrt(mpc(self.w[j] ** 2 - self.delta[j] ** 2))
            decay = mp.e ** (-d * t)
            c = mp.cos(root * t).real
            s = (mp.sin(root * t) / root).real if root != 0 else t
            E[j, j], E[j, n + j] = decay * (c + d * s), decay * s
            E[n + j, j], E[n + j, n + j] = -decay * self.w[j] ** 2 * s, decay * (c - d * s)
        return E

    def amplitude(self, phi, gap):
        return gap / (self.kappa * mp.expj(phi)).real

    def gap(self, phi, amplitude):
        return amplitude * (self.kappa * mp.expj(phi)).real

    def phases(self, amplitude, gap):
        """Both phases in [0, 2 pi) of motions at this amplitude and gap."""
        turn = mp.acos(gap / (amplitude * abs(self.kappa)))
        return [(s * turn - mp.arg(self.kappa)) % (2 * pi) for s in (1, -1)]

    def state(self, phi, amplitude):
        return matrix([amplitude * (z * mp.expj(phi)).real for z in self.before])

    def speed(self, phi, amplitude):
        y = self.state(phi, amplitude)
        return sum(self.b[j] * y[self.n + j] for j in range(self.n))

    def map(self, phi, amplitude):
        """Linearised map over one repetition, E S."""
        n, y = self.n, self.state(phi, amplitude)
        after = self.J * y

        def rate(z):
            return matrix([z[n + j] for j in range(n)] +
                          [amplitude * self.f[j] * mp.cos(phi) - 2 * self.delta[j] * z[n + j] - self.w[j] ** 2 * z[j]
                           for j in range(n)])
        jump = rate(after) - self.J * rate(y)
        v = self.speed(phi, amplitude)
        S = self.J.copy()
        for i in range(2 * n):
            for j in range(n):
                S[i, j] += jump[i] * self.b[j] / v
        return self.E * S

    def multipliers(self, phi, amplitude):
        """Largest modulus first."""
        M = self.map(phi, amplitude)
        if self.n == 1:
            half = (M[0, 0] + M[1, 1]) / 2
            root = sqrt(mpc(half ** 2 - det(M)))
            return sorted([half + root, half - root], key=lambda z: -abs(z))
        return sorted(mp.eig(M, left=False, right=False), key=lambda z: -abs(z))

    def displacement(self, phi, amplitude, t):
        """Position and speed at the stop, t after the impact."""
        n, y = self.n, self.state(phi, amplitude)
        shift = lambda angle: matrix([amplitude * (z * mp.expj(angle)).real for z in self.forced])
        z = self.flow(t) * (self.J * y - shift(phi)) + shift(phi + self.omega * t)
        return (sum(self.b[j] * z[j] for j in range(n)), sum(self.b[j] * z[n + j] for j in range(n)))

    def clearance(self, phi, amplitude, gap, points=400):
        """Smallest gap between impacts, on a grid (a check of admissibility, not a result)."""
        h = self.period / points
        return min(gap - self.displacement(phi, amplitude, h * (i + mpf(1) / 2))[0] for i in range(points))

    # special points over the amplitude at a given gap ------------------------------------------------------------

    def fold(self):
        """Phase of the fold, in [0, 2 pi)."""
        return (-mp.arg(self.kappa)) % (2 * pi)

    def doubling(self, start, gap):
        """Phase at which a multiplier is -1, from a start. The determinant has a pole where the speed vanishes."""
        def f(phi):
            A = self.amplitude(phi, gap)
            return self.speed(phi, A) * det(self.map(phi, A) + eye(2 * self.n))
        return findroot(f, start)

    def touch(self, start, gap):
        """(phase, time after the impact) at which the motion between impacts just touches the stop, from a start."""
        def f(phi, t):
            x, v = self.displacement(phi, self.amplitude(phi, gap), t)
            return [x - gap, v]
        root = findroot(f, start)
        return root[0], root[1]


def oscillator(zeta, omega, r, p=1):
    """x'' + 2 zeta x' + x = A cos(omega t)."""
    return OneImpact([mpf(1)], [mpf(zeta)], [mpf(1)], [mpf(1)], omega, r, p)


def show(name, value, digits=18):
    print(name, mp.nstr(value, digits, min_fixed=-3, max_fixed=8, strip_zeros=False))
