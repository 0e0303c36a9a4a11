// The energy balance of a run, J:
//
//   start + forcing + load + constraint + stops + friction + impacts + contact - dissipation = now,
//
// where energy is (|q'|^2 + |w q|^2)/2, relative to the clamp, without that of compressed stops; on
// a rotating hub it is (q'.M q' + |w q|^2)/2, forcing is the work of the torque and load that of
// the weight. Every entry is computed independently, so the balance closes only if all are right.
#pragma once

#include <cmath>

#include "graze/flow/variation/arc_work.hpp"

namespace graze {

struct EnergyBalance {
  double start = 0.0, now = 0.0;
  Work work;
  double impacts = 0.0;  // change at impacts and closed chatters

  // The difference of both sides, and the size of the largest entry to compare it with.
  double defect() const {
    return start + work.forcing + work.load + work.constraint + work.stops + work.friction +
           impacts + work.contact - work.dissipation - now;
  }
  double size() const {
    return std::fmax(
        std::fmax(std::fmax(start, now), std::fmax(std::abs(work.forcing), std::abs(work.load))),
        std::fmax(
            std::fmax(std::fmax(std::abs(work.constraint), std::abs(work.stops)),
                      std::fmax(std::abs(impacts), std::abs(work.friction))),
            std::fmax(std::fmax(std::abs(work.contact), work.contact_lost), work.dissipation)));
  }
};

}  // namespace graze
