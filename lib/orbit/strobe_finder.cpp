#include "graze/orbit/strobe_finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/contact/impulse.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/followed_orbit.hpp"
#include "graze/orbit/orbit_identity.hpp"
#include "graze/orbit/rough_guess.hpp"
#include "graze/orbit/settled.hpp"

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

class StrobeFinder {
 public:
  StrobeFinder(const System& system, const std::optional<State>& start,
               const FinderOptions& options)
      : system_(system), start_(start), options_(options), scale_(motion_scale(system)) {
    strobe_.max_impacts = options.max_impacts;
    strobe_.stop = options.stop;
    const State at_rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
    strobe_.closure_speed =
        options.closure_speed.value_or(default_closure_speed(system, start.value_or(at_rest)));
  }

  FoundOrbits find() {
    if (options_.from_closed_form && options_.impacts.value_or(1) == 1) from_closed_form();
    if (options_.from_simulation && start_) from_simulation();
    if (options_.from_random) from_random();
    std::sort(found_.orbits.begin(), found_.orbits.end(), comes_before);
    return std::move(found_);
  }

 private:
  double speed_scale() const { return scale_.speed; }

  void from_closed_form() {
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const Stop& stop = system_.stops[i];
      if (!stop.is_compliant()) continue;
      if (options_.stop.requested()) return;
      // The two solutions have speeds of their own.
      for (std::size_t which = 0; which < 2; ++which) {
        double speed = speed_scale();
        std::optional<ImpactPoint> point;
        for (int round = 0; round < kRounds && speed > 0.0; ++round) {
          System rigid = system_;
          rigid.stops[i].law =
              ImpactLaw{momentum_direction(stop.row), Restitution{restitution_of(stop, speed)}};
          const ClosedFormAnswer answer = closed_form(rigid, static_cast<int>(i), options_.period);
          if (!answer.form) break;
          const std::vector<ImpactPoint> points = answer.form->solutions(stop.gap);
          if (which >= points.size()) break;
          point = points[which];
          speed = stop.row.dot(point->before.qdot);
        }
        if (point && speed > 0.0) start_from(*point, static_cast<int>(i), found_.closed_form);
      }
    }
  }

  // From just before an impact, through its contact to the end of the forcing period.
  void start_from(const ImpactPoint& point, int stop, StartCount& count) {
    const double local =
        wrapped(point.theta - system_.forcing()->phase) / system_.forcing()->frequency;
    if (!(local < system_.period())) return;
    MotionState<double> before =
        Motion<double>(system_, {0, local}, point.before.q, point.before.qdot).state();
    // Rounding may have left it beyond the surface.
    before.contacts[static_cast<std::size_t>(stop)] = Contact::kTouching;
    const Passage passage = pass(system_, before, {1, 0.0}, strobe_);
    if (!passage.failure.empty()) return;
    seek({passage.end.q, passage.end.qdot}, options_.period, count);
  }

  std::optional<Orbit> seek(const State& at_period_start, int period, StartCount& count) {
    ++count.tried;
    FollowedAnswer answer = followed_orbit(system_, at_period_start, period, strobe_);
    if (!answer.orbit) {
      why_not_ = answer.why_not;
      return {};
    }
    ++count.converged;
    const bool any_number = options_.sticking && answer.orbit->sticks();
    if (any_number ? answer.orbit->period == options_.period
                   : options_.asks_for(answer.orbit->period, answer.orbit->impacts.size()))
      keep(*answer.orbit);
    return answer.orbit;
  }

  void keep(const Orbit& orbit) {
    for (const Orbit& known : found_.orbits)
      if (same_orbit(known, orbit, speed_scale())) return;
    found_.orbits.push_back(orbit);
  }

  void from_simulation() {
    found_.simulated = true;
    SettleOptions settling;
    settling.max_impacts = options_.max_impacts;
    settling.stop = options_.stop;
    settling.closure_speed = options_.closure_speed;
    const SettledMotion settled = settle(system_, *start_, settling);
    if (settled.kind != SettledKind::kImpacts && settled.kind != SettledKind::kSticks) {
      found_.notes.push_back(settled.verdict);
      return;
    }
    const std::optional<Orbit> orbit = seek(settled.at_start, settled.period, found_.simulation);
    found_.notes.push_back(
        orbit ? fmt::format("from the scene's initial state the motion settles on a ({}, {}) orbit",
                            orbit->period, orbit->impacts.size())
              : settled.verdict + ", but " + why_not_);
  }

  void from_random() {
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const int stop = static_cast<int>(i);
      ++found_.patterns;
      // A map with its derivatives costs as N^3.
      const int modes = system_.modes();
      const int guesses = std::min(options_.random_guesses, std::max(4, 64 / (modes * modes)));
      for (const std::vector<ImpactPoint>& guess : rough_guesses(
               system_, {options_.period, {stop}}, guesses, speed_scale(), options_.random_seed)) {
        if (options_.stop.requested()) return;
        start_from(guess.front(), stop, found_.random);
      }
    }
  }

  const System& system_;
  const std::optional<State>& start_;
  const FinderOptions& options_;
  MotionScale scale_;
  PassageOptions strobe_;
  std::string why_not_;
  FoundOrbits found_;
};

}  // namespace

FoundOrbits find_strobe_orbits(const System& system, const std::optional<State>& start,
                               const FinderOptions& options) {
  FoundOrbits found = StrobeFinder(system, start, options).find();
  found.tried =
      fmt::format("{} rigid orbits, {} simulation, {} rough guesses", found.closed_form.tried,
                  found.simulated ? "the" : "no", found.random.tried);
  return found;
}

}  // namespace graze
