// What drives a structure as the scene has it, loads and stops that move, in terms of the system.
//
// A stop that moves by m(t) along u keeps its row's displacement below gap + m. With any motion c of
// the modes of which row_i.c = m_i at every stop, q = q^ + c leaves stops that stand still to q^, and
//
//   q^'' + D q^' + w^2 q^ = f - (c'' + D c' + w^2 c),
//
// harmonics of the force like all others. Of all such motions c is the one of least kinetic energy.
#pragma once

#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct DrivenMotion {
  HarmonicForcing forcing;
  std::vector<Harmonic> carried;  // c, kg^1/2 m; empty where no stop moves
};

// Of a checked scene with forcing. Throws InputError where its modes cannot follow all stops, as
// where two of them at one place move differently.
DrivenMotion driven_motion(const Scene& scene, const ModalModel& model);

// Its derivative along a direction of the scene (system_tangent).
DrivenMotion driven_motion_rate(const Scene& scene, const Scene& direction, const ModalModel& model,
                                const ModalModel& rate);

}  // namespace graze
