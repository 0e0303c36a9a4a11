"""Exact motion of the event-driven examples of Siconos: balls, a mass on a spring, a column of beads.

Between impacts every one of them is a parabola or a sine about the position of rest, so that each flight has a closed
form; an impact leaves e times the speed. Prints `name value` lines, 20 digits; impacts count from 1, speeds are those
of approach. Parameters are those of Siconos' programs of the same names (github.com/siconos/siconos-tutorials,
examples/mechanics/BouncingBallEventDriven, and github.com/siconos/siconos, examples/Mechanics/ColumnOfBeads).
"""

from mpmath import acos, atan, cos, mp, mpf, nstr, sin, sqrt

mp.dps = 40
ENOUGH = 1200  # impacts: the last speed is below 1e-50


def show(name, value):
    print(name, nstr(value, 20))


def show_impacts(name, impacts, numbers):
    for n in numbers:
        time, speed = impacts[n - 1]
        show(f'{name}_time_{n}', time)
        show(f'{name}_speed_{n}', speed)


# LinearOscillatorED: m u'' + k u = -m g, u(0) = u0, stop at u = 0, below. The position of rest, u = -d with d = m g/k,
# lies below the stop. From u = 0 upwards at speed V: u = -d (1 - cos w t) + (V/w) sin w t, back at tan(w t/2) = V/(w d).
m, k, g, e, u0 = mpf('1e-3'), mpf(100), mpf('9.81'), mpf('0.9'), mpf(1)
w, d = sqrt(k / m), m * g / k
oscillator = [(acos(d / (u0 + d)) / w, w * sqrt((u0 + d) ** 2 - d ** 2))]
while len(oscillator) < ENOUGH:
    time, speed = oscillator[-1]
    oscillator.append((time + 2 / w * atan(e * speed / (w * d)), e * speed))
show_impacts('oscillator', oscillator, (1, 2, 3, 10, 20, 40, 83, 100, 120))
show('oscillator_rest', oscillator[-1][0])
show('oscillator_force', m * g)

# What summing the chatter as if the spring did not vary, with hops 2 V/g, makes of the time of rest, once the speed of
# approach is below 1e-6 w u0: at most the sum of (2/w) x^3/3 over the hops, x = V/(w d).
x = e * mpf('1e-6') * w * u0 / (w * d)
show('oscillator_rest_error_of_summing', 2 / w * x ** 3 / 3 / (1 - e ** 3) / oscillator[-1][0])


def oscillator_at(t):
    """u and u' at t, while it moves"""
    last = max(n for n, (time, _) in enumerate(oscillator) if time < t)
    time, speed = oscillator[last]
    tau, up = t - time, e * speed
    return -d * (1 - cos(w * tau)) + up / w * sin(w * tau), -d * w * sin(w * tau) + up * cos(w * tau)


# Across, the same mass swings on a spring of its own, k as well, from 1 mm, and no stop is in its way.
for t in ('0.1', '0.375', '0.98', '7.07'):
    at = mpf(t)
    if at < oscillator[-1][0]:
        u, speed = oscillator_at(at)
        show(f'oscillator_u_at_{t}', u)
        show(f'oscillator_velocity_at_{t}', speed)
    show(f'oscillator_across_at_{t}', mpf('1e-3') * cos(w * at))
    show(f'oscillator_velocity_across_at_{t}', -mpf('1e-3') * w * sin(w * at))


def ball(time, speed, e):
    """impacts of a ball on a floor, the first at `time` with `speed`: flights of 2 V/g"""
    impacts = []
    while len(impacts) < ENOUGH:
        impacts.append((time, speed))
        speed *= e
        time += 2 * speed / g
    return impacts


# BouncingBallED: dropped from 1 m.
dropped = ball(sqrt(2 / g), sqrt(2 * g), e)
show_impacts('dropped', dropped, (1, 9, 10, 11, 27, 31, 37, 44))

# BouncingBallED-initialImpact: from the floor, at -1 m/s.
thrown = ball(mpf(0), mpf(1), e)
show_impacts('thrown', thrown, (1, 2, 3, 18, 30, 39, 60))
show('thrown_rest', thrown[-1][0])
show('thrown_force', g)

# BouncingBallED-withRestingContact: dropped from 1 m, e = 0, so it stays down at the first impact (as dropped_time_1).

# BouncingBallED-TwoContacts: g = 10, floor at 0, ceiling at H, from u = 1 upwards at 10 m/s, e = 0.8.
g10, H, e8 = mpf(10), mpf('1.5'), mpf('0.8')
u, velocity, time = mpf(1), mpf(10), mpf(0)
between = []
while len(between) < ENOUGH:
    if velocity > 0 and velocity ** 2 > 2 * g10 * (H - u):  # up to the ceiling
        speed = sqrt(velocity ** 2 - 2 * g10 * (H - u))
        time += (velocity - speed) / g10
        u, velocity = H, -e8 * speed
        stop = 2
    else:  # down to the floor
        speed = sqrt(velocity ** 2 + 2 * g10 * u)
        time += (velocity + speed) / g10
        u, velocity = mpf(0), e8 * speed
        stop = 1
    between.append((time, speed))
    if len(between) <= 5:
        print(f'between_stop_{len(between)}', stop)  # 1 floor, 2 ceiling
show_impacts('between', between, (1, 2, 3, 4, 5, 10, 12, 22, 30, 38, 47))
show('between_rest', between[-1][0])
at = mpf('1.29') - between[3][0]  # after impact 4, on the floor, and before impact 5
show('between_u_at_1.29', e8 * between[3][1] * at - g10 * at ** 2 / 2)
show('between_velocity_at_1.29', e8 * between[3][1] - g10 * at)

# BeadColumnED_NewtonLaw: ten equal beads of radius 5 mm, one on the other, 50 mm above the floor, e = 1 at all contacts.
# Newton's law with impulses shared by complementarity turns all of them at once: beads in contact approach at speed 0
# and must not approach afterwards, which with v+ >= v at the floor needs impulses that give every bead +v.
first = sqrt(2 * mpf('0.05') / g)
back = g * first
show('beads_time_1', first)
show('beads_speed', back)
show('beads_time_2', 3 * first)
at = mpf('0.325') - 3 * first
for bead in (1, 10):
    show(f'beads_height_{bead}_at_0.325', mpf('0.005') + (bead - 1) * mpf('0.01') + back * at - g * at ** 2 / 2)
show('beads_velocity_at_0.325', back - g * at)
