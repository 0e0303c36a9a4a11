#include "first_scene.hpp"

#include <fmt/format.h>

namespace graze {
namespace {

// Steel ruler of 0.3 m; the numbers are those of D. J. Wagg, J. Sound Vib. 276 (2004) 1128-1134,
// whose beam stands in data/scenes/02_wagg_momentum.toml with more words.
constexpr const char* kBeam =
    R"toml(# A beam, clamped at one end and shaken there, whose tip meets a stop. SI units, angles in radians.
# What a scene does not name is not simulated.
#
#   graze check FILE                      what of this is simulated
#   graze simulate FILE --duration 2      the motion, impact by impact
#   graze orbit FILE                      periodic orbits, stable or not
#   graze continue FILE --parameter stop.gap --from 5e-4 --to 3e-3
title = "Cantilever against a stop"

[beam]                     # clamped at x = 0, free at x = length
length = 0.3               # m
youngs_modulus = 205e9     # Pa
density = 8500.0           # kg/m^3
area = 12.4e-6             # m^2, of the section
second_moment = 24.4e-14   # m^4, of the section; or both by a shape, [beam.section]
modes = 4                  # more cost time; `graze compare FILE --modes 1:8` says how many it takes

[damping]
viscous = 0.005            # N s/m^2; or ratios = [..], one a mode, of critical damping

[forcing]
kind = "base"              # the clamp moves by amplitude cos(frequency t)
amplitude = 0.0006         # m
frequency = 28.3           # rad/s; or frequency_hz

[[stop]]                   # as many as there are
position = 0.3             # m from the clamp
gap = 1.05e-3              # m, at rest; below zero: pressed against it
side = "above"             # of the beam; or "below"
restitution = 0.8          # speed after an impact over that before it; or a table [stop.spring]

# [[probe]]                # a column of samples: simulate FILE --record samples --out DIR
# position = 0.15          # m from the clamp
# quantity = "displacement"
)toml";

constexpr const char* kOscillator =
    R"toml(# A structure that is given by its modes: here one mass on one spring that meets a stop. Lists have an
# entry a mode; modes are normalised to unit mass. SI units, or any that fit together.
#
#   graze check FILE                      what of this is simulated
#   graze orbit FILE                      periodic orbits, stable or not
#   graze diagram FILE --parameter forcing.frequency --from 2 --to 4 --plot diagram.svg
title = "Impact oscillator"

[modal]
frequencies = [1.0]        # rad/s; 0: nothing holds the mass
damping_ratios = [0.05]    # of critical damping
participation = [1.0]      # modal force per unit of forcing

[forcing]
kind = "modal"             # participation * amplitude * cos(frequency t + phase)
amplitude = 1.0
frequency = 2.8            # rad/s

[[stop]]
shape = [1.0]              # displacement at the stop per unit of each mode
gap = 0.1                  # m
restitution = 0.8          # speed after an impact over that before it

[initial]                  # without it the motion starts at rest at t = 0
q = [0.0]                  # modal displacements
qdot = [0.0]               # and velocities
)toml";

constexpr const char* kLumped =
    R"toml(# Masses and springs in a line: here a ball in the slot of a frame that is shaken. Any number of masses;
# all masses, stiffnesses and dashpots may be varied. SI units; a quantity with a unit of its own is a
# text, "0.25 kg", "1.2 kN/m", "3.1 Hz".
#
#   graze check FILE                      what of this is simulated
#   graze orbit FILE                      periodic orbits, stable or not
#   graze continue FILE --parameter 'stop.*.gap' --from 0.02 --to 0.06 --impacts 2
title = "Frame with an impact damper"

[lumped]
masses = [2.0, 0.25]       # kg
names = ["frame", "ball"]  # by which all below may call them, or by their numbers 1, 2, ..

[[lumped.spring]]          # as many as there are
between = ["ground", "frame"]
stiffness = 800.0          # N/m
damping = 2.0              # N s/m, of a dashpot beside it

[forcing]                  # amplitude cos(frequency t + phase) on one mass; kind = "base" shakes the ground
mass = "frame"
amplitude = 4.0            # N
frequency_hz = 3.1

# [[load]]                 # constant forces
# mass = "frame"
# force = 3.0              # N

[[stop]]                   # that a mass meets: on the ground, or on another mass
mass = "ball"
against = "frame"
gap = 0.04                 # m
restitution = 0.7          # speed after an impact over that before it; or a table [stop.spring]

[[stop]]
mass = "ball"
against = "frame"
gap = 0.04
side = "below"
restitution = 0.7

[initial]                  # without it the motion starts at rest
displacement = [0.0, 0.0]  # m, one for each mass
velocity = [0.1, 0.0]      # m/s
)toml";

constexpr const char* kMatrices =
    R"toml(# A structure by mass and stiffness of a finite-element program: files of Matrix Market, Abaqus,
# CalculiX, NumPy, SciPy or Nastran (DMIG). Paths count from the folder of this file. Those named here
# are an example that comes with Graze, a portal frame; put the names of your own in their place.
#
#   graze modes FILE                      frequencies and shapes of the modes that are kept
#   graze check FILE                      whether they are enough for the stop
#   graze simulate FILE --periods 50
title = "Structure from matrices, shaken against a wall"

[matrices]
mass = "{0}portal_frame_mass.mtx"
stiffness = "{0}portal_frame_stiffness.mtx"
coordinates = "{0}portal_frame_nodes.csv"   # node, x, y, z; only for pictures and base motion
constraints = ["1.1", "1.2", "1.6", "29.1", "29.2", "29.6"]   # held: "node.direction", here both feet
direction = 1              # that the base moves in: x
modes = 8                  # the lowest

[damping]
rayleigh = {{ mass = 3.0, stiffness = 1e-5 }}   # 1/s, s; or ratios = [..], one a mode

[forcing]
kind = "base"              # or "load": forces at the nodes that matrices.load names
amplitude = 1e-3           # m
frequency_hz = 13.0

[[stop]]
node = "21.1"              # "node.direction" of what meets it
gap = 2e-3                 # m
restitution = 0.6

[[probe]]
node = "15.2"
)toml";

constexpr const char* kHub =
    R"toml(# A beam on a hub that turns about an upright axis: a motor's torque swings it against a stop. The
# beam bends while the hub turns, and both are coupled. SI units, angles in radians.
#
#   graze check FILE                      what of this is simulated
#   graze simulate FILE --duration 0.5    the motion, impact by impact; nothing repeats it, so in seconds
#   graze diagram FILE --duration 0.5 --parameter hub.torque.amplitude --from 0.1 --to 0.3 --points 20
title = "Beam on a hub, swung against a stop"

[beam]                     # clamped to the rim of the hub
length = 0.55              # m
youngs_modulus = 6.9e10    # Pa
density = 2710.0           # kg/m^3
area = 1.6e-4              # m^2, of the section
second_moment = 5.4e-10    # m^4, of the section
modes = 3

[hub]
radius = 0.02              # m
inertia = 3e-4             # kg m^2
torque = { kind = "pulse", amplitude = 0.15, duration = 0.3 }   # N m, s
# friction = { coulomb = 0.01 }   # N m, of its bearing

[damping]
ratios = [0.01, 0.01, 0.01]       # of critical damping, one a mode

[[stop]]
position = 0.55            # m along the beam from the rim
gap = 0.1                  # m along the arc, at the start
restitution = 0.6          # or a table [stop.spring], for contacts that take time

[[probe]]
position = 0.55
quantity = "deflection"    # of the beam from the turning line
)toml";

}  // namespace

std::vector<std::string> first_scene_kinds() {
  return {"beam", "lumped", "oscillator", "matrices", "hub"};
}

std::string first_scene(const std::string& kind, const std::string& matrices_folder) {
  if (kind == "lumped") return kLumped;
  if (kind == "oscillator") return kOscillator;
  if (kind == "matrices") return fmt::format(kMatrices, matrices_folder);
  return kind == "hub" ? kHub : kBeam;
}

}  // namespace graze
