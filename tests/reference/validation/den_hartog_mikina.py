"""Mass 1 between two springs k = 1 with clearance a = 1 on either side, force F cos(W t), no damping.

The symmetric motion x(t + T/2) = -x(t), even in t, touches a spring for |t| < s. With w^2 = k:
    |t| < s:         x = a + B cos(w t) + F cos(W t)/(w^2 - W^2)
    s < t < T/2 - s: x = C (t - T/4) - F cos(W t)/W^2
Both reach a at t = s with the same velocity: three equations for B, C, s. Half a period of the linearised motion is
    H = -(1, T/2 - 2 s; 0, 1) (cos 2 w s, sin(2 w s)/w; -w sin 2 w s, cos 2 w s),
of determinant 1; its square has the multipliers, of real part (tr H)^2/2 - 1.
"""
from mpmath import mp, mpf, pi, cos, sin, findroot

from one_impact import number, show


def motion(F, W, start):
    T = 2 * pi / W

    def parts(s):
        B = -F * cos(W * s) / (1 - W ** 2) / cos(s)
        C = (1 + F * cos(W * s) / W ** 2) / (s - T / 4)
        return B, C

    def mismatch(s):
        B, C = parts(s)
        return -B * sin(s) - F * W * sin(W * s) / (1 - W ** 2) - C - F * sin(W * s) / W
    s = findroot(mismatch, start)
    B, C = parts(s)
    v = -(C + F * sin(W * s) / W)
    trace = -(2 * cos(2 * s) - (T / 2 - 2 * s) * sin(2 * s))
    x0 = 1 + B + F / (1 - W ** 2)
    return s, v, x0, trace ** 2 / 2 - 1


if __name__ == '__main__':
    for W, start in (('0.6', 1.9), ('0.5', 2.0), ('0.8', 1.8)):
        s, v, x0, m = motion(number('0.5'), number(W), mpf(start))
        assert s > 0 and v > 0
        show(f'W{W}_entry_phase', 2 * pi - number(W) * s)
        show(f'W{W}_other_entry_phase', pi - number(W) * s)
        show(f'W{W}_speed', v)
        show(f'W{W}_contact', 2 * s)
        show(f'W{W}_peak_force', x0 - 1)
        show(f'W{W}_multiplier_re', m)
