#include "graze/motion/detail/sampler.hpp"

#include <algorithm>

#include "graze/motion/detail/contact_forces.hpp"
#include "graze/motion/detail/energy_changes.hpp"

namespace graze {

bool Sampler::hand_out(Motion<double>& motion, double theta, double start_time, double flight,
                       const EnergyBalance& balance, long long& samples,
                       const std::function<bool()>& goes_on) {
  Sample& sample = sample_;
  const ContactPhase<double>& phase = motion.flown();
  const double rate = listeners_.sample_rate;
  samples = std::max(samples, samples_before(listeners_.sample_from, rate));
  sample.state.q.resize(system_.modes());
  sample.state.qdot.resize(system_.modes());
  for (;;) {
    sample.time = static_cast<double>(samples) / rate;
    const double s = std::max(sample.time - start_time, 0.0);
    if (s > flight) return true;
    if (!goes_on()) return false;
    phase.state(s, sample.state.q, sample.state.qdot);
    sample.phase = system_.forcing() ? theta + system_.forcing()->frequency * s : 0.0;
    contact_forces(system_, phase, s, sample.state, sample.forces);
    if (!system_.frictions.empty())
      friction_forces(system_, phase, s, sample.state, sample.frictions);
    if (energy_) {
      sample.energy = balance;
      sample.energy->work = balance.work + work_along(system_, phase, s, theta);
      sample.energy->now = structure_energy(system_, sample.state, sample.phase);
    }
    listeners_.sample(sample);
    ++samples;
  }
}

}  // namespace graze
