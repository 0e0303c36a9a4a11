#include "graze/orbit/closed_form/detail/phase_problem.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// From this number of impacts on, the motions between all of them are computed together: by pairs
// they cost as many exponentials as there are pairs.
constexpr Eigen::Index kManyImpacts = 4;

}  // namespace

struct PhaseProblem::Rows {
  Matrix g, h, h_rate;  // impulses: m, m/s, m/s^2 per m/s
  Vector forced, forced_rate, forced_acceleration, gap;
  // Derivatives by the phases at fixed impulses: of forced - g u and of forced_rate - h u.
  Matrix contact_by_phases(const Vector& u, double frequency) const {
    return by_phases(u, h, forced_rate, frequency);
  }
  Matrix rate_by_phases(const Vector& u, double frequency) const {
    return by_phases(u, h_rate, forced_acceleration, frequency);
  }

 private:
  // d/d theta_m of s_ij is (delta_im - delta_jm)/W; an impact's own impulse stays one orbit behind.
  static Matrix by_phases(const Vector& u, const Matrix& rate, const Vector& forced,
                          double frequency) {
    Matrix derivative = Matrix((forced / frequency).asDiagonal());
    for (Eigen::Index i = 0; i < u.size(); ++i)
      for (Eigen::Index j = 0; j < u.size(); ++j) {
        if (i == j) continue;
        const double by_rate = u[j] * rate(i, j) / frequency;
        derivative(i, i) -= by_rate;
        derivative(i, j) += by_rate;
      }
    return derivative;
  }
};

struct PhaseProblem::Impacts {
  Vector u, v;                      // m/s
  Matrix u_by_phases, v_by_phases;  // m/s per rad
};

PhaseProblem::PhaseProblem(const PeriodicResponse& response, std::vector<int> stops, double speed)
    : response_(&response), stops_(std::move(stops)), speed_(speed) {
  // Where an impact's own impulse cancels more than half of the digits of the 1 of v_i, the speeds
  // cannot be computed from their rates.
  const double cancelled = std::sqrt(std::numeric_limits<double>::epsilon());
  from_contact_ = true;
  for (const int stop : stops_) {
    own_.push_back(response.impulse(stop, stop, response.duration()));
    const Stop& met = response.system().stops[static_cast<std::size_t>(stop)];
    constant_ = constant_ && met.restitution().is_constant();
    const double own_part = 1.0 + (1.0 + met.restitution().at(speed)) * own_.back().rate;
    from_contact_ = from_contact_ && std::abs(own_part) <= cancelled;
  }
}

const Stop& PhaseProblem::stop(Eigen::Index impact) const {
  return response_->system()
      .stops[static_cast<std::size_t>(stops_[static_cast<std::size_t>(impact)])];
}

Vector PhaseProblem::impulses(const Vector& speeds) const {
  Vector u(speeds.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = stop(i).restitution().jump(speeds[i]);
  return u;
}

Vector PhaseProblem::impulse_slopes(const Vector& speeds) const {
  Vector slopes(speeds.size());
  for (Eigen::Index i = 0; i < slopes.size(); ++i)
    slopes[i] = stop(i).restitution().jump_slope(speeds[i]);
  return slopes;
}

Vector PhaseProblem::approach_speeds(const Matrix& h, const Vector& forced_rate,
                                     std::optional<LuFactors>& derivative) const {
  const Eigen::Index k = impacts();
  const auto factorise = [&](const Vector& slopes) {
    derivative.emplace(Matrix::Identity(k, k) + h * slopes.asDiagonal());
  };
  Vector slopes(k);
  for (Eigen::Index i = 0; i < k; ++i) slopes[i] = 1.0 + stop(i).restitution().at(speed_);
  factorise(slopes);
  Vector v = derivative->solve(forced_rate);
  if (constant_) return v;
  constexpr int kMostSteps = 20;
  const double near = std::sqrt(std::numeric_limits<double>::epsilon()) * speed_;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    factorise(impulse_slopes(v));
    const Vector update = derivative->solve(v + h * impulses(v) - forced_rate);
    const double size = update.norm();
    v -= update;
    // Near the solution every step squares the error; when it no longer shrinks, rounding is
    // reached.
    if (size <= near && !(size < 0.5 * last)) return v;
    if (size == 0.0) return v;
    last = size;
  }
  return Vector::Constant(k, std::numeric_limits<double>::quiet_NaN());
}

double PhaseProblem::since(const Vector& phases, Eigen::Index i, Eigen::Index j) const {
  const double lap = kTurn * response_->period();
  double turn = std::fmod(phases[i] - phases[j], lap);
  if (turn <= 0.0) turn += lap;
  return turn / response_->frequency();
}

Vector PhaseProblem::instants(const Vector& phases) const {
  const double lap = kTurn * response_->period();
  Vector seconds(phases.size());
  for (Eigen::Index i = 0; i < phases.size(); ++i) {
    double turn = std::fmod(phases[i] - phases[0], lap);
    if (turn < 0.0) turn += lap;
    seconds[i] = (turn < lap ? turn : 0.0) / response_->frequency();
  }
  return seconds;
}

PhaseProblem::Rows PhaseProblem::rows(const Vector& phases) const {
  const Eigen::Index k = impacts();
  Rows rows{Matrix(k, k), Matrix(k, k), Matrix(k, k), Vector(k), Vector(k), Vector(k), Vector(k)};
  const bool many = k >= kManyImpacts;
  if (many) {
    ImpulseMotions motions = response_->impulses(stops_, instants(phases));
    rows.g = std::move(motions.value);
    rows.h = std::move(motions.rate);
    rows.h_rate = std::move(motions.acceleration);
  }
  for (Eigen::Index i = 0; i < k; ++i) {
    const int at = stops_[static_cast<std::size_t>(i)];
    const RowMotion y = response_->forced(at, phases[i]);
    rows.forced[i] = y.value;
    rows.forced_rate[i] = y.rate;
    rows.forced_acceleration[i] = y.acceleration;
    rows.gap[i] = stop(i).gap;
    for (Eigen::Index j = 0; j < k; ++j) {
      if (many && i != j) continue;
      const RowMotion motion =
          i == j ? own_[static_cast<std::size_t>(i)]
                 : response_->impulse(at, stops_[static_cast<std::size_t>(j)], since(phases, i, j));
      rows.g(i, j) = motion.value;
      rows.h(i, j) = motion.rate;
      rows.h_rate(i, j) = motion.acceleration;
    }
  }
  return rows;
}

PhaseProblem::Impacts PhaseProblem::impacts_from_rates(const Rows& rows, bool derivatives) const {
  std::optional<LuFactors> lu;
  Impacts result;
  result.v = approach_speeds(rows.h, rows.forced_rate, lu);
  result.u = impulses(result.v);
  if (derivatives) {
    result.v_by_phases = lu->solve_columns(rows.rate_by_phases(result.u, response_->frequency()));
    result.u_by_phases = impulse_slopes(result.v).asDiagonal() * result.v_by_phases;
  }
  return result;
}

PhaseProblem::Impacts PhaseProblem::impacts_from_contact(const Rows& rows, bool derivatives) const {
  const LuFactors lu(rows.g);
  Impacts result;
  result.u = lu.solve(rows.forced - rows.gap);
  result.v = rows.forced_rate - rows.h * result.u;
  if (derivatives) {
    const double frequency = response_->frequency();
    result.u_by_phases = lu.solve_columns(rows.contact_by_phases(result.u, frequency));
    result.v_by_phases = rows.rate_by_phases(result.u, frequency) - rows.h * result.u_by_phases;
  }
  return result;
}

Vector PhaseProblem::defect(const Vector& phases, Matrix* jacobian, Vector* speeds) const {
  const double frequency = response_->frequency();
  const Rows along = rows(phases);
  const bool derivatives = jacobian != nullptr;
  const Impacts found = from_contact_ ? impacts_from_contact(along, derivatives)
                                      : impacts_from_rates(along, derivatives);
  if (speeds) *speeds = found.v;
  if (from_contact_) {
    if (jacobian)
      *jacobian = (found.u_by_phases - impulse_slopes(found.v).asDiagonal() * found.v_by_phases) /
                  frequency;
    return (found.u - impulses(found.v)) / frequency;
  }
  if (jacobian)
    *jacobian = along.contact_by_phases(found.u, frequency) - along.g * found.u_by_phases;
  return along.forced - along.g * found.u - along.gap;
}

std::vector<ImpactPoint> PhaseProblem::points(const Vector& phases) const {
  const Rows along = rows(phases);
  const Vector u =
      (from_contact_ ? impacts_from_contact(along, false) : impacts_from_rates(along, false)).u;
  std::vector<ImpactPoint> result;
  for (Eigen::Index i = 0; i < impacts(); ++i) {
    State state = response_->forced_state(phases[i]);
    for (Eigen::Index j = 0; j < impacts(); ++j) {
      const double s = i == j ? response_->duration() : since(phases, i, j);
      const State part = response_->impulse_state(stops_[static_cast<std::size_t>(j)], s);
      state.q -= u[j] * part.q;
      state.qdot -= u[j] * part.qdot;
    }
    result.push_back({phases[i], state});
  }
  return result;
}

}  // namespace graze
