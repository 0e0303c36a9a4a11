#include "graze/orbit/closed_form/detail/two_impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/orbit/closed_form/detail/phase_problem.hpp"

namespace graze {
namespace {

// Intervals per period of the fastest mode: eight per period of twice its frequency.
constexpr double kIntervalsPerPeriod = 16.0;
constexpr double kMostIntervals = 1 << 15;

// Samples at which n and E vanish identically are shifted by this many intervals.
constexpr double kBeside = 1e-6;

// A minimum between samples lies below the smallest of them by an eighth of their second difference
// where that is constant; minima are examined up to four times that.
constexpr double kMostDrop = 0.5;

// Below the first part of their terms n and E are zero, to rounding; below the second a minimum of
// |n| - |E| may be a double zero.
constexpr double kZero = 1e-9, kDoubleZero = 1e-8;

double cross(const Complex& a, const Complex& b) { return (a * std::conj(b)).imag(); }

}  // namespace

// The functions of s on two stops, s in intervals.
class TwoImpacts::Pair {
 public:
  Pair(const TwoImpacts& of, int first, int second)
      : of_(of),
        response_(*of.response_),
        stops_{first, second},
        one_stop_(first == second),
        odd_(response_.period() % 2 != 0),
        last_(one_stop_ ? of.intervals_ / 2 : of.intervals_) {
    for (const std::size_t k : {0u, 1u}) {
      const Stop& stop = response_.system().stops[static_cast<std::size_t>(stops_[k])];
      const Stop& other = response_.system().stops[static_cast<std::size_t>(stops_[1 - k])];
      factor_[k] = 1.0 + stop.restitution().at(0.0);
      own_[k] = of.own_[static_cast<std::size_t>(stops_[k])];
      forced_[k] = response_.forced_along(stops_[k]);
      distance_[k] = stop.gap - response_.rest_along(stops_[k]);
      const Vector weights = stop.row.cwiseProduct(other.direction());
      value_[k] = of.displacements_ * weights;
      rate_[k] = of.velocities_ * weights;
    }
    mirrored_ = !one_stop_ && at_sample(middle()).vanish(distance_);
  }

  std::vector<Vector> solutions() const {
    std::array<std::vector<double>, 2> samples;
    for (int m = 0; m <= last_; ++m) {
      const Terms terms = is_own_zero(m) ? at(place(m)) : at_sample(m);
      samples[0].push_back(terms.function(1.0));
      samples[1].push_back(terms.function(-1.0));
    }
    std::vector<Vector> found;
    for (const std::size_t side : {0u, 1u}) add_zeros(samples[side], side == 0 ? 1.0 : -1.0, found);
    if (mirrored_) add_any(middle(), found);
    return found;
  }

 private:
  struct Terms {
    double determinant = 0.0;        // of 1 + H D
    std::array<Complex, 2> contact;  // C times that
    Complex n;
    double e = 0.0;
    // Zero where |n| = sign E.
    double function(double sign) const { return std::abs(n) - sign * e; }
    // Whether both contact equations are one, to rounding.
    bool vanish(const std::array<double, 2>& distance) const {
      const double first = std::abs(contact[0]), second = std::abs(contact[1]);
      return std::abs(n) <=
                 kZero * (std::abs(distance[1]) * first + std::abs(distance[0]) * second) &&
             std::abs(e * determinant) <= kZero * first * second;
    }
  };

  int middle() const { return of_.intervals_ / 2; }
  bool is_own_zero(int m) const {
    if (one_stop_) return m == 0 || (m == middle() && !odd_);
    return mirrored_ && m == middle();
  }
  double place(int m) const {
    if (!is_own_zero(m)) return m;
    return m == last_ ? m - kBeside : m + kBeside;
  }
  // The divisor of n and E, which vanishes where they vanish identically.
  double own_zeros(double psi) const {
    const double part = psi / response_.period();
    if (one_stop_) return odd_ ? std::sin(0.5 * part) : std::sin(part);
    return mirrored_ ? std::cos(0.5 * part) : 1.0;
  }

  // rad, from the first impact to the second
  double angle(double s) const { return kTurn * response_.period() * s / of_.intervals_; }

  Terms at_sample(int m) const {
    const int back = of_.intervals_ - m;
    return terms({value_[0][back], value_[1][m]}, {rate_[0][back], rate_[1][m]}, m);
  }

  Terms at(double s) const {
    const double step = response_.duration() / of_.intervals_;
    const RowMotion before = response_.impulse(stops_[0], stops_[1], (of_.intervals_ - s) * step);
    const RowMotion after = response_.impulse(stops_[1], stops_[0], s * step);
    return terms({before.value, after.value}, {before.rate, after.rate}, s);
  }

  // g, h: motion by the other impact's impulse along the row of each.
  Terms terms(const std::array<double, 2>& g, const std::array<double, 2>& h, double s) const {
    const double psi = angle(s);
    const std::array<Complex, 2> y{forced_[0], forced_[1] * std::polar(1.0, psi)};
    const Complex i_frequency(0.0, response_.frequency());
    const std::array<Complex, 2> r{i_frequency * y[0], i_frequency * y[1]};
    const double m00 = 1.0 + own_[0].rate * factor_[0], m01 = h[0] * factor_[1];
    const double m10 = h[1] * factor_[0], m11 = 1.0 + own_[1].rate * factor_[1];
    const double b00 = own_[0].value * factor_[0], b01 = g[0] * factor_[1];
    const double b10 = g[1] * factor_[0], b11 = own_[1].value * factor_[1];
    const std::array<Complex, 2> v{m11 * r[0] - m01 * r[1], m00 * r[1] - m10 * r[0]};
    const std::array<Complex, 2> moved{b00 * v[0] + b01 * v[1], b10 * v[0] + b11 * v[1]};
    Terms result;
    result.determinant = m00 * m11 - m01 * m10;
    for (const std::size_t k : {0u, 1u}) result.contact[k] = result.determinant * y[k] - moved[k];
    // Of |Y - X| with X of determinant det B det r/det M, all times det M.
    result.e = result.determinant * cross(y[0], y[1]) - cross(y[0], moved[1]) -
               cross(moved[0], y[1]) + (b00 * b11 - b01 * b10) * cross(r[0], r[1]);
    result.n =
        distance_[1] * std::conj(result.contact[0]) - distance_[0] * std::conj(result.contact[1]);
    // Half an orbit apart on one stop, exchanging the impacts changes the sign of E.
    if (one_stop_ && odd_ && s == middle()) result.e = 0.0;
    const double zero = own_zeros(psi);
    if (zero == 0.0) return result;
    result.n /= zero;
    result.e /= zero;
    return result;
  }

  void add_zeros(const std::vector<double>& samples, double sign,
                 std::vector<Vector>& found) const {
    for (int m = 0; m <= last_; ++m) {
      const double here = samples[static_cast<std::size_t>(m)];
      if (here == 0.0) {
        add(place(m), sign, found);
        continue;
      }
      if (m < last_) {
        const double next = samples[static_cast<std::size_t>(m) + 1];
        if ((here > 0.0) != (next > 0.0) && next != 0.0)
          add(zero_between(place(m), place(m + 1), here, next, sign), sign, found);
      }
      add_pair(samples, m, sign, found);
    }
  }

  double zero_between(double low, double high, double at_low, double at_high, double sign) const {
    const auto f = [&](double s) { return at(s).function(sign); };
    std::uintmax_t evaluations = 40;
    const auto bracket = boost::math::tools::toms748_solve(
        f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(40), evaluations);
    return 0.5 * (bracket.first + bracket.second);
  }

  // Two zeros beside sample m, where its neighbours have its sign and are no smaller.
  void add_pair(const std::vector<double>& samples, int m, double sign,
                std::vector<Vector>& found) const {
    const auto sample = [&](int k) { return samples[static_cast<std::size_t>(k)]; };
    const int before = std::max(m - 1, 0), after = std::min(m + 1, last_);
    const double here = sample(m), way = here > 0.0 ? 1.0 : -1.0;
    if (!(way * sample(before) >= way * here && way * sample(after) >= way * here)) return;
    const int inner = std::clamp(m, 1, last_ - 1);
    const double bend = way * (sample(inner - 1) - 2.0 * sample(inner) + sample(inner + 1));
    if (!(way * here <= kMostDrop * bend)) return;
    const auto height = [&](double s) { return way * at(s).function(sign); };
    const auto [s, least] = boost::math::tools::brent_find_minima(
        height, place(before), place(after), std::numeric_limits<double>::digits / 2);
    if (least < 0.0) {
      if (s > place(before))
        add(zero_between(place(before), s, sample(before), way * least, sign), sign, found);
      if (s < place(after))
        add(zero_between(s, place(after), way * least, sample(after), sign), sign, found);
      return;
    }
    const Terms terms = at(s);
    if (least > kDoubleZero * (std::abs(terms.n) + std::abs(terms.e))) return;
    add(s, sign, found);
    add_any(s, found);
  }

  // Adds the solution from z = i n/E.
  void add(double s, double sign, std::vector<Vector>& found) const {
    const Terms terms = at(s);
    if (terms.vanish(distance_)) return add_any(s, found);
    add_phases(std::arg(Complex(0.0, sign) * terms.n), s, found);
  }

  // Adds the solutions where both contact equations are one, from that one.
  void add_any(double s, std::vector<Vector>& found) const {
    const Terms terms = at(s);
    const std::size_t k = std::abs(terms.contact[1]) > std::abs(terms.contact[0]) ? 1 : 0;
    const double cosine = terms.determinant * distance_[k] / std::abs(terms.contact[k]);
    if (!(std::abs(cosine) <= 1.0 + kZero)) return;
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double turn : {half, -half}) add_phases(turn - std::arg(terms.contact[k]), s, found);
  }

  void add_phases(double theta, double s, std::vector<Vector>& found) const {
    const double first = wrapped(theta);
    found.push_back(Vector{{first, first + angle(s)}});
  }

  const TwoImpacts& of_;
  const PeriodicResponse& response_;
  std::array<int, 2> stops_;
  bool one_stop_, odd_;
  bool mirrored_ = false;  // half an orbit apart both equations of contact are one
  int last_;               // sample of the range
  std::array<double, 2> factor_{}, distance_{};
  std::array<RowMotion, 2> own_;
  std::array<Complex, 2> forced_;
  std::array<Vector, 2> value_, rate_;  // along the row of each after the other's unit impulse
};

TwoImpacts::TwoImpacts(const PeriodicResponse& response, int intervals)
    : response_(&response), intervals_(intervals) {
  const Vector instants = Vector::LinSpaced(intervals + 1, 0.0, response.duration());
  response.modal_impulses(instants, displacements_, velocities_);
  const std::vector<Stop>& stops = response.system().stops;
  for (std::size_t stop = 0; stop < stops.size(); ++stop) {
    const int index = static_cast<int>(stop);
    own_.push_back(response.impulse(index, index, response.duration()));
    regular_.push_back(stops[stop].restitution().is_constant() &&
                       PhaseProblem(response, {index}, 0.0).remains_contact());
  }
}

bool TwoImpacts::holds(int first, int second) const {
  return regular_[static_cast<std::size_t>(first)] && regular_[static_cast<std::size_t>(second)];
}

std::vector<Vector> TwoImpacts::phases(int first, int second) const {
  return Pair(*this, first, second).solutions();
}

TwoImpactsAnswer two_impacts(const PeriodicResponse& response) {
  const double intervals =
      kIntervalsPerPeriod * std::ceil(response.quickest() * response.duration() / kTurn);
  if (!(intervals <= kMostIntervals))
    return {{},
            fmt::format("the quickest mode has more than {} periods in the orbit's",
                        static_cast<int>(kMostIntervals / kIntervalsPerPeriod))};
  return {TwoImpacts(response, static_cast<int>(intervals)), ""};
}

}  // namespace graze
