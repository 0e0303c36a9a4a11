#include "graze/orbit/finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "graze/base/angle.hpp"
#include "graze/flow/exact_flow.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/repetition.hpp"
#include "graze/orbit/settled.hpp"
#include "graze/orbit/solve.hpp"
#include "graze/orbit/sticking_orbit.hpp"

namespace graze {
namespace {

// Solutions are accurate to about the square root of eps even next to a fold, where they are least
// well determined; nearer than this two of them cannot be told apart.
constexpr double kSame = 1e-7;

double phase_distance(double a, double b) { return std::abs(std::remainder(a - b, kTurn)); }

// The pattern that an orbit repeats within itself, when it is not minimal.
std::optional<ImpactPattern> shorter_pattern(const Orbit& orbit) {
  const int k = static_cast<int>(orbit.impacts.size());
  double largest = 0.0;
  for (const OrbitImpact& impact : orbit.impacts) largest = std::max(largest, impact.speed);
  for (int parts = k; parts > 1; --parts) {
    if (k % parts != 0 || orbit.period % parts != 0) continue;
    const int p = orbit.period / parts, n = k / parts;
    bool repeats = true;
    for (int i = n; i < k && repeats; ++i) {
      const OrbitImpact& a = orbit.impacts[static_cast<std::size_t>(i - n)];
      const OrbitImpact& b = orbit.impacts[static_cast<std::size_t>(i)];
      repeats = a.stop == b.stop && phase_distance(a.phase, b.phase) <= kSame &&
                std::abs(a.speed - b.speed) <= kSame * largest;
    }
    if (!repeats) continue;
    ImpactPattern pattern{p, orbit.pattern().stops};
    pattern.stops.resize(static_cast<std::size_t>(n));
    return pattern;
  }
  return {};
}

class Finder {
 public:
  Finder(const System& system, const std::optional<State>& start, const FinderOptions& options)
      : system_(system), start_(start), options_(options), scale_(shooting_scale(system)) {}

  FoundOrbits find() {
    const bool one_impact = !options_.impacts || *options_.impacts == 1;
    if (options_.from_closed_form && one_impact) from_closed_form();
    if (options_.from_simulation && start_) from_simulation();
    if (options_.from_random && one_impact) from_random();
    return conclude();
  }

 private:
  void from_closed_form() {
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const ClosedFormAnswer answer = closed_form(system_, static_cast<int>(i), options_.period);
      if (!answer.form) {
        found_.notes.push_back("the closed form does not hold: " + answer.why_not);
        continue;
      }
      const ShootingProblem problem({options_.period, {static_cast<int>(i)}}, scale_);
      for (const ImpactPoint& point : answer.form->solutions(system_.stops[i].gap))
        keep(problem, newton(problem, system_, problem.pack({point})), found_.closed_form);
    }
  }

  void from_simulation() {
    found_.simulated = true;
    SettleOptions settle_options;
    settle_options.max_impacts = options_.max_impacts;
    settle_options.stop = options_.stop;
    const SettledMotion settled = settle(system_, *start_, settle_options);
    if (!settled.pattern) {
      found_.notes.push_back(settled.verdict + (settled.sticks ? from_sticking() : ""));
      return;
    }
    const ShootingProblem problem(*settled.pattern, scale_);
    const auto solution = newton(problem, system_, problem.pack(settled.points));
    const std::optional<Orbit> orbit = judge(problem, solution, found_.simulation);
    if (!orbit) {
      found_.notes.push_back(settled.verdict + ", but no orbit was confirmed there");
      return;
    }
    const int k = static_cast<int>(orbit->impacts.size());
    found_.notes.push_back(fmt::format(
        "from the scene's initial state the motion settles on a ({}, {}) orbit", orbit->period, k));
    if (!options_.impacts || (k == *options_.impacts && orbit->period == options_.period))
      keep(*orbit);
  }

  // What becomes of a motion that comes to rest on a stop: the rest of a sentence.
  std::string from_sticking() {
    RepetitionOptions simulated;
    simulated.closure_speed = options_.closure_speed.value_or(
        default_closure_speed(system_, *start_, kDefaultClosureTolerance));
    simulated.max_impacts = options_.max_impacts;
    simulated.stop = options_.stop;
    const Repetition repetition = find_repetition(system_, *start_, simulated);
    if (repetition.period == 0) return "; " + repetition.why_not;
    if (!repetition.sticks)
      return fmt::format("; what it settles on, with period {}, does not stick", repetition.period);
    ++found_.simulation.tried;
    const StickingOrbitAnswer answer =
        sticking_orbit(system_, repetition.at_start, repetition.period,
                       {simulated.closure_speed, options_.max_impacts, options_.stop});
    if (!answer.orbit) return "; " + answer.why_not;
    ++found_.simulation.converged;
    const Orbit& orbit = *answer.orbit;
    const int k = static_cast<int>(orbit.impacts.size());
    if (!options_.impacts || (k == *options_.impacts && orbit.period == options_.period))
      keep(orbit);
    return fmt::format(
        "; it settles on a ({}, {}) orbit that sticks, its chatters summed below {:.4g} m/s",
        orbit.period, k, simulated.closure_speed);
  }

  void from_random() {
    std::mt19937_64 engine(options_.random_seed);
    // Bits to [0, 1) by hand: the standard leaves the distributions' algorithms open, and results
    // shall not depend on the library.
    const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    // A least-squares solve grows as N^3: many modes get fewer guesses, but never less than four.
    const int guesses = std::min(options_.random_guesses, std::max(4, 128 / system_.modes()));
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const ShootingProblem problem({options_.period, {static_cast<int>(i)}}, scale_);
      for (int guess = 0; guess < guesses; ++guess) {
        if (options_.stop.requested()) return;
        const double theta = kTurn * uniform();
        const double speed = 2.0 * uniform() * scale_.length * system_.forcing->frequency;
        keep(problem,
             seek(problem, system_,
                  problem.pack({rough_guess(system_, static_cast<int>(i), theta, speed)})),
             found_.random);
      }
    }
  }

  // The minimal orbit of a solution; nothing where there is none.
  std::optional<Orbit> judge(const ShootingProblem& problem,
                             const std::optional<ShootingSolution>& solution, StartCount& count) {
    ++count.tried;
    if (!solution) return {};
    ++count.converged;
    Orbit orbit = make_orbit(system_, problem, solution->x);
    const std::optional<ImpactPattern> shorter = shorter_pattern(orbit);
    if (!shorter) return orbit;
    const ShootingProblem part(*shorter, scale_);
    std::vector<ImpactPoint> points = orbit.points();
    points.resize(shorter->stops.size());
    const auto minimal = newton(part, system_, part.pack(points));
    if (!minimal) return {};
    return make_orbit(system_, part, minimal->x);
  }

  void keep(const ShootingProblem& problem, const std::optional<ShootingSolution>& solution,
            StartCount& count) {
    if (const std::optional<Orbit> orbit = judge(problem, solution, count)) keep(*orbit);
  }

  void keep(const Orbit& orbit) {
    for (Orbit& known : found_.orbits)
      if (same_orbit(known, orbit, scale_.length * system_.forcing->frequency)) {
        if (orbit.residual < known.residual) known = orbit;
        return;
      }
    found_.orbits.push_back(orbit);
  }

  FoundOrbits conclude() {
    std::vector<Orbit>& orbits = found_.orbits;
    if (!options_.keep_virtual) {
      const auto is_virtual = [](const Orbit& orbit) { return !orbit.admissible; };
      found_.inadmissible =
          static_cast<int>(std::count_if(orbits.begin(), orbits.end(), is_virtual));
      orbits.erase(std::remove_if(orbits.begin(), orbits.end(), is_virtual), orbits.end());
    }
    std::sort(orbits.begin(), orbits.end(), [](const Orbit& a, const Orbit& b) {
      if (a.period != b.period) return a.period < b.period;
      if (a.impacts.size() != b.impacts.size()) return a.impacts.size() < b.impacts.size();
      return a.impacts.front().phase < b.impacts.front().phase;
    });
    return std::move(found_);
  }

  const System& system_;
  const std::optional<State>& start_;
  const FinderOptions& options_;
  ShootingScale scale_;
  FoundOrbits found_;
};

}  // namespace

bool same_orbit(const Orbit& a, const Orbit& b, double speed_scale) {
  if (a.period != b.period || a.impacts.size() != b.impacts.size() ||
      a.sticking.has_value() != b.sticking.has_value())
    return false;
  double largest = speed_scale;
  for (const OrbitImpact& impact : a.impacts) largest = std::max(largest, std::abs(impact.speed));
  // Two impacts of nearly one phase may have been ordered either way: try every rotation.
  for (std::size_t turn = 0; turn < b.impacts.size(); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < a.impacts.size() && same; ++i) {
      const OrbitImpact& x = a.impacts[i];
      const OrbitImpact& y = b.impacts[(i + turn) % b.impacts.size()];
      same = x.stop == y.stop && phase_distance(x.phase, y.phase) <= kSame &&
             std::abs(x.speed - y.speed) <= kSame * largest;
    }
    if (same) return true;
  }
  return false;
}

ImpactPoint rough_guess(const System& system, int stop_index, double theta, double speed) {
  const RigidStop& stop = system.stops[static_cast<std::size_t>(stop_index)];
  const ExactFlow<double> flow(system);
  const Eigen::Index n = system.modes();
  const double frequency = flow.frequency();
  Vector q(n), qdot(n), push(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    q[j] = mode.forced.re * std::cos(theta) - mode.forced.im * std::sin(theta);
    qdot[j] = -frequency * (mode.forced.re * std::sin(theta) + mode.forced.im * std::cos(theta));
    // A free mass has no static compliance; the forcing's time scale stands in for it.
    push[j] = stop.row[j] / std::max(mode.omega * mode.omega, 1e-2 * frequency * frequency);
  }
  push /= stop.row.dot(push);
  q += (stop.gap - stop.row.dot(q)) * push;
  qdot += (speed - stop.row.dot(qdot)) * push;
  return {theta, {q, qdot}};
}

FoundOrbits find_orbits(const System& system, const std::optional<State>& start,
                        const FinderOptions& options) {
  return Finder(system, start, options).find();
}

}  // namespace graze
