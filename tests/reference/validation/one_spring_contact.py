"""Periodic motions of a modal structure that meets one undamped linear spring once a forcing period.

    q_j'' + 2 delta_j q_j' + w_j^2 q_j = f_j cos(W t + theta) - b_j p,   p = k max(0, u - a),   u = sum b_j q_j

Free and in contact the structure is linear. In contact its eigenvalues s solve 1 + k sum b_j^2/D_j(s) = 0 with
D_j(s) = s^2 + 2 delta_j s + w_j^2, its modes are b_j/D_j(s), and both motions are closed forms. t = 0 is the beginning of
the contact, tau its duration, T = 2 pi/W. The state z at t = 0 and the forcing c cos(W t) - s sin(W t) obey

    z(T) = z,   u(0) = a,   u(tau) = a,

which is linear in z, c and s where tau and W are given: one system of 2N + 2 equations. What is left is
G(tau, W) = c^2 + s^2 - 1 = 0, a curve, with folds over the frequency where dG/dtau = 0. This stays regular at folds.
The spring's force is continuous, so the product of both flows is the Jacobian of the map over one period; its
eigenvalues are the multipliers. Grazings lie on the linear resonance curve: |sum b_j f_j/D_j(i W)| = a.
"""

from mpmath import mp, mpc, mpf


def solve(rows, right):
    """Gaussian elimination with row pivoting; returns the solution and the determinant."""
    n = len(rows)
    A = [list(row) + [value] for row, value in zip(rows, right)]
    determinant = mpf(1)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(A[r][i]))
        if pivot != i:
            A[i], A[pivot] = A[pivot], A[i]
            determinant = -determinant
        determinant *= A[i][i]
        top = A[i]
        for r in range(i + 1, n):
            row = A[r]
            if row[i]:
                factor = row[i] / top[i]
                for c in range(i + 1, n + 1):
                    row[c] -= factor * top[c]
    x = [mpf(0)] * n
    for i in reversed(range(n)):
        x[i] = (A[i][n] - sum(A[i][c] * x[c] for c in range(i + 1, n))) / A[i][i]
    return x, determinant


class Structure:
    def __init__(self, w, delta, f, b, k, gap):
        self.N = len(w)
        self.w, self.delta, self.f, self.b = ([mpf(x) for x in v] for v in (w, delta, f, b))
        self.k, self.gap = mpf(k), mpf(gap)
        self.free = [mp.sqrt(x ** 2 - d ** 2) for x, d in zip(self.w, self.delta)]
        self.contact_modes()

    def D(self, j, s):
        return s * s + 2 * self.delta[j] * s + self.w[j] ** 2

    def contact_modes(self):
        """Undamped frequencies between those of the free structure, then Newton's method for the damped ones."""
        k, b, w = self.k, self.b, self.w
        stiff = k * sum(x * x for x in b)
        self.modes = []
        for n in range(self.N):
            low = w[n] ** 2
            high = w[n + 1] ** 2 if n + 1 < self.N else low + stiff
            for _ in range(60):
                middle = (low + high) / 2
                if 1 + k * sum(x * x / (y * y - middle) for x, y in zip(b, w)) < 0:
                    low = middle
                else:
                    high = middle
            s = mpc(-self.delta[n], mp.sqrt((low + high) / 2))
            for _ in range(60):
                value = 1 + k * sum(b[j] ** 2 / self.D(j, s) for j in range(self.N))
                slope = -k * sum(b[j] ** 2 * 2 * (s + self.delta[j]) / self.D(j, s) ** 2 for j in range(self.N))
                step = value / slope
                s -= step
                if abs(step) < abs(s) * mpf(10) ** (5 - mp.dps):
                    break
            shape = [b[j] / self.D(j, s) for j in range(self.N)]
            norm = sum(2 * (s + self.delta[j]) * shape[j] ** 2 for j in range(self.N))
            self.modes.append((s, shape, norm))
        columns = [[v[i] * (s + 2 * self.delta[i]) / norm for s, v, norm in self.modes] for i in range(self.N)]
        columns += [[v[i] / norm for s, v, norm in self.modes] for i in range(self.N)]
        self.contact_columns = [[x.real for x in c] + [x.imag for x in c] for c in columns]
        values = [m[0] for m in self.modes]
        assert all(abs(x - y) > abs(x) * mpf('1e-6') for i, x in enumerate(values) for y in values[:i])

    def free_flow(self, t):
        """Per mode the four entries of the flow of q, q'."""
        flow = []
        for w, d, r in zip(self.w, self.delta, self.free):
            e, c, s = mp.exp(-d * t), mp.cos(r * t), mp.sin(r * t)
            flow.append((e * (c + d * s / r), e * s / r, -e * w * w * s / r, e * (c - d * s / r)))
        return flow

    def contact_flow(self, t):
        """The 2N x 2N flow of q, q' in contact, without forcing: twice the real part of a sum over modes."""
        N = self.N
        turns = [2 * mp.exp(mode[0] * t) for mode in self.modes]
        M = []
        for order in (0, 1):
            for j in range(N):
                left = [turn * mode[0] ** order * mode[1][j] for turn, mode in zip(turns, self.modes)]
                row = [x.real for x in left] + [-x.imag for x in left]
                M.append([mp.fdot(row, column) for column in self.contact_columns])
        return M

    def forced(self, W):
        """Complex amplitudes of the forced motion, free and in contact; the constant part in contact."""
        N, k, b = self.N, self.k, self.b
        D = [self.D(j, mpc(0, W)) for j in range(N)]
        free = [self.f[j] / D[j] for j in range(N)]
        u = sum(b[j] * free[j] for j in range(N)) / (1 + k * sum(b[j] ** 2 / D[j] for j in range(N)))
        contact = [free[j] - k * u * b[j] / D[j] for j in range(N)]
        give = k * self.gap / (1 + k * sum(b[j] ** 2 / self.w[j] ** 2 for j in range(N)))
        return free, contact, [give * b[j] / self.w[j] ** 2 for j in range(N)]

    @staticmethod
    def at(P, W, t):
        """Forced state q, q' for c = 1 and for s = 1 in c cos(W t) - s sin(W t)."""
        turn = mp.expj(W * t)
        q = [p * turn for p in P]
        v = [mpc(0, W) * x for x in q]
        return [x.real for x in q] + [x.real for x in v], [-x.imag for x in q] + [-x.imag for x in v]

    def product(self, flow, M):
        """Free flow times a list of rows."""
        N = self.N
        top = [[flow[j][0] * x + flow[j][1] * y for x, y in zip(M[j], M[N + j])] for j in range(N)]
        return top + [[flow[j][2] * x + flow[j][3] * y for x, y in zip(M[j], M[N + j])] for j in range(N)]

    def orbit(self, tau, W):
        """State at the beginning of contact, c, s, and the Jacobian over one period."""
        N, n = self.N, 2 * self.N
        T = 2 * mp.pi / W
        pf, pc, rest = self.forced(W)
        rest = rest + [mpf(0)] * N
        f0, f1, c0, c1 = self.at(pf, W, mpf(0)), self.at(pf, W, tau), self.at(pc, W, mpf(0)), self.at(pc, W, tau)
        E = self.contact_flow(tau)

        def through(columns):
            return [sum(E[i][j] * columns[j] for j in range(n)) for i in range(n)]

        # z(tau) = E z + c A0 + s A1 + A2
        A = [[c1[m][i] - x for i, x in enumerate(through(c0[m]))] for m in (0, 1)]
        A.append([rest[i] - x for i, x in enumerate(through(rest))])
        flow = self.free_flow(T - tau)
        J = self.product(flow, E)
        # z(T) = J z + c B0 + s B1 + B2
        B = []
        for m in (0, 1, 2):
            inner = [[A[m][i] - (f1[m][i] if m < 2 else 0)] for i in range(n)]
            outer = [row[0] for row in self.product(flow, inner)]
            B.append([outer[i] + (f0[m][i] if m < 2 else 0) for i in range(n)])
        rows = [[(1 if i == j else 0) - J[i][j] for j in range(n)] + [-B[0][i], -B[1][i]] for i in range(n)]
        right = [B[2][i] for i in range(n)]
        b = self.b
        rows.append([b[j] if j < N else mpf(0) for j in range(n)] + [mpf(0), mpf(0)])
        right.append(self.gap)
        rows.append([sum(b[i] * E[i][j] for i in range(N)) for j in range(n)] +
                    [sum(b[i] * A[0][i] for i in range(N)), sum(b[i] * A[1][i] for i in range(N))])
        right.append(self.gap - sum(b[i] * A[2][i] for i in range(N)))
        x, _ = solve(rows, right)
        return x[:n], x[n], x[n + 1], J

    def excess(self, tau, W):
        _, c, s, _ = self.orbit(tau, W)
        return c * c + s * s - 1

    def at_frequency(self, W, tau):
        """The orbit next to the duration tau, by the secant method."""
        W, old = mpf(W), mpf(tau)
        new, G = old * (1 + mpf('1e-5')), self.excess(old, W)
        for _ in range(30):
            F = self.excess(new, W)
            step = F * (new - old) / (F - G)
            old, new, G = new, new - step, F
            if abs(step) < new * mpf('1e-13'):
                return Orbit(self, new, W)
        raise ValueError('no orbit')

    def fold(self, tau, W):
        """G = dG/dtau = 0 by Newton's method, derivatives by differences."""
        tau, W, e = mpf(tau), mpf(W), mpf('1e-8')

        def equations(tau, W):
            low, middle, high = (self.excess(tau * (1 + h), W) for h in (-e, 0, e))
            return middle, (high - low) / (2 * e), (high - 2 * middle + low) / e ** 2

        step = [mpf(1), mpf(1)]
        for _ in range(40):
            G, slope, curvature = equations(tau, W)
            if abs(step[1]) > mpf('1e-5'):
                moved = equations(tau, W * (1 + e))
                by_W = (moved[0] - G) / e, (moved[1] - slope) / e
            step, _ = solve([[slope, by_W[0]], [curvature, by_W[1]]], [G, slope])
            tau, W = tau * (1 - step[0]), W * (1 - step[1])
            if abs(step[0]) < mpf('1e-9') and abs(step[1]) < mpf('1e-18'):
                return Orbit(self, tau, W)
        raise ValueError('no fold')

    def multiplier_point(self, tau, W, angle=None):
        """Where -1 is a multiplier, or with an angle e^(i angle), the angle being solved for too."""
        x = [mpf(tau), mpf(W)] + ([] if angle is None else [mpf(angle)])

        def equations(x):
            _, c, s, J = self.orbit(x[0], x[1])
            turn = mpf(-1) if angle is None else mp.expj(x[2])
            n = 2 * self.N
            _, value = solve([[J[i][j] / turn - (1 if i == j else 0) for j in range(n)] for i in range(n)],
                             [mpf(0)] * n)
            return [c * c + s * s - 1] + ([value] if angle is None else [value.real, value.imag])

        e, rows = mpf('1e-10'), None
        for iteration in range(40):
            value = equations(x)
            if rows is None or iteration == 3:
                moved = [equations([y * (1 + e) if i == k else y for i, y in enumerate(x)]) for k in range(len(x))]
                rows = [[(moved[k][r] - value[r]) / e for k in range(len(x))] for r in range(len(x))]
            step, _ = solve(rows, value)
            x = [y * (1 - h) for y, h in zip(x, step)]
            if max(abs(h) for h in step) < mpf('1e-16'):
                return Orbit(self, x[0], x[1])
        raise ValueError('no such point')

    def resonance(self, W):
        return abs(sum(b * p for b, p in zip(self.b, self.forced(W)[0])))

    def grazing(self, low, high):
        return mp.findroot(lambda W: self.resonance(W) - self.gap, (low, high), solver='anderson',
                           tol=mpf(10) ** (4 - 2 * mp.dps), verify=False)


class Orbit:
    """An orbit on the curve G = 0; t counts from the beginning of the contact."""

    def __init__(self, structure, tau, W):
        self.structure, self.tau, self.W, self.T = structure, tau, W, 2 * mp.pi / W
        z, c, s, _ = structure.orbit(tau, W)
        assert abs(c * c + s * s - 1) < mpf('1e-18')
        N, b = structure.N, structure.b
        self.phase = mp.atan2(s, c) % (2 * mp.pi)
        self.speed = sum(b[j] * z[N + j] for j in range(N))
        assert self.speed > 0
        turn = mpc(c, s)
        free, contact, rest = structure.forced(W)
        self.amplitudes = [sum(x * p for x, p in zip(b, P)) * turn for P in (free, contact)]
        self.rest = sum(x * y for x, y in zip(b, rest))
        own = [x - y for x, y in zip(z, self.motion(contact, turn))]
        own = [x - y for x, y in zip(own, rest + [mpf(0)] * N)]
        self.contact_parts = []
        for root, v, norm in structure.modes:
            part = sum(v[i] * ((root + 2 * structure.delta[i]) * own[i] + own[N + i]) for i in range(N)) / norm
            self.contact_parts.append((root, 2 * part * sum(x * y for x, y in zip(b, v))))
        own = [x - y for x, y in zip(z, self.motion(free, turn))]
        self.free_parts = []
        for j in range(N):
            root = mpc(-structure.delta[j], structure.free[j])
            part = mpc(own[j], -(own[N + j] + structure.delta[j] * own[j]) / structure.free[j])
            self.free_parts.append((root, b[j] * part))
        self.check()

    def motion(self, P, turn):
        q = [p * turn for p in P]
        return [x.real for x in q] + [(mpc(0, self.W) * x).real for x in q]

    def series(self, parts, t, amplitude, forced_at, rest):
        """u, u', u'' from a sum of exponentials."""
        iW = mpc(0, self.W)
        terms = [(iW, amplitude * mp.exp(iW * forced_at))] + [(root, part * mp.exp(root * t)) for root, part in parts]
        u = sum(x for _, x in terms)
        v = sum(root * x for root, x in terms)
        a = sum(root * root * x for root, x in terms)
        return u.real + rest, v.real, a.real

    def contact(self, t):
        """u, u', u'' at 0 <= t <= tau."""
        return self.series(self.contact_parts, t, self.amplitudes[1], t, self.rest)

    def flight(self, t):
        """u, u', u'' at tau <= t <= T, backwards from the state at T, which is the one at 0."""
        return self.series(self.free_parts, t - self.T, self.amplitudes[0], t, 0)

    def extreme(self, motion, start, end, sign, samples):
        """The largest sign*u between two times: the best sample, then Newton's method on u'."""
        times = [start + (end - start) * i / samples for i in range(samples + 1)]
        best = max(range(samples + 1), key=lambda i: sign * motion(times[i])[0])
        assert 0 < best < samples
        t = times[best]
        for _ in range(30):
            _, v, a = motion(t)
            t -= v / a
            if abs(v / a) < (end - start) * mpf('1e-18'):
                return sign * motion(t)[0]
        raise ValueError('no extreme')

    def check(self):
        """One contact only: pressed between 0 and tau, clear of the spring after that, and the ends meet."""
        gap, tau, T = self.structure.gap, self.tau, self.T
        for i in range(1, 60):
            assert self.contact(tau * i / 60)[0] > gap
            assert self.flight(tau + (T - tau) * i / 60)[0] < gap
        for t in (mpf(0), tau):
            for x, y in zip(self.contact(t), self.flight(t or T)):
                assert abs(x - y) < mpf('1e-12') * abs(y)

    def peak_force(self):
        return self.structure.k * (self.extreme(self.contact, mpf(0), self.tau, 1, 20) - self.structure.gap)

    def reach(self):
        """How far the point of contact goes away from the spring: the largest -u."""
        return self.extreme(self.flight, self.tau, self.T, -1, 200)
