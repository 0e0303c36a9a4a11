#include "graze/orbit/search/detail/contact_starts.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/search/detail/rough_guess.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// A restitution that depends on the speed and the speed are found together in a few rounds,
// accurately enough for a start.
constexpr int kRounds = 3;

// Restitution of one contact of a body with the effective mass of a stop, at a speed in m/s.
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
  // Upper bound on the duration of a contact: 2 depth/speed, for any exponent.
  const double depth =
      stop.force().depth_storing(0.5 * speed * speed / body.stops[0].row.squaredNorm());
  options.duration = 100.0 * depth / speed;
  simulate(body, {Vector::Zero(1), Vector::Constant(1, speed / stop.row.norm())}, options,
           listeners);
  return restitution;
}

// The system under one harmonic of its forces, that of the common period, with the part of each
// mode's force that is in phase with what acts at a stop: all of it, where one mode moves there.
// Returns by how much the phase of that is ahead, rad.
double keep_first_harmonic(const Vector& row, System& system) {
  HarmonicForcing& forcing = *system.modal().forcing;
  ComplexVector force = forcing.amplitude.cast<Complex>();
  for (const Harmonic& one : forcing.harmonics)
    if (one.order == 1.0) force += one.force();
  forcing.harmonics.clear();
  system.modal().carried.clear();
  const Complex acting = row.cast<Complex>().dot(force);
  const double ahead = std::arg(acting);
  forcing.amplitude = (force * std::polar(1.0, -ahead)).real();
  return ahead;
}

}  // namespace

std::optional<State> period_end_after(const System& system, const ImpactPoint& impact, int stop,
                                      const SegmentOptions& segment) {
  const double local =
      wrapped(impact.theta - system.forcing()->phase) / system.forcing()->frequency;
  if (!(local < system.period())) return {};
  MotionState<double> before =
      Motion<double>(system, {0, local}, impact.before.q, impact.before.qdot).state();
  // Rounding may have left the state beyond the surface.
  before.contacts[static_cast<std::size_t>(stop)] = Contact::kTouching;
  const TrajectorySegment passed = pass(system, before, {1, 0.0}, segment);
  if (!passed.failure.empty()) return {};
  return State{passed.end.q, passed.end.qdot};
}

std::vector<State> closed_form_contacts(const System& system, int period,
                                        const SegmentOptions& segment) {
  std::vector<State> starts;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    // The two solutions have different speeds.
    const bool gives_way = stop.is_compliant();
    for (std::size_t which = 0; which < 2 && (gives_way || !system.has_modal_flights()); ++which) {
      if (segment.stop.requested()) return starts;
      double speed = motion_scale(system).speed;
      std::optional<ImpactPoint> point;
      for (int round = 0; round < kRounds && speed > 0.0; ++round) {
        System rigid = system;
        rigid.modal().coupling.reset();
        const double ahead = rigid.harmonics() ? keep_first_harmonic(stop.row, rigid) : 0.0;
        if (gives_way)
          rigid.stops[i].law =
              ImpactLaw{momentum_direction(stop.row), Restitution{restitution_of(stop, speed)}};
        const ClosedFormAnswer answer = closed_form(rigid, static_cast<int>(i), period);
        if (!answer.form) break;
        const std::vector<ImpactPoint> points = answer.form->solutions(stop.gap);
        if (which >= points.size()) break;
        point = points[which];
        point->theta -= ahead;
        speed = stop.row.dot(point->before.qdot);
        if (!gives_way) break;
      }
      if (!point || !(speed > 0.0)) continue;
      if (const auto start = period_end_after(system, *point, static_cast<int>(i), segment))
        starts.push_back(*start);
    }
  }
  return starts;
}

std::vector<State> rough_contacts(const System& system, int stop, int period, int count,
                                  double speed, std::uint64_t seed, const SegmentOptions& segment) {
  std::vector<State> starts;
  for (const std::vector<ImpactPoint>& guess :
       rough_guesses(system, {period, {stop}}, count, speed, seed)) {
    if (segment.stop.requested()) break;
    if (const auto start = period_end_after(system, guess.front(), stop, segment))
      starts.push_back(*start);
  }
  return starts;
}

}  // namespace graze
