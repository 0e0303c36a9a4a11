"""Impact damper: a mass M on a spring and a dashpot, harmonically forced, and a particle m free in a slot of length d in it.

Scaled to x1'' + 2 zeta x1' + x1 = cos(W t), mass ratio mu = m/M, restitution e. In mass-normalised modes (q1 = x1, q2 =
sqrt(mu) x2) the particle's place in the slot is z = x2 - x1 = b.q, b = (-1, 1/sqrt(mu)). The motion with two equispaced
impacts per period goes over into its negative after half a period: with E the free flow over T/2, J the impact and
Re(p_hat e^{i phi}) the forced motion, the state before the impact on the far side (z = d/2) is
    y = (I + E J)^-1 (I + E) Re(p_hat e^{i phi}),      d/2 = Re(kappa e^{i phi}).
H = -E S is the linearised half period (S the saltation matrix): a multiplier of H at 1 is a fold, at -1 the loss of
symmetry, a pair on the unit circle a torus. The motion vanishes at speed 0 where d is the double amplitude of x1.
"""
from mpmath import mp, mpf, eye, det, lu_solve, findroot, sqrt

from one_impact import OneImpact, number, show


class TwoImpacts(OneImpact):
    def close(self):
        one = eye(2 * self.n)
        self.E = self.flow(self.period / 2)
        self.before = lu_solve(one + self.E * self.J, (one + self.E) * self.forced)

    def half(self, phi):
        return -self.map(phi, mpf(1))

    def turns(self, phi):
        """Squares of the multipliers of half a period: those of a whole one."""
        return sorted((z ** 2 for z in mp.eig(self.half(phi), left=False, right=False)), key=lambda z: -abs(z))

    def margin(self, phi):
        """By how much the slot is longer than the ways of the particle between impacts (a check of admissibility)."""
        half = self.gap(phi, mpf(1))
        return min(half - abs(self.displacement(phi, mpf(1), self.period * (i + mpf(1) / 2) / 400)[0]) for i in range(200))


if __name__ == '__main__':
    # zeta = 0.05, mu = 0.1 by way of 1/sqrt(mu) as the double nearest to it, W = 1, e = 0.8
    s = TwoImpacts([mpf(1), mpf(0)], [number('0.05'), mpf(0)], [mpf(1), mpf(0)],
                   [mpf(-1), number('3.1622776601683795')], mpf(1), number('0.8'))

    def slot(phi):
        return 2 * s.gap(phi, mpf(1))

    def at(d, start):
        return findroot(lambda phi: slot(phi) - d, start)

    phi = at(mpf(20), mpf('3.006')) % (2 * mp.pi)
    show('d20_phase', phi)
    show('d20_speed', s.speed(phi, 1))
    show('d20_margin', s.margin(phi))
    for i, z in enumerate(s.turns(phi)):
        show(f'd20_multiplier_{i}_re', z.real)
        show(f'd20_multiplier_{i}_im', abs(z.imag))

    phi = findroot(lambda p: det(s.half(p) + eye(4)), mpf('2.77'))
    show('symmetry_lost_d', slot(phi))
    show('symmetry_lost_phase', phi)
    show('symmetry_lost_speed', s.speed(phi, 1))

    phi = s.fold()
    show('fold_d', slot(phi))
    show('fold_speed', s.speed(phi, 1))
    show('fold_phase', phi)

    def torus(p, angle):
        z = det(s.half(p) - mp.expj(angle) * eye(4))
        return [z.real, z.imag]
    phi, angle = findroot(torus, (mpf('3.2'), mpf('0.48')))
    show('torus_d', slot(phi))
    show('torus_phase', phi)
    show('torus_speed', s.speed(phi, 1))
    show('torus_angle', 2 * angle)

    show('vanishing_d', 2 / (2 * number('0.05')))
