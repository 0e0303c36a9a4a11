#include "graze/orbit/phase_problem.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"

namespace graze {

PhaseProblem::PhaseProblem(const PeriodicResponse& response, std::vector<int> stops, double speed)
    : response_(&response), stops_(std::move(stops)), speed_(speed) {
  for (const int stop : stops_) {
    own_.push_back(response.impulse(stop, stop, response.duration()));
    const RigidStop& met = response.system().stops[static_cast<std::size_t>(stop)];
    constant_ = constant_ && met.restitution.is_constant();
  }
}

const RigidStop& PhaseProblem::stop(Eigen::Index impact) const {
  return response_->system()
      .stops[static_cast<std::size_t>(stops_[static_cast<std::size_t>(impact)])];
}

Vector PhaseProblem::impulses(const Vector& speeds) const {
  Vector u = speeds;
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] *= 1.0 + stop(i).restitution.at(speeds[i]);
  return u;
}

Vector PhaseProblem::impulse_slopes(const Vector& speeds) const {
  Vector slopes(speeds.size());
  for (Eigen::Index i = 0; i < slopes.size(); ++i) slopes[i] = jump_slope(stop(i), speeds[i]);
  return slopes;
}

Vector PhaseProblem::approach_speeds(const Matrix& h, const Vector& forced_rate,
                                     Eigen::PartialPivLU<Matrix>& derivative) const {
  const Eigen::Index k = impacts();
  const auto factorise = [&](const Vector& slopes) {
    derivative.compute(Matrix::Identity(k, k) + h * slopes.asDiagonal());
  };
  Vector slopes(k);
  for (Eigen::Index i = 0; i < k; ++i) slopes[i] = 1.0 + stop(i).restitution.at(speed_);
  factorise(slopes);
  Vector v = derivative.solve(forced_rate);
  if (constant_) return v;
  constexpr int kMostSteps = 20;
  const double near = std::sqrt(std::numeric_limits<double>::epsilon()) * speed_;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    factorise(impulse_slopes(v));
    const Vector update = derivative.solve(v + h * impulses(v) - forced_rate);
    const double size = update.norm();
    v -= update;
    // Near the solution every step squares the error; where it no longer does, rounding is reached.
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

Vector PhaseProblem::contact(const Vector& phases, Matrix* jacobian, Vector* speeds) const {
  const Eigen::Index k = impacts();
  const double frequency = response_->frequency();
  Matrix g(k, k), h(k, k), h_rate(k, k);  // along row i of the impulse j, and its derivatives
  Vector forced(k), forced_rate(k), forced_acceleration(k), gap(k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const int at = stops_[static_cast<std::size_t>(i)];
    const RowMotion y = response_->forced(at, phases[i]);
    forced[i] = y.value;
    forced_rate[i] = y.rate;
    forced_acceleration[i] = y.acceleration;
    gap[i] = stop(i).gap;
    for (Eigen::Index j = 0; j < k; ++j) {
      const RowMotion motion =
          i == j ? own_[static_cast<std::size_t>(i)]
                 : response_->impulse(at, stops_[static_cast<std::size_t>(j)], since(phases, i, j));
      g(i, j) = motion.value;
      h(i, j) = motion.rate;
      h_rate(i, j) = motion.acceleration;
    }
  }
  Eigen::PartialPivLU<Matrix> lu(k);
  const Vector v = approach_speeds(h, forced_rate, lu);
  const Vector u = impulses(v);
  if (speeds) *speeds = v;
  if (jacobian) {
    // d/d theta_m of s_ij is (delta_im - delta_jm)/W; an impact's own impulse stays a lap behind.
    Matrix speed_rate = Matrix::Zero(k, k);  // of b_i.Y' - (H u)_i, at fixed u
    jacobian->setZero(k, k);
    for (Eigen::Index i = 0; i < k; ++i) {
      speed_rate(i, i) += forced_acceleration[i] / frequency;
      (*jacobian)(i, i) += forced_rate[i] / frequency;
      for (Eigen::Index j = 0; j < k; ++j) {
        if (i == j) continue;
        const double by_rate = u[j] * h(i, j) / frequency;
        const double by_acceleration = u[j] * h_rate(i, j) / frequency;
        (*jacobian)(i, i) -= by_rate;
        (*jacobian)(i, j) += by_rate;
        speed_rate(i, i) -= by_acceleration;
        speed_rate(i, j) += by_acceleration;
      }
    }
    *jacobian -= g * impulse_slopes(v).asDiagonal() * lu.solve(speed_rate);
  }
  return forced - g * u - gap;
}

std::vector<ImpactPoint> PhaseProblem::points(const Vector& phases) const {
  Vector speeds;
  contact(phases, nullptr, &speeds);
  const Vector u = impulses(speeds);
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
