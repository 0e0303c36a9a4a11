#include "graze/orbit/phase_problem.hpp"

#include <Eigen/LU>
#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {

PhaseProblem::PhaseProblem(const PeriodicResponse& response, std::vector<int> stops,
                           Vector restitution)
    : response_(&response), stops_(std::move(stops)), restitution_(std::move(restitution)) {
  for (const int stop : stops_) own_.push_back(response.impulse(stop, stop, response.duration()));
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
    gap[i] = response_->system().stops[static_cast<std::size_t>(at)].gap;
    for (Eigen::Index j = 0; j < k; ++j) {
      const RowMotion motion =
          i == j ? own_[static_cast<std::size_t>(i)]
                 : response_->impulse(at, stops_[static_cast<std::size_t>(j)], since(phases, i, j));
      g(i, j) = motion.value;
      h(i, j) = motion.rate;
      h_rate(i, j) = motion.acceleration;
    }
  }
  const Vector share = (restitution_.array() + 1.0).inverse();  // v = share u
  Matrix equations = h;
  equations.diagonal() += share;
  const Eigen::PartialPivLU<Matrix> lu(equations);
  const Vector impulses = lu.solve(forced_rate);
  if (speeds) *speeds = impulses.cwiseProduct(share);
  if (jacobian) {
    // d/d theta_m of s_ij is (delta_im - delta_jm)/W; an impact's own impulse stays a lap behind.
    Matrix speed_rate = Matrix::Zero(k, k);  // of b_i.Y' - (H u)_i, at fixed u
    jacobian->setZero(k, k);
    for (Eigen::Index i = 0; i < k; ++i) {
      speed_rate(i, i) += forced_acceleration[i] / frequency;
      (*jacobian)(i, i) += forced_rate[i] / frequency;
      for (Eigen::Index j = 0; j < k; ++j) {
        if (i == j) continue;
        const double by_rate = impulses[j] * h(i, j) / frequency;
        const double by_acceleration = impulses[j] * h_rate(i, j) / frequency;
        (*jacobian)(i, i) -= by_rate;
        (*jacobian)(i, j) += by_rate;
        speed_rate(i, i) -= by_acceleration;
        speed_rate(i, j) += by_acceleration;
      }
    }
    *jacobian -= g * lu.solve(speed_rate);
  }
  return forced - g * impulses - gap;
}

std::vector<ImpactPoint> PhaseProblem::points(const Vector& phases) const {
  Vector speeds;
  contact(phases, nullptr, &speeds);
  const Vector impulses = speeds.cwiseProduct(Vector(restitution_.array() + 1.0));
  std::vector<ImpactPoint> result;
  for (Eigen::Index i = 0; i < impacts(); ++i) {
    State state = response_->forced_state(phases[i]);
    for (Eigen::Index j = 0; j < impacts(); ++j) {
      const double s = i == j ? response_->duration() : since(phases, i, j);
      const State part = response_->impulse_state(stops_[static_cast<std::size_t>(j)], s);
      state.q -= impulses[j] * part.q;
      state.qdot -= impulses[j] * part.qdot;
    }
    result.push_back({phases[i], state});
  }
  return result;
}

}  // namespace graze
