"""From a scene file to the modal equations, in high precision.

    q_j'' + 2 delta_j q_j' + w_j^2 q_j = g_j cos(Omega t + psi) + c_j,      j = 1..N

(with several [[forcing]] a sum of such forces at multiples of Omega)

with mass-normalised modes and stops: free while  row . q < gap.  An impact with approach speed
v = row . q'  changes the velocities by  -(1 + r) v d,  where  row . d = 1.

Every number of the scene is taken as the double nearest to its literal and is exact from there on.
"""
import tomllib
from dataclasses import dataclass, field, replace

from mpmath import mp, mpf

mp.dps = 50


# ---------------------------------------------------------------- the clamped-free beam of unit length

def wave_number(j):
    """b_j, the j-th positive root of cos(b) cosh(b) = -1, to the working precision."""
    b = (2 * j - 1) * mp.pi / 2
    if j == 1:
        b = mpf('1.8751')
    for _ in range(200):                              # Newton on cos(b) + sech(b), well scaled for any b
        sech = 1 / mp.cosh(b)
        step = (mp.cos(b) + sech) / (-mp.sin(b) - sech * mp.tanh(b))
        b -= step
        if abs(step) <= b * mp.eps * 4:
            return b
    raise ArithmeticError(f"root {j} did not converge")


def extra_digits(j):
    """Digits that the textbook shape loses: cosh and sinh grow to exp(b) and cancel."""
    return int(2 * 3.1416 * j / 2.302) + 10


def mode_shape(j, xi):
    """(phi, dphi/dxi, d^2phi/dxi^2) at xi = x/L for unit length and mass, so that |phi(1)| = 2.

    Textbook form  cosh - cos - s (sinh - sin), evaluated with as many more digits as it loses.
    """
    with mp.extradps(extra_digits(j)):
        b = wave_number(j)
        s = (mp.cosh(b) + mp.cos(b)) / (mp.sinh(b) + mp.sin(b))
        z = b * xi
        phi = mp.cosh(z) - mp.cos(z) - s * (mp.sinh(z) - mp.sin(z))
        slope = b * (mp.sinh(z) + mp.sin(z) - s * (mp.cosh(z) - mp.cos(z)))
        curvature = b * b * (mp.cosh(z) + mp.cos(z) - s * (mp.sinh(z) + mp.sin(z)))
    return +phi, +slope, +curvature


def mode_integral(j):
    """Integral of phi_j over 0..1: 2 s_j / b_j."""
    with mp.extradps(extra_digits(j)):
        b = wave_number(j)
        s = (mp.cosh(b) + mp.cos(b)) / (mp.sinh(b) + mp.sin(b))
        value = 2 * s / b
    return +value


# ---------------------------------------------------------------- the modal system

@dataclass
class Stop:
    row: list                # contact row, pointing into the stop
    jump: list               # d, with row . d = 1
    gap: mpf
    restitution: mpf


@dataclass
class ModalSystem:
    frequency: list          # w_j, rad/s
    two_delta: list          # 2 delta_j, 1/s
    force: list              # g_j: amplitude of the modal force
    omega: mpf               # Omega, rad/s
    psi: mpf                 # phase of the forcing
    static: list             # c_j: the constant load (gravity)
    stops: list
    q0: list                 # initial state
    v0: list
    further: list = field(default_factory=list)       # (order Omega, psi, g) of each further [[forcing]]

    @property
    def loads(self):
        """(frequency, phase, g) of every harmonic force."""
        return [(self.omega, self.psi, self.force)] + self.further

    @property
    def modes(self):
        return len(self.frequency)

    # Of a system with one stop:
    @property
    def row(self):
        return self.stops[0].row

    @property
    def jump(self):
        return self.stops[0].jump

    @property
    def restitution(self):
        return self.stops[0].restitution

    @property
    def gap(self):
        return self.stops[0].gap

    @gap.setter
    def gap(self, value):
        self.stops = [replace(self.stops[0], gap=value)] + self.stops[1:]


def dot(a, b):
    return mp.fdot(a, b)


def real(x):
    """The double nearest to a literal, exactly."""
    return mpf(float(x))


def solve_columns(columns, rhs):
    """x with  sum_j columns[j] x_j = rhs."""
    n = len(rhs)
    matrix = mp.matrix(n, n)
    for j in range(n):
        for i in range(n):
            matrix[i, j] = columns[j][i]
    return list(mp.lu_solve(matrix, mp.matrix(rhs)))


def read_scene(path):
    with open(path, 'rb') as file:
        return tomllib.load(file)


def assemble(scene):
    """The modal system of a scene (a TOML document already read)."""
    return from_beam(scene) if 'beam' in scene else from_modes(scene)


def make_stop(stop, row, columns):
    """One stop of the scene. row: the shapes at it; columns: d of the collocation law."""
    side = {'above': 1, 'below': -1}[stop.get('side', 'above')]
    row = [side * x for x in row]
    law = stop.get('impulse', 'momentum')
    if law == 'momentum':                             # impulse along M^-1 row; the modal mass is 1
        size = dot(row, row)
        jump = [x / size for x in row]
    else:                                             # Phi^-1 R Phi: only the stop's own point is turned back
        jump = [side * x for x in columns]
    return Stop(row, jump, real(stop['gap']), real(stop['restitution']))


def finish(scene, w, two_delta, force, static, stops):
    """Forcing and initial state: alike for a beam and for given modes."""
    forcing, initial = first_load(scene), scene.get('initial', {})
    zero = [0.0] * len(w)
    base = real(forcing.get('frequency', 0.0))
    omega = real(forcing.get('order', 1.0)) * base
    further = []
    for load in scene['forcing'][1:] if isinstance(scene.get('forcing'), list) else []:
        shape = load.get('shape', scene.get('modal', {}).get('participation'))
        further.append((real(load.get('order', 1.0)) * base, real(load.get('phase', 0.0)),
                        [real(load['amplitude']) * real(x) for x in shape]))
    return ModalSystem(w, two_delta, force, omega, real(forcing.get('phase', 0.0)), static, stops,
                       [real(x) for x in initial.get('q', zero)], [real(x) for x in initial.get('qdot', zero)], further)


def first_load(scene):
    forcing = scene.get('forcing', {})
    return forcing[0] if isinstance(forcing, list) else forcing


def twice_decay_rates(scene, w, ratios):
    """2 delta_j from the scene's damping other than viscous; `ratios`: those that stand with the modes."""
    damping = scene.get('damping', {})
    if 'rayleigh' in damping:
        alpha, beta = (real(damping['rayleigh'][key]) for key in ('mass', 'stiffness'))
        return [alpha + beta * wj ** 2 for wj in w]
    return [2 * real(z) * wj for z, wj in zip(damping.get('ratios', ratios), w)]


def gravity(scene):
    return real(scene.get('gravity', {}).get('acceleration', 0.0))


def from_modes(scene):
    modal = scene['modal']
    w = [real(x) for x in modal['frequencies']]
    zero = [0.0] * len(w)
    two_delta = twice_decay_rates(scene, w, modal.get('damping_ratios', zero))
    forcing = first_load(scene)
    amplitude = real(forcing.get('amplitude', 0.0))
    force = [amplitude * real(x) for x in forcing.get('shape', modal.get('participation', zero))]
    static = [gravity(scene) * real(x) for x in modal.get('inertia', zero)]
    stops = [make_stop(stop, [real(x) for x in stop['shape']], None) for stop in scene['stop']]
    return finish(scene, w, two_delta, force, static, stops)


def from_beam(scene):
    beam = scene['beam']
    n = beam['modes']
    length = real(beam['length'])
    mass_per_length = real(beam['density']) * real(beam['area'])
    stiffness = real(beam['youngs_modulus']) * real(beam['second_moment'])
    norm = 1 / mp.sqrt(mass_per_length * length)      # unit mass -> mass-normalised shape

    w = [wave_number(j) ** 2 * mp.sqrt(stiffness / (mass_per_length * length ** 4)) for j in range(1, n + 1)]

    damping = scene.get('damping', {})
    if 'viscous' in damping:
        two_delta = [real(damping['viscous']) / mass_per_length] * n
    else:
        two_delta = twice_decay_rates(scene, w, [0.0] * n)

    def shapes_at(xi):
        return [norm * mode_shape(j, xi)[0] for j in range(1, n + 1)]

    points = [mpf(i) / n for i in range(1, n + 1)]    # collocation points i L/N
    phi_at_points = [shapes_at(xi) for xi in points]  # rows of Phi
    columns_of_phi = [[r[j] for r in phi_at_points] for j in range(n)]

    # modal share of a unit uniform acceleration, integral of rho A phi_j
    if beam.get('discretisation', 'galerkin') == 'galerkin':
        share = [mode_integral(j) / norm for j in range(1, n + 1)]
    else:
        share = solve_columns(columns_of_phi, [mpf(1)] * n)

    forcing = scene['forcing']
    amplitude = real(forcing['amplitude'])
    if forcing['kind'] == 'base':
        amplitude *= real(forcing['frequency']) ** 2  # inertia of the moving frame, per unit mass
    else:
        amplitude /= mass_per_length                  # distributed: force per length
    force = [amplitude * x for x in share]
    static = [gravity(scene) * x for x in share]

    def stop_at(stop):
        xi, columns = real(stop['position']) / length, None
        if stop.get('impulse') == 'collocation':
            unit = [mpf(1) if abs(point - xi) < mpf('1e-12') else mpf(0) for point in points]
            if sum(unit) != 1:
                raise ValueError("the stop is not a collocation point")
            columns = solve_columns(columns_of_phi, unit)
        return make_stop(stop, shapes_at(xi), columns)

    return finish(scene, w, two_delta, force, static, [stop_at(stop) for stop in scene['stop']])
