// Passes the samples of a run to its listeners, arc by arc.
#pragma once

#include <functional>

#include "graze/motion/detail/motion.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

class Sampler {
 public:
  // Refers to the system and the listeners. `energy`: samples come with the balance.
  Sampler(const System& system, const RunListeners& listeners, bool energy)
      : system_(system), listeners_(listeners), energy_(energy) {}

  // Passes on the samples of the last arc flown, which began at `start_time`, and forcing phase
  // theta (rad), and took `flight`, s.
  // `samples` counts them from t = 0 on, including those before the first that is wanted.
  // `balance`: at the start of the arc. Returns false as soon as `goes_on` does: an arc can hold
  // any number of samples.
  bool hand_out(Motion<double>& motion, double theta, double start_time, double flight,
                const EnergyBalance& balance, long long& samples,
                const std::function<bool()>& goes_on);

 private:
  const System& system_;
  const RunListeners& listeners_;
  bool energy_;
  Sample sample_;  // the last sample; kept to reuse its memory
};

}  // namespace graze
