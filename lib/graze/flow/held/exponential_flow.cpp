#include "graze/flow/held/detail/exponential_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/base/linalg/decompositions.hpp"

namespace graze {
namespace {

// Roundings in one term of a curve, as in the decoupled flow.
constexpr double kExponentialRoundings = 8.0;

// Norms overestimate how much of the motion an observable sees. Over a short reach h the known
// derivatives bound the second one better,
//
//   B(h) = |g^(2)| + |g^(3)| h + |g^(4)| h^2/2 + K_5 h^3/6,
//
// and the h at which the last term alone would just allow a step of h, 2 (|g| + noise) = B h^2, is
// taken where it is longer than the step that the norms allow.
void sharpen(const std::array<double, 3>& derivatives, double last, double others,
             CurvePoint<double>& point) {
  const double value = std::abs(point.value) + point.noise;
  if (!(value > 0.0) || !(last > 0.0) || !std::isfinite(last)) return;
  const double reach = std::pow(12.0 * (value / last), 0.2);
  if (!(reach > std::sqrt(2.0 * (value / point.bound)))) return;
  const double bound = others + std::abs(derivatives[0]) +
                       reach * (std::abs(derivatives[1]) +
                                reach / 2.0 * (std::abs(derivatives[2]) + reach / 3.0 * last));
  if (!(bound < point.bound)) return;
  point.bound = bound;
  point.reach = reach;
}

}  // namespace

ExponentialFlow::ExponentialFlow(FirstOrderSystem system, Matrix basis, Matrix coordinates)
    : system_(std::move(system)),
      basis_(std::move(basis)),
      coordinates_(std::move(coordinates)),
      norm_growth_(std::max(norm_growth_rate(system_.generator), 0.0)) {}

void ExponentialArc::start(double theta, const Vector& x, const Vector& load) {
  theta_ = theta;
  load_ = flow_->coordinates_ * load;
  z_ = flow_->coordinates_ * x;
  formed_from_ = flow_->coordinates_.cwiseAbs() * x.cwiseAbs();
}

namespace {

Vector extended_start(const Vector& z, double cosine, double sine) {
  Vector start(z.size() + 3);
  start << z, cosine, sine, 1.0;
  return start;
}

}  // namespace

Vector ExponentialArc::change(double s) const {
  const Vector start = extended_start(z_, std::cos(theta_), std::sin(theta_));
  return exponential_change(extended_generator(flow_->system_, load_, s), start).topRows(z_.size());
}

// Sums the series with the absolute value of each product; beyond its range, the rounding of the
// exponential is bounded by its norms.
Vector ExponentialArc::change_size(double s) const {
  const FirstOrderSystem& system = flow_->system_;
  const Matrix sizes = extended_generator(system, load_, s).cwiseAbs();
  if (sizes.norm() < 1.0)
    return exponential_change(sizes, extended_start(formed_from_, 1.0, 1.0)).topRows(z_.size());
  const double input = load_.norm() + system.force.norm();
  return Vector::Constant(z_.size(),
                          (1.0 + system.generator.norm() * s) * (formed_from_.norm() + input * s));
}

// Derivative p is weight.T^p z + sum_i weight.T^(p-1-i) d^i/dt^i (load + force).
void ExponentialSum::add(const ExponentialArc& arc, const Vector& weight) {
  const FirstOrderSystem& system = arc.flow_->system_;
  Term& term = terms_.emplace_back(Term{arc, {}});
  term.derivatives[0].state = arc.flow_->basis_.transpose() * weight;
  term.derivatives[0].size = arc.flow_->basis_.transpose().cwiseAbs() * weight.cwiseAbs();
  for (std::size_t p = 1; p < term.derivatives.size(); ++p) {
    const Derivative& before = term.derivatives[p - 1];
    Derivative& now = term.derivatives[p];
    now.state = system.generator.transpose() * before.state;
    now.size = system.generator.transpose().cwiseAbs() * before.size;
    now.constant = before.state.dot(arc.load_);
    now.phase = before.phase * Complex(0.0, system.frequency) + before.state.dot(system.force);
    now.bound_of_input = std::abs(now.constant) + std::abs(now.phase);
  }
}

void ExponentialSum::operator()(double s, int m, Reach reach, CurvePoint<double>& point) const {
  const double others = point.bound;
  Higher higher;
  for (const Term& term : terms_) add_term(term, s, static_cast<std::size_t>(m), point, higher);
  if (reach == Reach::kStep) sharpen(higher.derivatives, higher.last, others, point);
}

// |z| grows at most at the rate of its norm.
void ExponentialSum::add_term(const Term& term, double s, std::size_t m, CurvePoint<double>& point,
                              Higher& higher) const {
  const ExponentialArc& arc = term.arc;
  const FirstOrderSystem& system = arc.flow_->system_;
  const Vector change = arc.change(s), z = arc.z_ + change;
  const Complex turn = std::polar(1.0, arc.theta_ + system.frequency * s);
  const auto value = [&](std::size_t p) {
    const Derivative& d = term.derivatives[p];
    return d.state.dot(z) + d.constant + (d.phase * turn).real();
  };
  point.value += m == 0 ? term.derivatives[0].state.dot(change) : value(m);
  point.slope += value(m + 1);
  const double ahead = std::max(window_ - s, 0.0);
  const double input = arc.load_.norm() + system.force.norm();
  const double size = std::exp(arc.flow_->norm_growth_ * ahead) * (z.norm() + input * ahead);
  const auto bound = [&](std::size_t p) {
    return term.derivatives[p].state.norm() * size + term.derivatives[p].bound_of_input;
  };
  point.bound += bound(m + 2);
  for (std::size_t k = 0; k < higher.derivatives.size(); ++k)
    higher.derivatives[k] += value(m + 2 + k);
  higher.last += bound(m + 5);
  const Derivative& seen = term.derivatives[m];
  const Vector rounded = m == 0 ? arc.change_size(s) : arc.formed_from_ + arc.change_size(s);
  point.noise += kExponentialRoundings * std::numeric_limits<double>::epsilon() *
                 (seen.size.dot(rounded) + seen.bound_of_input);
}

}  // namespace graze
