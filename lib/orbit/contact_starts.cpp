#include "graze/orbit/contact_starts.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/contact/impulse.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/rough_guess.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// A restitution that depends on the speed is found with it in a few rounds, well enough to start
// from.
constexpr int kRounds = 3;

// What one contact of a body with the effective mass of a stop gives back of its speed, m/s.
double restitution_of(const Stop& stop, double speed) {
  System body{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {stop}};
  body.stops[0].row = Vector::Constant(1, stop.row.norm());
  body.stops[0].gap = 0.0;
  double restitution = 0.0;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kSeparation && event.effective_restitution)
      restitution = std::clamp(*event.effective_restitution, 0.0, 1.0);
  };
  SimulationOptions options;
  // Depths take no longer than this at any exponent: 2 depth/speed is exceeded by none.
  const double mobility = body.stops[0].row.squaredNorm(), n = stop.force().exponent;
  const double depth = std::pow(
      0.5 * (n + 1.0) * speed * speed / (stop.force().stiffness * mobility), 1.0 / (n + 1.0));
  options.duration = 100.0 * depth / speed;
  simulate(body, {Vector::Zero(1), Vector::Constant(1, speed / stop.row.norm())}, options,
           listeners);
  return restitution;
}

// From just before an impact, through its contact to the end of the forcing period.
void add_start(const System& system, const ImpactPoint& point, int stop,
               const PassageOptions& passage, std::vector<State>& starts) {
  const double local = wrapped(point.theta - system.forcing()->phase) / system.forcing()->frequency;
  if (!(local < system.period())) return;
  MotionState<double> before =
      Motion<double>(system, {0, local}, point.before.q, point.before.qdot).state();
  // Rounding may have left it beyond the surface.
  before.contacts[static_cast<std::size_t>(stop)] = Contact::kTouching;
  const Passage passed = pass(system, before, {1, 0.0}, passage);
  if (passed.failure.empty()) starts.push_back({passed.end.q, passed.end.qdot});
}

}  // namespace

std::vector<State> closed_form_contacts(const System& system, int period,
                                        const PassageOptions& passage) {
  std::vector<State> starts;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    // The two solutions have speeds of their own.
    for (std::size_t which = 0; which < 2 && stop.is_compliant(); ++which) {
      if (passage.stop.requested()) return starts;
      double speed = motion_scale(system).speed;
      std::optional<ImpactPoint> point;
      for (int round = 0; round < kRounds && speed > 0.0; ++round) {
        System rigid = system;
        rigid.stops[i].law =
            ImpactLaw{momentum_direction(stop.row), Restitution{restitution_of(stop, speed)}};
        const ClosedFormAnswer answer = closed_form(rigid, static_cast<int>(i), period);
        if (!answer.form) break;
        const std::vector<ImpactPoint> points = answer.form->solutions(stop.gap);
        if (which >= points.size()) break;
        point = points[which];
        speed = stop.row.dot(point->before.qdot);
      }
      if (point && speed > 0.0) add_start(system, *point, static_cast<int>(i), passage, starts);
    }
  }
  return starts;
}

std::vector<State> rough_contacts(const System& system, int stop, int period, int count,
                                  double speed, std::uint64_t seed, const PassageOptions& passage) {
  std::vector<State> starts;
  for (const std::vector<ImpactPoint>& guess :
       rough_guesses(system, {period, {stop}}, count, speed, seed)) {
    if (passage.stop.requested()) break;
    add_start(system, guess.front(), stop, passage, starts);
  }
  return starts;
}

}  // namespace graze
