"""Contacts of one mass with a linear spring, in closed form.

Code_Aster SDND101 (V5.01.101): m u'' + k u = -K u while u > 0, u = 0 and u' = v at t = 0. A contact is half a period
of w1 = sqrt((k + K)/m) and a flight half a period of w0 = sqrt(k/m); the force is largest, K v/w1, half way.

Code_Aster SDND108 (V5.01.108): a mass falls with g from u = 0, thrown down with v, onto a spring k at u = -h, with a
damper c beside it (A: c = 0, B: c = 5 N s/m). With x = -h - u the depth and V = sqrt(v^2 + 2 g h) the speed there,

    x'' + (c/m) x' + (k/m) x = g,   x(0) = 0, x'(0) = V,   until x = 0 again; then free flight.

Ansys VM65 (Thomson, example 4.6-1): the same without damper, from rest; pounds and inches.
"""
from mpmath import mp, mpf, atan, cos, exp, findroot, pi, sin, sqrt

mp.dps = 30


def show(name, value):
    print(name, mp.nstr(value, 20))


# ------------------------------------------------------------------ SDND101
m, k, K, v = mpf(100), mpf(10) ** 4, mpf(10) ** 6, mpf(1)
w0, w1 = sqrt(k / m), sqrt((k + K) / m)
show("sdnd101_duration", pi / w1)
show("sdnd101_peak_force", K * v / w1)
show("sdnd101_speed_of_contact_2", v)              # nothing is lost
show("sdnd101_middle_1", pi / (2 * w1))
show("sdnd101_contact_2", pi / w1 + pi / w0)
show("sdnd101_middle_2", 3 * pi / (2 * w1) + pi / w0)
show("sdnd101_impulse", 2 * K * v / w1 ** 2)


# ---------------------------------------------------------- a mass that falls
class Fall:
    """Depth and speed in the spring, from the instant of contact on."""

    def __init__(self, m, c, k, g, v, h):
        self.g, self.h, self.v = g, h, v
        self.speed = sqrt(v ** 2 + 2 * g * h)
        self.contact = (self.speed - v) / g
        self.decay = c / (2 * m)
        self.w = sqrt(k / m - self.decay ** 2)
        self.rest = m * g / k                      # depth of static equilibrium

    def depth(self, s):
        a = -self.rest
        b = (self.speed + self.decay * a) / self.w
        return self.rest + exp(-self.decay * s) * (a * cos(self.w * s) + b * sin(self.w * s))

    def rate(self, s):
        a = -self.rest
        b = (self.speed + self.decay * a) / self.w
        return exp(-self.decay * s) * ((b * self.w - self.decay * a) * cos(self.w * s)
                                       - (a * self.w + self.decay * b) * sin(self.w * s))

    def leave(self):
        """Time in the spring until the depth is zero again: beyond half a period, before a whole one."""
        s = findroot(self.depth, (pi / self.w, mpf(3) / 2 * pi / self.w), solver="anderson")
        assert abs(self.depth(s)) < mpf(10) ** -25
        return s

    def height(self, t):
        """u at the time t, before the second contact."""
        if t <= self.contact:
            return -self.v * t - self.g * t ** 2 / 2
        s = t - self.contact
        if s <= self.leave():
            return -self.h - self.depth(s)
        free = s - self.leave()
        return -self.h - self.rate(self.leave()) * free - self.g * free ** 2 / 2


for name, c in (("sdnd108a", mpf(0)), ("sdnd108b", mpf(5))):
    fall = Fall(m=mpf(1), c=c, k=mpf(100), g=mpf(10), v=mpf(1), h=mpf(2))
    show(name + "_contact", fall.contact)
    show(name + "_separation", fall.contact + fall.leave())
    show(name + "_height_at_1", fall.height(mpf(1)))
    show(name + "_height_at_1.1", fall.height(mpf("1.1")))

# --------------------------------------------------------------------- VM65
ball = Fall(m=mpf("0.5"), c=mpf(0), k=mpf("1973.92088"), g=mpf(386), v=mpf(0), h=mpf(1))
lowest = (pi - atan(ball.speed * ball.w / ball.g)) / ball.w      # in the spring; tan w s = -V w/g
assert abs(ball.rate(lowest)) < mpf(10) ** -25
show("vm65_contact", ball.contact)
show("vm65_speed", ball.speed)
show("vm65_kinetic_energy", mpf("0.5") * ball.speed ** 2 / 2)
show("vm65_time_of_lowest_point", ball.contact + lowest)
show("vm65_lowest_point", -ball.h - ball.depth(lowest))
early = mpf("0.10037")
show("vm65_height_at_0.10037", ball.height(early))
show("vm65_velocity_at_0.10037", -ball.rate(early - ball.contact))
