"""One impact in n forcing periods of the undamped oscillator x'' + x = cos(w t), x <= sigma, v -> -r v.

With T = 2 pi n/w, gamma = 1/(1 - w^2), c = (1 + r) sin T/(1 - cos T), d = (1 - r)/w, the impact speed V solves
    (2 sigma + c V)^2 + (d V)^2 = 4 gamma^2,                                                             (ellipse)
the phase p at impact has  cos p = (sigma + c V/2)/gamma,  sin p = -d V/(2 gamma),  and two motions meet (fold) at
    sigma_s = |gamma| sqrt(1 + (c/d)^2).
The linearised map over T has determinant r^2 and, as both flights between impacts are the same, the trace
    -2 r cos T + (1 + r) (cos p - sigma) sin T/V,
so that the period doubles where this is -(1 + r^2). These closed forms are compared with those of one_impact.py.
"""
from mpmath import mp, mpf, pi, cos, sin, sqrt, findroot

from one_impact import oscillator, number, show


class Ellipse:
    def __init__(self, w, r, n):
        self.w, self.r = number(w), number(r)
        self.T = 2 * pi * n / self.w
        self.gamma = 1 / (1 - self.w ** 2)
        self.c = (1 + self.r) * sin(self.T) / (1 - cos(self.T))
        self.d = (1 - self.r) / self.w
        self.system = oscillator(0, self.w, self.r, n)

    def speeds(self, sigma):
        root = 2 * sqrt(self.gamma ** 2 * (self.c ** 2 + self.d ** 2) - (sigma * self.d) ** 2)
        return [(-2 * self.c * sigma + s * root) / (self.c ** 2 + self.d ** 2) for s in (1, -1)]

    def phase(self, sigma, V):
        p = mp.atan2(-self.d * V / (2 * self.gamma), (sigma + self.c * V / 2) / self.gamma)
        return p % (2 * pi)

    def trace(self, sigma, V):
        return (-2 * self.r * cos(self.T)
                + (1 + self.r) * (cos(self.phase(sigma, V)) - sigma) * sin(self.T) / V)

    def multipliers(self, sigma, V):
        half = self.trace(sigma, V) / 2
        root = sqrt(mp.mpc(half ** 2 - self.r ** 2))
        return sorted([half + root, half - root], key=lambda z: -abs(z))

    def fold(self):
        return abs(self.gamma) * sqrt(1 + (self.c / self.d) ** 2)

    def doubling(self, sigma, branch):
        return findroot(lambda s: self.trace(s, self.speeds(s)[branch]) + 1 + self.r ** 2, sigma)

    def show(self, name, sigma, V):
        p = self.phase(sigma, V)
        assert abs(self.system.speed(p, 1) - V) < mpf(10) ** -30
        assert abs(self.system.gap(p, 1) - sigma) < mpf(10) ** -30
        M = self.system.map(p, mpf(1))
        assert abs(M[0, 0] + M[1, 1] - self.trace(sigma, V)) < mpf(10) ** -28
        show(name + '_phase', p)
        show(name + '_speed', V)
        m = self.multipliers(sigma, V)
        show(name + '_multiplier_re', m[0].real)
        show(name + '_multiplier_im', abs(m[0].imag))
        show(name + '_multiplier2_re', m[1].real)


if __name__ == '__main__':
    e = Ellipse('2.8', '0.8', 1)
    e.show('w2.8_n1_sigma0', mpf(0), e.speeds(mpf(0))[0])
    s = e.doubling(mpf('-0.07'), 0)
    show('w2.8_n1_doubling_sigma', s)
    show('w2.8_n1_doubling_speed', e.speeds(s)[0])

    e = Ellipse('3.7', '0.8', 2)
    e.show('w3.7_n2_sigma0', mpf(0), e.speeds(mpf(0))[0])
    for i, V in enumerate(e.speeds(number('0.2'))):
        e.show(f'w3.7_n2_sigma0.2_{i}', number('0.2'), V)
    s = e.fold()
    show('w3.7_n2_fold_sigma', s)
    show('w3.7_n2_fold_speed', -2 * e.c * s / (e.c ** 2 + e.d ** 2))

    # the end of the branch at speed 0 is the motion without impacts that just reaches the stop: sigma = |gamma|
    show('w3.7_grazing_sigma', abs(e.gamma))

    # the stop at the place of rest, over the frequency: the doubling of Shaw and Holmes (1983), r = 0.8
    def at_rest(w):
        x = Ellipse.__new__(Ellipse)
        x.w, x.r = w, number('0.8')
        x.T, x.gamma, x.d = 2 * pi / w, 1 / (1 - w ** 2), (1 - x.r) / w
        x.c = (1 + x.r) * sin(x.T) / (1 - cos(x.T))
        return x
    def doubling(w):
        x = at_rest(w)
        return x.trace(0, x.speeds(0)[0]) + 1 + x.r ** 2
    w = findroot(doubling, mpf('2.65'))
    x = at_rest(w)
    show('at_rest_doubling_w', w)
    show('at_rest_doubling_speed', x.speeds(0)[0])
    show('at_rest_doubling_phase', x.phase(0, x.speeds(0)[0]))
