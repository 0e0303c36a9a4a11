// Chains that touch, whose stops are rigid or compliant, and an independent motion of them: free
// bodies with forces as functions of the state (chain_reference.hpp), rigid stops that are touched
// at rest sharing out the push by complementarity at every evaluation, impacts by Newton's law over
// all stops touched, repeated at one instant until none is approached.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <vector>

#include "support/chain_reference.hpp"

namespace graze::support {

// p >= 0, w = v - D p <= 0, p.w = 0, of a few contacts, by going through all sets of active ones.
inline std::optional<Vector> complementary(const Matrix& d, const Vector& v, double rounding) {
  const Eigen::Index k = v.size();
  for (unsigned set = 0; set < (1u << static_cast<unsigned>(k)); ++set) {
    std::vector<Eigen::Index> active;
    for (Eigen::Index i = 0; i < k; ++i)
      if (set >> static_cast<unsigned>(i) & 1u) active.push_back(i);
    Vector p = Vector::Zero(k);
    if (!active.empty()) {
      const Vector pressed = Matrix(d(active, active)).ldlt().solve(Vector(v(active)));
      p(active) = pressed;
    }
    if (p.size() > 0 && p.minCoeff() < -rounding) continue;
    if (k > 0 && (v - d * p).maxCoeff() > rounding) continue;
    return p;
  }
  return {};
}

class MixedChainMotion {
 public:
  explicit MixedChainMotion(const Chain& chain, double tolerance = 1e-13)
      : chain_(chain),
        tolerance_(tolerance),
        n_(chain.start.q.size()),
        touched_(chain.system.stops.size(), false),
        z_(2 * n_) {
    z_ << chain.start.q, chain.start.qdot;
    for (std::size_t i = 0; i < touched_.size(); ++i)
      touched_[i] = !stop(i).is_compliant() && !(depth(i, z_) < 0.0);
    collide();
  }

  // The state after the duration; nothing where that takes more than so many impacts.
  std::optional<State> run(long long most_impacts) {
    double step = 1e-3 * chain_.duration;
    while (t_ < chain_.duration) {
      const bool last = t_ + step >= chain_.duration;
      if (last) step = chain_.duration - t_;
      const auto [next, error] = stepped(step);
      const double part = error / tolerance_;
      if (part <= 1.0 || step < 1e-14 * chain_.duration) {
        if (passes(next)) {
          locate(step);
          collide();
          if (impacts > most_impacts) return {};
        } else {
          z_ = next;
          t_ = last ? chain_.duration : t_ + step;
          part_touched();
        }
      }
      // A dip between two steps would be missed.
      step = std::min(step * std::clamp(0.9 * std::pow(std::max(part, 1e-10), -0.2), 0.2, 5.0),
                      2e-3 * chain_.duration);
    }
    return State{z_.head(n_), z_.tail(n_)};
  }

  long long impacts = 0;

 private:
  // m/s: of what differs by less the bodies are at rest against each other. It bounds how well the
  // motion is known.
  static constexpr double kAtRest = 1e-10;

  const Stop& stop(std::size_t i) const { return chain_.system.stops[i]; }
  double depth(std::size_t i, const Vector& z) const {
    return stop(i).row.dot(z.head(n_)) - stop(i).gap;
  }
  double speed(std::size_t i, const Vector& z) const { return stop(i).row.dot(z.tail(n_)); }

  std::vector<std::size_t> touched() const {
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < touched_.size(); ++i)
      if (touched_[i]) list.push_back(i);
    return list;
  }

  Matrix acting(const std::vector<std::size_t>& list) const {
    Matrix d(list.size(), list.size());
    for (std::size_t a = 0; a < list.size(); ++a)
      for (std::size_t b = 0; b < list.size(); ++b)
        d(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
            stop(list[a]).row.dot(stop(list[b]).row);
    return d;
  }

  void push_back(const std::vector<std::size_t>& list, const Vector& p,
                 Eigen::Ref<Vector> rates) const {
    for (std::size_t a = 0; a < list.size(); ++a)
      rates -= p[static_cast<Eigen::Index>(a)] * stop(list[a]).row;
  }

  Vector slope(double t, const Vector& z) const {
    Vector acceleration = chain_acceleration(chain_.system, t, z.head(n_), z.tail(n_));
    const std::vector<std::size_t> list = touched();
    if (!list.empty()) {
      Vector push(list.size());
      for (std::size_t a = 0; a < list.size(); ++a)
        push[static_cast<Eigen::Index>(a)] = stop(list[a]).row.dot(acceleration);
      const auto p = complementary(acting(list), push, 1e-14 * push.cwiseAbs().maxCoeff());
      if (p) push_back(list, *p, acceleration);
    }
    Vector rate(2 * n_);
    rate << z.tail(n_), acceleration;
    return rate;
  }

  // One step of Dormand and Prince, and its error.
  std::pair<Vector, double> stepped(double step) const {
    std::array<Vector, 7> k;
    Vector next = z_;
    for (std::size_t i = 0; i < 7; ++i) {
      next = z_;
      for (std::size_t j = 0; j < i; ++j) next += step * DormandPrince::kA[i][j] * k[j];
      k[i] = slope(t_ + DormandPrince::kC[i] * step, next);
    }
    Vector error = Vector::Zero(2 * n_);
    for (std::size_t i = 0; i < 7; ++i) error += step * DormandPrince::kError[i] * k[i];
    return {next, error.cwiseAbs().maxCoeff()};
  }

  bool passes(const Vector& next) const {
    for (std::size_t i = 0; i < touched_.size(); ++i)
      if (!stop(i).is_compliant() && !touched_[i] && depth(i, next) > 0.0 && speed(i, next) > 0.0)
        return true;
    return false;
  }

  // Moves to the first contact within a step, by bisection.
  void locate(double step) {
    double before = 0.0;
    while (step - before > 1e-15 * chain_.duration) {
      const double middle = 0.5 * (before + step);
      (passes(stepped(middle).first) ? step : before) = middle;
    }
    z_ = stepped(step).first;
    t_ += step;
    for (std::size_t i = 0; i < touched_.size(); ++i)
      if (!stop(i).is_compliant() && depth(i, z_) > -1e-13 && speed(i, z_) > -kAtRest)
        touched_[i] = true;
  }

  void part_touched() {
    for (std::size_t i = 0; i < touched_.size(); ++i)
      if (touched_[i] && speed(i, z_) < -kAtRest) touched_[i] = false;
  }

  // Impacts at this instant, until none of what is touched is approached.
  void collide() {
    for (int i = 0; i < 100000; ++i) {
      const std::vector<std::size_t> list = touched();
      Vector undone(list.size()), from(list.size());
      std::vector<Eigen::Index> partakes;
      bool approached = false;
      for (std::size_t a = 0; a < list.size(); ++a) {
        const auto at = static_cast<Eigen::Index>(a);
        const double v = speed(list[a], z_);
        undone[at] = 0.0;
        if (v < -kAtRest) continue;
        partakes.push_back(at);
        if (!(v > kAtRest)) continue;
        approached = true;
        undone[at] = (1.0 + stop(list[a]).restitution().at(v)) * v;
      }
      if (!approached) break;
      ++impacts;
      Vector p = Vector::Zero(undone.size());
      const Matrix d = acting(list);
      if (const auto solved = complementary(Matrix(d(partakes, partakes)), Vector(undone(partakes)),
                                            1e-14 * undone.cwiseAbs().maxCoeff()))
        p(partakes) = *solved;
      push_back(list, p, z_.tail(n_));
    }
    part_touched();
  }

  const Chain& chain_;
  double tolerance_, t_ = 0.0;
  Eigen::Index n_;
  std::vector<bool> touched_;  // rigid stops
  Vector z_;
};

// From 2 to so many equal bodies in a row that touch, some stops rigid, the others springs; one of
// the bodies thrown.
inline Chain mixed_chain(Dice& dice, int most) {
  const auto bodies = static_cast<Eigen::Index>(2 + dice.pick(most - 1));
  Chain chain{{Vector::Zero(bodies), NaturalModes{Vector::Zero(bodies)}, {}},
              {Vector::Zero(bodies), Vector::Zero(bodies)},
              10.0};
  const double restitutions[] = {0.0, 0.5, 0.8, 1.0}, stiffnesses[] = {1.0, 10.0, 100.0},
               exponents[] = {1.0, 1.5};
  for (Eigen::Index i = 0; i + 1 < bodies; ++i) {
    Vector row = Vector::Zero(bodies);
    row[i] = 1.0;
    row[i + 1] = -1.0;
    if (dice.pick(2) == 0) {
      chain.system.stops.push_back(
          {row, 0.0, ImpactLaw{momentum_direction(row), restitutions[dice.pick(4)]}});
    } else {
      const double stiffness = stiffnesses[dice.pick(3)];
      chain.system.stops.push_back(
          {row, 0.0, ContactForce{stiffness, exponents[dice.pick(2)], ContactDamping::kNone}});
    }
  }
  const int thrown = dice.pick(static_cast<int>(bodies));
  chain.start.qdot[thrown] = dice.pick(2) == 0 ? 1.0 : -1.0;
  return chain;
}

}  // namespace graze::support
