// Right-hand sides for the methods of Boost.Odeint (step_flow.hpp). Each has
//   State                       of the method
//   begin(theta, x, depths, z)  a piece begins at x; z: the method's state there
//   operator()(z, slope, s)
//   observed(watch, s, z)       the value of a watch
//   whole(z, x)                 x at the method's state
//   first_step(longest)         to begin a piece with, s
//   relative(tolerance)         the part of a state's size that an error of it may have
// Included by step_walk.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "graze/flow/stepped/detail/step_flow.hpp"

namespace graze::step_walk {

template <class State>
void assign(State& to, const Vector& from) {
  if constexpr (requires { to.resize(0); }) to.resize(static_cast<std::size_t>(from.size()));
  std::copy(from.begin(), from.end(), to.begin());
}

// For methods whose state is x itself.
class OfTheState {
 public:
  static double relative(double tolerance) { return tolerance; }

  explicit OfTheState(double frequency) : frequency_(frequency) {}

  template <class State>
  void begin(double theta, const Vector& x, std::span<const double> /*depths*/, State& start) {
    theta_ = theta;
    known_at_ = -1.0;
    assign(start, x);
  }
  template <class State>
  double observed(const Watch& watch, double s, const State& x) const {
    double sum = watch.constant;
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += watch.weights[static_cast<Eigen::Index>(j)] * x[j];
    if (watch.harmonic_re == 0.0 && watch.harmonic_im == 0.0) return sum;
    const double theta = theta_ + frequency_ * s;
    return sum + watch.harmonic_re * std::cos(theta) - watch.harmonic_im * std::sin(theta);
  }
  template <class State>
  void whole(const State& state, Vector& x) const {
    x = Eigen::Map<const Vector>(state.data(), static_cast<Eigen::Index>(state.size()));
  }
  double frequency() const { return frequency_; }
  double first_step(double longest) const { return longest; }

  long long evaluations = 0;

 protected:
  // cos(theta) of the force; stages come in pairs at one instant.
  double cosine_at(double s) {
    if (s != known_at_) {
      known_at_ = s;
      cosine_ = std::cos(theta_ + frequency_ * s);
    }
    return cosine_;
  }

  double frequency_, theta_ = 0.0;

 private:
  double known_at_ = -1.0, cosine_ = 1.0;
};

// The right-hand side for N modes; N = 0: as many as there are.
template <std::size_t N>
class SideBySide : public OfTheState {
 public:
  using State = std::conditional_t<N == 0, std::vector<double>, std::array<double, 2 * N>>;

  explicit SideBySide(const ModalRates& rates) : OfTheState(rates.frequency) {
    assign(scale_, rates.scale);
    assign(stiffness_, rates.stiffness);
    assign(damping_, rates.damping);
    assign(load_, rates.load);
    assign(force_, rates.force);
  }
  // The two never overlap; with __restrict a compiler takes several modes at once.
  void operator()(const State& __restrict x, State& __restrict slope, double s) {
    ++evaluations;
    const std::size_t n = N == 0 ? scale_.size() : N;
    const double cosine = frequency_ > 0.0 ? cosine_at(s) : 1.0;
    for (std::size_t j = 0; j < n; ++j) {
      slope[j] = scale_[j] * x[n + j];
      slope[n + j] = load_[j] + force_[j] * cosine - damping_[j] * x[n + j] - stiffness_[j] * x[j];
    }
  }

 private:
  using PerMode = std::conditional_t<N == 0, std::vector<double>, std::array<double, N>>;
  PerMode scale_{}, stiffness_{}, damping_{}, load_{}, force_{};
};

class Dense : public OfTheState {
 public:
  using State = std::vector<double>;

  explicit Dense(const FirstOrderSystem& system) : OfTheState(system.frequency), system_(system) {}
  void operator()(const State& x, State& slope, double s) {
    ++evaluations;
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::Map<Vector>(slope.data(), n).noalias() =
        system_.generator * Eigen::Map<const Vector>(x.data(), n) + system_.load +
        system_.force * cosine_at(s);
  }

 private:
  FirstOrderSystem system_;
};

}  // namespace graze::step_walk
