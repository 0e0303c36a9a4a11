#include "graze/orbit/closed_form/detail/periodic_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"

namespace graze {
namespace {

// (I - E)^-1 of one mode.
class RepeatedMode {
 public:
  RepeatedMode(const ModeFlow<double>& mode, const FlowMatrix& flow, Eigen::Index j, double s)
      : qq_(1.0 - flow.qq[j]), qv_(-flow.qv[j]), vq_(-flow.vq[j]), vv_(1.0 - flow.vv[j]) {
    // det (I - E) = 1 - 2 c + e^{-2 delta s}, from differences that do not cancel.
    const FreeBasis<double> basis = free_basis(mode.omega, mode.delta, mode.discriminant, s);
    determinant_ = std::expm1(-2.0 * mode.delta * s) - 2.0 * basis.cosine_minus_one;
  }

  Eigen::Vector2d solve(double q, double v) const {
    return Eigen::Vector2d(vv_ * q - qv_ * v, qq_ * v - vq_ * q) / determinant_;
  }

  // A lower bound on the smallest singular value, with velocities in units of `rate`.
  double smallest(double rate) const {
    const double size = std::hypot(std::hypot(qq_, vv_), std::hypot(qv_ * rate, vq_ / rate));
    return size > 0.0 ? std::abs(determinant_) / size : 0.0;
  }

 private:
  double qq_, qv_, vq_, vv_, determinant_;
};

// The free motion of one mode over some time.
struct FreeStep {
  double qq = 1.0, qv = 0.0, vq = 0.0, vv = 1.0;
};

FreeStep free_step(double omega, double delta, double discriminant, double s) {
  const FreeBasis<double> basis = free_basis(omega, delta, discriminant, s);
  return {basis.cosine + delta * basis.sine, basis.sine, -omega * omega * basis.sine,
          basis.cosine - delta * basis.sine};
}

}  // namespace

std::pair<double, double> PeriodicResponse::after(const Mode& mode, double s) {
  const FreeStep step = free_step(mode.omega, mode.delta, mode.discriminant, s);
  return {step.qq * mode.displacement + step.qv * mode.velocity,
          step.vq * mode.displacement + step.vv * mode.velocity};
}

RowMotion PeriodicResponse::forced(int at, double theta) const {
  const Complex turned = forced_at_[static_cast<std::size_t>(at)] * std::polar(1.0, theta);
  return {turned.real() + rest_at_[static_cast<std::size_t>(at)], -frequency_ * turned.imag(),
          -frequency_ * frequency_ * turned.real()};
}

RowMotion PeriodicResponse::impulse(int at, int by, double s) const {
  const Vector& row = system_->stops[static_cast<std::size_t>(at)].row;
  const Vector& direction = system_->stops[static_cast<std::size_t>(by)].direction();
  RowMotion motion;
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    const auto [q, v] = after(mode, s);
    const auto j = static_cast<Eigen::Index>(m);
    const double weight = row[j] * direction[j];
    motion.value += weight * q;
    motion.rate += weight * v;
    motion.acceleration -= weight * (2.0 * mode.delta * v + mode.omega * mode.omega * q);
  }
  return motion;
}

ImpulseMotions PeriodicResponse::impulses(const std::vector<int>& stops,
                                          const Vector& instants) const {
  const auto k = stops.size();
  const auto size = static_cast<Eigen::Index>(k);
  std::vector<Eigen::Index> order(k);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return instants[a] < instants[b]; });
  std::vector<double> at(k), gaps(k);
  for (std::size_t a = 0; a < k; ++a) at[a] = instants[order[a]];
  for (std::size_t a = 0; a < k; ++a)
    gaps[a] = at[(a + 1) % k] - at[a] + (a + 1 == k ? duration_ : 0.0);
  ImpulseMotions motions{Matrix::Zero(size, size), Matrix::Zero(size, size),
                         Matrix::Zero(size, size)};
  std::vector<FreeStep> steps(k);
  std::vector<double> row(k), direction(k);  // of the impacts in order
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    const auto j = static_cast<Eigen::Index>(m);
    for (std::size_t a = 0; a < k; ++a) {
      const Stop& stop =
          system_->stops[static_cast<std::size_t>(stops[static_cast<std::size_t>(order[a])])];
      row[a] = stop.row[j];
      direction[a] = stop.direction()[j];
      steps[a] = gaps[a] > 0.0 ? free_step(mode.omega, mode.delta, mode.discriminant, gaps[a])
                               : FreeStep{};
    }
    const double damping = 2.0 * mode.delta, stiffness = mode.omega * mode.omega;
    const auto [q_lap, v_lap] = after(mode, duration_);
    for (std::size_t from = 0; from < k; ++from) {
      double q = mode.displacement, v = mode.velocity;
      for (std::size_t passed = 1; passed < k; ++passed) {
        const FreeStep& step = steps[(from + passed - 1) % k];
        const double end = step.qq * q + step.qv * v;
        v = step.vq * q + step.vv * v;
        q = end;
        const std::size_t to = (from + passed) % k;
        const bool together = to > from && at[to] == at[from];
        const double q_there = together ? q_lap : q, v_there = together ? v_lap : v;
        const double weight = row[to] * direction[from];
        motions.value(order[to], order[from]) += weight * q_there;
        motions.rate(order[to], order[from]) += weight * v_there;
        motions.acceleration(order[to], order[from]) -=
            weight * (damping * v_there + stiffness * q_there);
      }
    }
  }
  return motions;
}

double PeriodicResponse::quickest() const {
  double quickest = frequency_;
  for (const Mode& mode : modes_)
    quickest = std::max(quickest, mode.discriminant < 0.0 ? 2.0 * mode.delta : mode.omega);
  return quickest;
}

void PeriodicResponse::modal_impulses(const Vector& instants, Matrix& displacements,
                                      Matrix& velocities) const {
  const auto n = static_cast<Eigen::Index>(modes_.size());
  displacements.resize(instants.size(), n);
  velocities.resize(instants.size(), n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < instants.size(); ++i)
      std::tie(displacements(i, j), velocities(i, j)) =
          after(modes_[static_cast<std::size_t>(j)], instants[i]);
}

State PeriodicResponse::forced_state(double theta) const {
  const ComplexVector turned = forced_ * std::polar(1.0, theta);
  return {turned.real() + rest_, -frequency_ * turned.imag()};
}

State PeriodicResponse::impulse_state(int by, double s) const {
  const Vector& direction = system_->stops[static_cast<std::size_t>(by)].direction();
  State state{direction, direction};
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const auto [q, v] = after(modes_[m], s);
    state.q[static_cast<Eigen::Index>(m)] *= q;
    state.qdot[static_cast<Eigen::Index>(m)] *= v;
  }
  return state;
}

PeriodicResponseAnswer periodic_response(const System& system, int period) {
  if (system.harmonics()) return {{}, kHarmonics};
  if (system.coupling()) return {{}, kCoupledModes};
  // The inverse of I - E has an error of eps over its smallest singular value; below this it keeps
  // less than half of its digits, and the reduction would leave the work to Newton's method.
  const double least = std::sqrt(std::numeric_limits<double>::epsilon());
  const Eigen::Index n = system.modes();
  const ExactFlow<double> flow(system);
  PeriodicResponse response;
  response.system_ = &system;
  response.period_ = period;
  response.frequency_ = flow.frequency();
  response.duration_ = period * system.period();
  const double duration = response.duration_;
  const State rest{Vector::Zero(n), Vector::Zero(n)};
  // Responses from rest: to the forcing from phases 0 and pi/2, and to the load.
  const Transition arc = transition(system, flow, rest, 0.0, duration);
  const State loaded = load_response(system, flow, duration);
  response.forced_ = ComplexVector(n);
  response.rest_ = Vector(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    const RepeatedMode repeated(mode, arc.flow, j, duration);
    if (!(repeated.smallest(std::max(mode.omega, flow.frequency())) > least))
      return {{},
              fmt::format("the free motion of mode {} repeats by itself every {} forcing period{}",
                          j + 1, period, period == 1 ? "" : "s")};
    const Eigen::Vector2d kick = repeated.solve(0.0, 1.0);
    response.modes_.push_back({mode.delta, mode.omega, mode.discriminant, kick[0], kick[1]});
    const Eigen::Vector2d constant = repeated.solve(loaded.q[j], loaded.qdot[j]);
    const Eigen::Vector2d cosine =
        repeated.solve(arc.end.q[j] - loaded.q[j], arc.end.qdot[j] - loaded.qdot[j]);
    const Eigen::Vector2d sine = repeated.solve(arc.phase_rate.q[j], arc.phase_rate.qdot[j]);
    response.forced_[j] = Complex(cosine[0], -sine[0]);
    response.rest_[j] = constant[0];
  }
  for (const Stop& stop : system.stops) {
    response.forced_at_.push_back(stop.row.cast<Complex>().dot(response.forced_));
    response.rest_at_.push_back(stop.row.dot(response.rest_));
  }
  return {std::move(response), ""};
}

}  // namespace graze
