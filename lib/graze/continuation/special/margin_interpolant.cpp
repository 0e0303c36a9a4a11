#include "graze/continuation/special/detail/margin_interpolant.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

// The size of a cubic's error, relative to its deviation from the chord.
constexpr double kError = 0.25;

// Part of a change, or of the rates, by which the change may differ from the mean of the rates.
constexpr double kShown = 0.25;

using Cubic = std::array<double, 4>;

double value(const Cubic& c, double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

void keep_inside(double s, double from, double to, std::vector<double>& list) {
  if (s > from && s < to) list.push_back(s);
}

// Where its derivative vanishes within (from, to), in order.
std::vector<double> extrema(const Cubic& c, double from, double to) {
  std::vector<double> list;
  const double a = 3.0 * c[3], b = c[2];  // c1 + 2 b s + a s^2
  const double discriminant = b * b - a * c[1];
  if (!(discriminant > 0.0)) return list;
  // Without cancellation, and for a = 0 too.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q != 0.0) keep_inside(c[1] / q, from, to, list);
  if (a != 0.0) keep_inside(q / a, from, to, list);
  std::sort(list.begin(), list.end());
  return list;
}

// Zeros within (from, to), to some 1e-9 of the piece: only places to search at.
std::vector<double> zeros(const Cubic& c, double from, double to) {
  std::vector<double> ends = extrema(c, from, to), list;
  ends.insert(ends.begin(), from);
  ends.push_back(to);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double low = ends[i], high = ends[i + 1];
    const bool sign = value(c, low) > 0.0;
    if (sign == (value(c, high) > 0.0)) continue;
    for (int halving = 0; halving < 30; ++halving) {
      const double middle = 0.5 * (low + high);
      ((value(c, middle) > 0.0) == sign ? low : high) = middle;
    }
    list.push_back(0.5 * (low + high));
  }
  return list;
}

struct Smallest {
  double value = std::numeric_limits<double>::infinity();
  const MarginInterpolant* interpolant = nullptr;
};

Smallest smallest_at(const std::vector<MarginInterpolant>& interpolants, double s) {
  Smallest smallest;
  for (const MarginInterpolant& interpolant : interpolants) {
    if (s < interpolant.from || s > interpolant.to) continue;
    const double here = interpolant.at(s);
    if (here < smallest.value) smallest = {here, &interpolant};
  }
  return smallest;
}

// A stretch on which the smallest quantity keeps its sign, and where it is farthest from zero.
struct Run {
  bool positive = false;
  double depth = 0.0, place = 0.0;
  bool known = false;  // farther from zero than rounding
};

std::vector<Run> runs_of(const std::vector<MarginInterpolant>& interpolants) {
  std::vector<double> breaks = {0.0, 1.0};
  for (const MarginInterpolant& interpolant : interpolants) {
    breaks.push_back(interpolant.from);
    breaks.push_back(interpolant.to);
    for (const double s : extrema(interpolant.coefficients, interpolant.from, interpolant.to))
      breaks.push_back(s);
    for (const double s : zeros(interpolant.coefficients, interpolant.from, interpolant.to))
      breaks.push_back(s);
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<Run> runs;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (!(breaks[i + 1] > breaks[i])) continue;
    const double middle = 0.5 * (breaks[i] + breaks[i + 1]);
    const Smallest inside = smallest_at(interpolants, middle);
    const bool positive = inside.value > 0.0;
    if (runs.empty() || runs.back().positive != positive) runs.push_back({positive, 0.0, middle});
    for (const double s : {breaks[i], middle, breaks[i + 1]}) {
      const Smallest here = smallest_at(interpolants, s);
      if (!here.interpolant || (here.value > 0.0) != positive || s <= 0.0 || s >= 1.0) continue;
      if (std::abs(here.value) < runs.back().depth) continue;
      runs.back().depth = std::abs(here.value);
      runs.back().place = s;
      runs.back().known = std::abs(here.value) > here.interpolant->rounding;
    }
  }
  return runs;
}

// Whether the smallest quantity may reach zero next to one of its extrema.
bool may_reach_zero(const std::vector<MarginInterpolant>& interpolants,
                    const MarginInterpolant& interpolant, double s, double more_error = 0.0) {
  const Smallest smallest = smallest_at(interpolants, s);
  const double size = std::abs(interpolant.at(s));
  // Only the smallest quantity matters.
  if (smallest.value < interpolant.at(s) - interpolant.error(s)) return false;
  return size > interpolant.rounding && size <= interpolant.error(s) + more_error;
}

}  // namespace

MarginInterpolant MarginInterpolant::between(double start, double start_rate, double end,
                                             double end_rate) {
  MarginInterpolant interpolant;
  const double rise = end - start;
  interpolant.coefficients = {start, start_rate, 3.0 * rise - 2.0 * start_rate - end_rate,
                              start_rate + end_rate - 2.0 * rise};
  for (const double s : {0.25, 0.5, 0.75})
    interpolant.bend = std::max(interpolant.bend, std::abs(interpolant.at(s) - start - s * rise));
  return interpolant;
}

MarginInterpolant MarginInterpolant::from_start(double start, double rate) {
  MarginInterpolant interpolant;
  interpolant.coefficients = {start, rate, 0.0, 0.0};
  interpolant.to = 0.5;
  interpolant.bend = std::abs(rate);
  return interpolant;
}

MarginInterpolant MarginInterpolant::to_end(double end, double rate) {
  MarginInterpolant interpolant;
  interpolant.coefficients = {end - rate, rate, 0.0, 0.0};
  interpolant.from = 0.5;
  interpolant.bend = std::abs(rate);
  return interpolant;
}

double MarginInterpolant::at(double s) const { return value(coefficients, s); }

double MarginInterpolant::error(double s) const {
  const double shape = 4.0 * s * (1.0 - s);  // 1 in the middle
  return kError * bend * shape * shape;
}

bool is_shown(const std::vector<MarginInterpolant>& interpolants) {
  return std::all_of(
      interpolants.begin(), interpolants.end(), [](const MarginInterpolant& interpolant) {
        const auto& c = interpolant.coefficients;
        const double change = c[1] + c[2] + c[3], end_rate = c[1] + 2.0 * c[2] + 3.0 * c[3];
        const double size = std::max({std::abs(change), std::abs(c[1]), std::abs(end_rate)});
        const double missed = 0.5 * std::abs(c[3]);  // rate at both ends less twice the change
        return size <= interpolant.rounding || missed <= kShown * size;
      });
}

bool all_positive(const std::vector<MarginInterpolant>& interpolants, double s) {
  return smallest_at(interpolants, s).value > 0.0;
}

std::optional<double> suspected_sign_change(const std::vector<MarginInterpolant>& interpolants) {
  const std::vector<Run> runs = runs_of(interpolants);
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    if (runs[i].known) return runs[i].place;
  for (const MarginInterpolant& interpolant : interpolants) {
    for (const double s : extrema(interpolant.coefficients, interpolant.from, interpolant.to)) {
      // Minima where positive, maxima where negative: those that come nearest to zero.
      const double curvature =
          2.0 * interpolant.coefficients[2] + 6.0 * interpolant.coefficients[3] * s;
      if (curvature * interpolant.at(s) > 0.0 && may_reach_zero(interpolants, interpolant, s))
        return s;
    }
    // Where a growing quantity meets a falling one, the smaller of both is largest.
    for (const MarginInterpolant& other : interpolants) {
      if (&other <= &interpolant) continue;
      Cubic difference;
      for (std::size_t k = 0; k < 4; ++k)
        difference[k] = interpolant.coefficients[k] - other.coefficients[k];
      for (const double s : zeros(difference, std::max(interpolant.from, other.from),
                                  std::min(interpolant.to, other.to)))
        if (interpolant.at(s) < 0.0 && may_reach_zero(interpolants, interpolant, s, other.error(s)))
          return s;
    }
  }
  return {};
}

}  // namespace graze
