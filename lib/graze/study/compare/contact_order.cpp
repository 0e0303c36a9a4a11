#include "graze/study/compare/contact_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "graze/motion/simulation.hpp"
#include "graze/study/processor_time.hpp"

namespace graze {
namespace {

// Numbers of steps in a contact: from a number that resolves it with any method, doubled.
constexpr int kFewestSteps = 8, kDoublings = 9;
// The slope is taken where the leading term is the error: from this number of steps on, and above
// the accumulated rounding.
constexpr int kFewestForSlope = 32;
constexpr double kRounding = 3e-12;
// Computing time for a row, s.
constexpr double kEnough = 0.01;

struct BodyState {
  double depth = 0.0, rate = 0.0;  // m, m/s
};

// The textbook method, without error control.
BodyState runge_kutta_step(const ElasticContact& contact, const BodyState& at, double h) {
  const auto slope = [&](const BodyState& s) {
    const double force =
        s.depth > 0.0 ? contact.stiffness * std::pow(s.depth, contact.exponent) : 0.0;
    return BodyState{s.rate, -force / contact.mass};
  };
  const auto moved = [&](const BodyState& by, double part) {
    return BodyState{at.depth + part * by.depth, at.rate + part * by.rate};
  };
  const BodyState a = slope(at), b = slope(moved(a, 0.5 * h)), c = slope(moved(b, 0.5 * h)),
                  d = slope(moved(c, h));
  return {at.depth + h / 6.0 * (a.depth + 2.0 * b.depth + 2.0 * c.depth + d.depth),
          at.rate + h / 6.0 * (a.rate + 2.0 * b.rate + 2.0 * c.rate + d.rate)};
}

// The contact lasts `steps` steps and a part of one, and begins after a part of a step: both parts
// are spread evenly.
struct Place {
  double step = 0.0, lead = 0.0;  // s
};
Place place(const ElasticContact& contact, int steps, int i) {
  const double end = (i + 0.5) / kContactPlaces;
  const double begin = ((7 * i) % kContactPlaces + 0.5) / kContactPlaces;
  const double step = contact.duration() / (steps + end);
  return {step, begin * step};
}

std::string spring_name(double exponent) {
  if (exponent == 1.0) return "linear";
  if (exponent == 1.5) return "Hertz";
  return fmt::format("n = {:g}", exponent);
}

// Least squares of log(error) over log(step).
double slope_of(const std::vector<ContactOrderRow>& rows) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const ContactOrderRow& row : rows) {
    if (row.steps < kFewestForSlope || !(row.error > kRounding)) continue;
    const double a = std::log(row.step), b = std::log(row.error);
    n += 1.0, x += a, y += b, xx += a * a, xy += a * b;
  }
  return n > 1.0 ? (n * xy - x * y) / (n * xx - x * x) : 0.0;
}

template <class Cross>
ContactOrder ladder(const ElasticContact& contact, const char* method, const StopSignal& stop,
                    const Cross& cross) {
  ContactOrder line{contact, spring_name(contact.exponent), method, 0.0, {}};
  int steps = kFewestSteps;
  for (int k = 0; k <= kDoublings && !stop.requested(); ++k, steps *= 2) {
    ContactOrderRow row;
    row.steps = steps;
    row.step = contact.duration() / steps;
    for (int i = 0; i < kContactPlaces; ++i)
      row.error = std::max(row.error, crossing_error(contact, cross(place(contact, steps, i))));
    const Place middle = place(contact, steps, kContactPlaces / 2);
    row.evaluations = static_cast<double>(cross(middle).evaluations);
    row.seconds = least_time([&] { cross(middle); }, kEnough, stop);
    line.rows.push_back(row);
  }
  line.order = slope_of(line.rows);
  return line;
}

ContactOrder exact_line(const ElasticContact& contact, const StopSignal& stop) {
  ContactOrder line{contact, spring_name(contact.exponent), "exact", 0.0, {}};
  const ContactCrossing crossing = cross_with_location(contact, 0.0);
  ContactOrderRow row;
  row.error = crossing_error(contact, crossing);
  row.evaluations = static_cast<double>(crossing.evaluations);
  row.seconds = least_time([&] { cross_with_location(contact, 0.0); }, kEnough, stop);
  line.rows.push_back(row);
  return line;
}

}  // namespace

double ElasticContact::depth() const {
  const double n = exponent + 1.0;
  return std::pow(0.5 * n * mass * speed * speed / stiffness, 1.0 / n);
}

double ElasticContact::duration() const {
  const double part = 1.0 / (exponent + 1.0);
  return 2.0 * std::sqrt(std::numbers::pi) * part * std::tgamma(part) / std::tgamma(part + 0.5) *
         depth() / speed;
}

ContactCrossing cross_without_location(const ElasticContact& contact, double step, double lead) {
  BodyState at{-lead * contact.speed, contact.speed};
  ContactCrossing crossing;
  // A contact that returns a tenth of its speed ends long before this.
  const auto most = static_cast<long long>(std::ceil((20.0 * contact.duration() + lead) / step));
  for (long long i = 1; i <= most; ++i) {
    at = runge_kutta_step(contact, at, step);
    crossing.evaluations += 4;
    if (!(at.depth < 0.0 && at.rate < 0.0)) continue;
    crossing.ended = true;
    crossing.speed = -at.rate;
    crossing.duration = static_cast<double>(i) * step - lead - at.depth / at.rate;
    break;
  }
  return crossing;
}

ContactCrossing cross_with_location(const ElasticContact& contact, double step) {
  const Vector row = Vector::Constant(1, 1.0 / std::sqrt(contact.mass));
  System system{Vector::Zero(1), NaturalModes{Vector::Zero(1)}, {}};
  ContactForce law;
  law.stiffness = contact.stiffness;
  law.exponent = contact.exponent;
  system.stops.push_back({row, 0.0, law});
  const State start{Vector::Zero(1), Vector::Constant(1, std::sqrt(contact.mass) * contact.speed)};
  SimulationOptions options;
  options.duration = 1.01 * contact.duration() + 2.0 * step;
  options.closure_speed = 0.0;
  if (step > 0.0) {
    options.steps.emplace();
    options.steps->step = step;
    options.steps->speed = start.qdot.norm();
    options.steps->longest = std::numeric_limits<double>::infinity();
  }
  ContactCrossing crossing;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind != EventKind::kSeparation) return;
    crossing.ended = true;
    crossing.duration = event.duration;
    crossing.speed = event.speed;
  };
  crossing.evaluations = simulate(system, start, options, listeners).evaluations;
  return crossing;
}

double crossing_error(const ElasticContact& contact, const ContactCrossing& crossing) {
  if (!crossing.ended) return 1.0;
  return std::max(std::abs(crossing.speed / contact.speed - 1.0),
                  std::abs(crossing.duration / contact.duration() - 1.0));
}

std::vector<ContactOrder> contact_orders(const ElasticContact& contact, const StopSignal& stop) {
  std::vector<ContactOrder> lines;
  for (const double n : std::set<double>{1.0, 1.5, contact.exponent}) {
    ElasticContact other = contact;
    if (n != contact.exponent) {
      other.exponent = n;
      other.stiffness = 0.5 * (n + 1.0) * contact.mass * contact.speed * contact.speed /
                        std::pow(contact.depth(), n + 1.0);
    }
    lines.push_back(ladder(other, "rk4, located", stop,
                           [&](const Place& at) { return cross_with_location(other, at.step); }));
    lines.push_back(ladder(other, "rk4, not located", stop, [&](const Place& at) {
      return cross_without_location(other, at.step, at.lead);
    }));
    lines.push_back(exact_line(other, stop));
  }
  return lines;
}

FirstContact first_contact(const System& system, const State& start, double longest,
                           const StopSignal& stop) {
  FirstContact first;
  SimulationOptions options;
  options.duration = longest;
  options.stop = stop;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind != EventKind::kContact || first.stop >= 0 || !(event.speed > 0.0)) return;
    first.stop = event.stop;
    const Stop& met = system.stops[static_cast<std::size_t>(event.stop)];
    first.contact = {1.0 / met.row.squaredNorm(), event.speed, met.force().stiffness,
                     met.force().exponent};
  };
  simulate(system, start, options, listeners);
  if (first.stop < 0) first.message = "no contact with a compliant stop begins in that time";
  return first;
}

}  // namespace graze
