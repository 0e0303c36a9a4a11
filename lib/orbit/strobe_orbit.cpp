#include "graze/orbit/strobe_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/product_eigenvalues.hpp"
#include "graze/orbit/orbit_clock.hpp"
#include "graze/orbit/polish.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {
namespace {

// The equations f(x_i) - x_{i+1} = 0 at u.
struct Equations {
  Vector residual;
  Matrix jacobian;             // of the residual
  std::vector<Matrix> slopes;  // of the map, at x_1, .., x_p
};

std::optional<Equations> equations_at(const System& system, const StrobeMap& map, const Vector& u) {
  const Eigen::Index n = map.size();
  Equations equations{Vector(u.size()), Matrix::Zero(u.size(), u.size()), {}};
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    const Eigen::Index next = (i + n) % u.size();
    const std::optional<StrobeMap::Image> image = map.image(system, u.segment(i, n));
    if (!image) return {};
    equations.residual.segment(i, n) = image->image - u.segment(next, n);
    equations.jacobian.block(i, i, n, n) += image->jacobian;
    equations.jacobian.block(i, next, n, n) -= Matrix::Identity(n, n);
    equations.slopes.push_back(image->jacobian);
  }
  return equations;
}

std::optional<Polished<Equations>> newton(const System& system, const StrobeMap& map,
                                          const Vector& u) {
  return polish(u, [&](const Vector& at) { return equations_at(system, map, at); });
}

// The shortest part of a solution that repeats within it.
Vector shortest(const StrobeMap& map, const Vector& u) {
  const Eigen::Index n = map.size(), periods = u.size() / n;
  for (Eigen::Index p = 1; p < periods; ++p) {
    if (periods % p != 0) continue;
    const Eigen::Index rest = (periods - p) * n;
    if ((u.tail(rest) - u.head(rest)).norm() <= kShootingAccuracy * (1.0 + u.norm()))
      return u.head(p * n);
  }
  return u;
}

double seconds(const System& system, const Instant<double>& from, const Instant<double>& to) {
  return static_cast<double>(to.period - from.period) * system.period() + to.local - from.local;
}

double seconds(const System& system, const PassedContact& contact) {
  return seconds(system, contact.from, contact.to);
}

// A contact that lasts over the end of a turn goes on in the next one.
OrbitContact whole_contact(const System& system, const std::vector<Passage>& turns,
                           std::size_t turn, const PassedContact& first) {
  OrbitContact whole{seconds(system, first), first.speed_after, first.peak_force, first.taken};
  const PassedContact* part = &first;
  for (std::size_t i = 1; part->to_end && i <= turns.size(); ++i) {
    const Passage& next = turns[(turn + i) % turns.size()];
    const auto rest =
        std::find_if(next.contacts.begin(), next.contacts.end(),
                     [&](const PassedContact& c) { return c.from_start && c.stop == first.stop; });
    if (rest == next.contacts.end()) break;
    part = &*rest;
    whole.duration += seconds(system, *part);
    whole.speed_after = part->speed_after;
    whole.peak_force = std::max(whole.peak_force, part->peak_force);
    whole.taken += part->taken;
  }
  return whole;
}

// A touch, where an orbit has one.
struct MetTouch {
  StrobeTouch touch;
  Instant<double> at;  // counted within its turn
  State state;

  // One as long before or after it as it lasts at the most: the instant is known less well than the
  // depth.
  bool is(const System& system, std::size_t turn, const PassedContact& contact) const {
    if (turn != touch.turn || contact.stop != touch.stop || contact.speed > touch.slowest)
      return false;
    const double lasts = seconds(system, contact);
    const double since = seconds(system, contact.from, at);
    return since >= -lasts && since <= 2.0 * lasts;
  }
};

// In time order; tells where the first of the section's states lies.
std::vector<OrbitImpact> met_on(const System& system, const std::vector<Passage>& turns,
                                const std::optional<MetTouch>& touch, OrbitSection& section) {
  const auto at_turn = [](Instant<double> at, std::size_t turn) {
    at.period += static_cast<long long>(turn);
    return at;
  };
  std::vector<Instant<double>> instants;
  std::vector<OrbitImpact> met;
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    for (const PassedImpact& impact : turns[turn].impacts) {
      instants.push_back(at_turn(impact.at, turn));
      met.push_back({impact.stop, 0, 0.0, impact.speed, impact.before});
    }
    for (const PassedContact& contact : turns[turn].contacts) {
      if (contact.from_start || (touch && touch->is(system, turn, contact))) continue;
      instants.push_back(at_turn(contact.from, turn));
      met.push_back({contact.stop, 0, 0.0, contact.speed, contact.before,
                     whole_contact(system, turns, turn, contact)});
    }
  }
  if (touch) {
    instants.push_back(at_turn(touch->at, touch->touch.turn));
    met.push_back({touch->touch.stop, 0, 0.0, 0.0, touch->state, OrbitContact{}});
  }
  const OrbitClock clock(system, static_cast<int>(turns.size()), instants);
  section.at = clock(section.states.front().instant);
  for (std::size_t i = 0; i < met.size(); ++i) {
    const OrbitInstant at = clock(instants[i]);
    met[i].period_index = at.period_index;
    met[i].phase = at.phase;
  }
  std::stable_sort(met.begin(), met.end(), [](const OrbitImpact& a, const OrbitImpact& b) {
    return earlier({a.period_index, a.phase}, {b.period_index, b.phase});
  });
  return met;
}

// Where the forcing period that begins with x, or within the turn that does, starts: at the forcing
// phase 0, wherever the section of the map lies.
std::optional<MotionState<double>> start_of_turn(const System& system, const StrobeMap& map,
                                                 const Vector& x) {
  const double angle = wrapped(-map.section());
  if (angle == 0.0) return map.start_of(system, x);
  std::optional<StrobeMap::Within> within = map.within(system, x, angle, {});
  if (!within) return {};
  return std::move(within->at);
}

// With everything but what multipliers tell.
std::optional<Orbit> orbit_along(const System& system, const StrobeMap& map, const Vector& u,
                                 const std::optional<MetTouch>& touch, double residual) {
  const Eigen::Index n = map.size();
  Orbit orbit;
  orbit.period = static_cast<int>(u.size() / n);
  OrbitSection& section = orbit.section.emplace();
  section.closure_speed = map.options().closure_speed;
  std::vector<Passage> turns;
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    std::optional<Passage> turn = map.follow(system, u.segment(i, n), true);
    // An orbit that sticks besides has a map of lower rank, and is not one of these.
    if (!turn || !turn->holds.empty()) return {};
    const std::optional<double> clearance = turn->clearance();
    if (clearance && (!orbit.clearance || *clearance < *orbit.clearance))
      orbit.clearance = clearance;
    const std::optional<MotionState<double>> start = start_of_turn(system, map, u.segment(i, n));
    if (!start) return {};
    section.states.push_back(*start);
    turns.push_back(std::move(*turn));
  }
  orbit.impacts = met_on(system, turns, touch, section);
  orbit.admissible = true;
  orbit.residual = residual;
  return orbit;
}

StrobeAnswer solve_from(const System& system, const StrobeMap& map, const Vector& u) {
  auto solution = newton(system, map, u);
  if (!solution) return {{}, "Newton's method does not converge on the stroboscopic map"};
  const Vector least = shortest(map, solution->u);
  if (least.size() < u.size()) {
    solution = newton(system, map, least);
    if (!solution) return {{}, "Newton's method does not converge on the shorter period"};
  }
  StrobeAnswer answer;
  answer.orbit = orbit_of(system, map, solution->u, product_eigenvalues(solution->at.slopes),
                          solution->residual);
  if (!answer.orbit)
    answer.why_not =
        "the periodic motion meets no stop, never leaves one, or comes to rest on one that is "
        "rigid";
  return answer;
}

}  // namespace

std::optional<Orbit> orbit_of(const System& system, const StrobeMap& map, const Vector& u,
                              std::vector<Eigenvalue> multipliers, double residual) {
  std::optional<Orbit> orbit = orbit_along(system, map, u, {}, residual);
  // Contacts at speeds that are rounding are those of a structure that does not move.
  const double still = still_speed(system);
  if (!orbit || std::none_of(orbit->impacts.begin(), orbit->impacts.end(),
                             [&](const OrbitImpact& impact) { return impact.speed > still; }))
    return {};
  orbit->multipliers = std::move(multipliers);
  orbit->stable = stability(orbit->multipliers);
  return orbit;
}

std::optional<Orbit> touching_orbit_of(const System& system, const StrobeMap& map, const Vector& u,
                                       const StrobeTouch& touch, double residual) {
  const Eigen::Index n = map.size();
  const auto at =
      map.within(system, u.segment(static_cast<Eigen::Index>(touch.turn) * n, n), touch.angle, {});
  if (!at) return {};
  return orbit_along(system, map, u, MetTouch{touch, at->at.instant, at->state}, residual);
}

std::vector<StrobeTouch> touches_near(const System& system, const StrobeMap& map, const Vector& u) {
  const Eigen::Index n = map.size();
  const double length = motion_scale(system).length, frequency = system.forcing()->frequency;
  std::vector<std::pair<double, StrobeTouch>> offered;
  const auto offer = [&](double depth, int stop, std::size_t turn, double seconds) {
    offered.push_back({depth, {stop, turn, std::clamp(frequency * seconds, 0.0, kTurn), 0.0}});
  };
  for (Eigen::Index i = 0; i < u.size(); i += n) {
    const std::optional<Passage> turn = map.follow(system, u.segment(i, n), true);
    if (!turn) return {};
    const auto index = static_cast<std::size_t>(i / n);
    const auto since_start = [&](const Instant<double>& at) {
      return seconds(system, map.first_instant(system), at);
    };
    if (turn->lowest)
      offer(std::abs(turn->lowest->gap) / length, turn->lowest->stop, index,
            since_start(turn->lowest->at));
    for (const PassedContact& contact : turn->contacts) {
      if (contact.from_start) continue;
      const double part = contact.speed / (frequency * length);
      // The gap is least near its middle.
      offer(0.5 * part * part, contact.stop, index,
            since_start(contact.from) + 0.5 * seconds(system, contact));
    }
  }
  std::stable_sort(offered.begin(), offered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<StrobeTouch> touches;
  for (const auto& [depth, touch] : offered) touches.push_back(touch);
  return touches;
}

std::optional<StrobeTouch> nearest_touch(const System& system, const StrobeMap& map,
                                         const Vector& u) {
  const std::vector<StrobeTouch> touches = touches_near(system, map, u);
  if (touches.empty() ||
      !system.stops[static_cast<std::size_t>(touches.front().stop)].is_compliant())
    return {};
  return touches.front();
}

std::vector<State> turns_of(const Orbit& orbit) {
  std::vector<State> turns;
  for (const MotionState<double>& turn : orbit.section->states)
    turns.push_back({turn.q, turn.qdot});
  return turns;
}

StrobeAnswer strobe_orbit(const System& system, const std::vector<State>& turns,
                          const PassageOptions& options) {
  const StrobeMap map(system, options);
  return solve_from(system, map, map.pack(turns));
}

StrobeAnswer strobe_orbit(const System& system, const State& at_period_start, int period,
                          const PassageOptions& options) {
  const StrobeMap map(system, options);
  const Eigen::Index n = map.size();
  Vector u(period * n);
  const Passage to_section =
      pass(system, Motion<double>(system, {}, at_period_start.q, at_period_start.qdot).state(),
           map.first_instant(system), options);
  if (!to_section.failure.empty()) return {{}, to_section.failure};
  u.head(n) = map.pack({to_section.end.q, to_section.end.qdot});
  for (Eigen::Index i = n; i < u.size(); i += n) {
    const std::optional<Passage> turn = map.follow(system, u.segment(i - n, n));
    if (!turn) return {{}, "the motion cannot be followed"};
    u.segment(i, n) = map.pack({turn->end.q, turn->end.qdot});
  }
  return solve_from(system, map, u);
}

}  // namespace graze
