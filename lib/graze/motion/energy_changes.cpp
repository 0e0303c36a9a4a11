#include "graze/motion/detail/energy_changes.hpp"

#include <algorithm>

#include "graze/contact/detail/impulse.hpp"

namespace graze {

namespace {

// Twice the kinetic energy of what rubs behind springs, by products of two velocities: it has no
// mass, its coordinate has.
double of_no_mass(const System& system, const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (const Friction& friction : system.frictions)
    if (friction.series) sum += friction.row.dot(a) * friction.direction.dot(b);
  return sum;
}

}  // namespace

double mechanical_energy(const System& system, const Vector& q, const Vector& qdot) {
  const double energy = 0.5 * (qdot.squaredNorm() + system.omega.cwiseProduct(q).squaredNorm() -
                               of_no_mass(system, qdot, qdot));
  if (!system.turns()) return energy;
  const double rate = system.rotation()->angle.dot(qdot);
  return energy + 0.5 * added_inertia(*system.rotation(), q) * rate * rate;
}

double structure_energy(const System& system, const State& state, double theta) {
  if (!system.carried()) return mechanical_energy(system, state.q, state.qdot);
  const State own = structure_state(system, state, theta);
  return mechanical_energy(system, own.q, own.qdot);
}

double kinetic_change(const System& system, const Vector& q, const Vector& before,
                      const Vector& after) {
  const double change = 0.5 * ((after - before).dot(after + before) -
                               of_no_mass(system, after - before, after + before));
  if (!system.turns()) return change;
  const Vector& row = system.rotation()->angle;
  return change + 0.5 * added_inertia(*system.rotation(), q) * row.dot(after - before) *
                      row.dot(after + before);
}

void impact_energy(const System& system, const std::vector<ImpactShare<double>>& shares,
                   const Vector& q, const Vector& before, const Vector& after,
                   ImpactEnergy& energy) {
  const auto acts = [](const ImpactShare<double>& share) { return share.impulse > 0.0; };
  const bool alone = std::count_if(shares.begin(), shares.end(), acts) == 1;
  energy.total = 0.0;
  energy.hits.clear();
  double elsewhere = 0.0;
  // Sums are formed in the order of the shares, which does not depend on how stops are listed.
  for (const ImpactShare<double>& share : shares) {
    const Stop& s = system.stops[static_cast<std::size_t>(share.stop)];
    const double r = s.restitution().at(share.speed);
    const double change =
        !acts(share) ? 0.0
        : system.turns()
            // An impulse p/mobility along the row, at the mean of the speeds.
            ? -0.5 * share.impulse / mobility(*system.rotation(), s.row, q) *
                  (share.speed + share.speed_after)
            : alone && share.speed_after == -r * share.speed
                  ? impact_energy_change(s.row, s.direction(), before, r)
                  : shared_energy_change(s.row, s.direction(), share.impulse, share.speed,
                                         share.speed_after, 0.5 * (before + after));
    energy.total += change;
    if (share.hit)
      energy.hits.push_back({share, change});
    else
      elsewhere += change;
  }
  if (!energy.hits.empty()) energy.hits.front().change += elsewhere;
  std::sort(energy.hits.begin(), energy.hits.end(),
            [](const auto& a, const auto& b) { return a.share.stop < b.share.stop; });
}

void add_impact_work(const System& system, double theta, const Vector& before, const Vector& after,
                     Work& work) {
  if (!system.carried()) return;
  const Vector place = Vector::Zero(before.size());
  add_carried_jump(system, theta, {place, before}, {place, after}, work);
}

double energy_change(const System& system, const State& before, const State& after) {
  const Vector from = system.omega.cwiseProduct(before.q), to = system.omega.cwiseProduct(after.q);
  return kinetic_change(system, before.q, before.qdot, after.qdot) +
         0.5 * (to - from).dot(to + from);
}

Work work_at_once(const System& system, double theta, const Vector& shift) {
  Work work;
  if (system.forcing()) work.forcing = system.forcing()->at(theta).dot(shift);
  if (system.load()) work.load = system.load()->dot(shift);
  return work;
}

Work operator+(const Work& a, const Work& b) {
  return {a.forcing + b.forcing,         a.load + b.load,       a.constraint + b.constraint,
          a.dissipation + b.dissipation, a.contact + b.contact, a.contact_lost + b.contact_lost,
          a.friction + b.friction,       a.stops + b.stops};
}

double closure_energy_change(const System& system, const std::vector<int>& closed, double theta,
                             const State& before, const State& after, Work& work) {
  if (system.carried()) add_carried_jump(system, theta, before, after, work);
  if (system.turns()) return energy_change(system, before, after);
  const Stop& only = system.stops[static_cast<std::size_t>(closed.front())];
  if (closed.size() == 1) return impact_energy_change(only.row, only.direction(), before.qdot, 0.0);
  const Work shift = work_at_once(system, theta, after.q - before.q);
  work = work + shift;
  return energy_change(system, before, after) - shift.forcing - shift.load;
}

}  // namespace graze
