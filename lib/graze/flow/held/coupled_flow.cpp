#include "graze/flow/held/detail/coupled_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {
namespace {

FirstOrderSystem first_order(const CoupledSystem& system) {
  const Eigen::Index m = system.scale.size();
  FirstOrderSystem form{Matrix::Zero(2 * m, 2 * m), Vector::Zero(2 * m), Vector::Zero(2 * m),
                        system.frequency, system.loads_vary};
  form.generator.topRightCorner(m, m) = system.scale.asDiagonal();
  form.generator.bottomLeftCorner(m, m) =
      -system.stiffness * system.scale.cwiseInverse().asDiagonal();
  form.generator.bottomRightCorner(m, m) = -system.damping;
  form.load.tail(m) = system.load;
  form.force.tail(m) = system.force;
  return form;
}

// A basis of an invariant subspace with its matrix T, x' = basis T z: rounding of a displacement is
// magnified (|T|/scale)^2 times in the acceleration if velocities are taken from it, that of a
// velocity (scale |1/T|)^2 times the other way round.
Eigen::MatrixXcd with_rates(const Vector& scale, Eigen::MatrixXcd basis,
                            const Eigen::MatrixXcd& rates) {
  const Eigen::Index m = scale.size();
  const Eigen::MatrixXcd inverse = graze::inverse(rates);
  for (Eigen::Index i = 0; i < m; ++i) {
    if (scale[i] * inverse.norm() < rates.norm() / scale[i])
      basis.row(i) = scale[i] * basis.row(m + i) * inverse;
    else
      basis.row(m + i) = basis.row(i) * rates / scale[i];
  }
  return basis;
}

}  // namespace

CoupledFlow::CoupledFlow(const CoupledSystem& system)
    : scale_(system.scale), whole_(graze::first_order(system)) {
  const std::shared_ptr<const GeneratorParts> apart = generator_parts(whole_.generator);
  growth_ = apart->growth;
  split(apart->parts, std::max(scale_.maxCoeff(), system.frequency));
}

// Decompositions have an error of eps times the largest rate, which would move a stop that is at
// rest. So the basis is rebuilt with velocities as the rates of displacements, (scale y)' = scale
// y', as an identity, row by row from the half in which the rates leave rounding smaller.
void CoupledFlow::split(const std::vector<GeneratorPart>& parts, double quickest) {
  const Eigen::Index n = whole_.load.size();
  std::vector<FirstOrderSystem> without_modes;
  Eigen::MatrixXcd basis(n, n);
  ComplexVector values(n);
  Eigen::Index modes = 0, others = n;  // modes come first
  for (const auto& [block, own] : parts) {
    const Eigen::Index k = block.matrix.rows();
    FirstOrderSystem system{block.matrix, block.coordinates * whole_.load,
                            block.coordinates * whole_.force, whole_.frequency, whole_.loads_vary};
    if (are_usable(own, system, quickest)) {
      values.segment(modes, k) = own.values;
      for (Eigen::Index j = 0; j < k; ++j)
        basis.col(modes++) = with_rates(scale_, block.basis * own.vectors.col(j),
                                        Eigen::MatrixXcd::Constant(1, 1, own.values[j]));
      continue;
    }
    others -= k;
    basis.middleCols(others, k) =
        with_rates(scale_, block.basis.cast<Complex>(), block.matrix.cast<Complex>());
    without_modes.push_back(std::move(system));
  }
  const Eigen::MatrixXcd inverse = graze::inverse(basis);
  if (modes > 0)
    modes_.emplace_back(whole_, values.head(modes), basis.leftCols(modes), inverse.topRows(modes));
  others = n;
  for (FirstOrderSystem& system : without_modes) {
    const Eigen::Index k = system.load.size();
    others -= k;
    const Matrix coordinates = inverse.middleRows(others, k).real();
    system.load = coordinates * whole_.load;
    system.force = coordinates * whole_.force;
    exponentials_.emplace_back(std::move(system), basis.middleCols(others, k).real(), coordinates);
  }
}

double CoupledFlow::longest_flight() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const ExponentialFlow& flow : exponentials_)
    longest = std::min(longest, flow.longest_flight());
  return longest;
}

std::string CoupledFlow::instability() const {
  if (!(growth_ > 0.0)) return "";
  return fmt::format(
      "at rest on its stops under the collocation impulse law the structure is unstable (a motion "
      "grows at {:.3g} 1/s); points spread evenly (i L/N) and equal decay rates have no such "
      "motion",
      growth_);
}

CoupledArc::CoupledArc(const CoupledFlow& flow)
    : flow_(&flow),
      modes_(flow.modes_.begin(), flow.modes_.end()),
      exponentials_(flow.exponentials_.begin(), flow.exponentials_.end()) {}

void CoupledArc::start(double theta, const Vector& y, const Vector& ydot) {
  theta_ = theta;
  y_ = y;
  ydot_ = ydot;
  origin_ = Vector::Zero(y.size());
  load_ = flow_->whole_.load;
  start_modes();
}

void CoupledArc::start_from(double theta, const Vector& y, const Vector& ydot, const Vector& load) {
  theta_ = theta;
  y_ = origin_ = y;
  ydot_ = ydot;
  load_ = Vector::Zero(2 * y.size());
  load_.tail(y.size()) = load;
  start_modes();
}

void CoupledArc::start_modes() {
  x_.resize(2 * y_.size());
  x_ << flow_->scale_.cwiseProduct(y_ - origin_), ydot_;
  for (ComplexModeArc& arc : modes_) arc.start(theta_, x_, load_);
  for (ExponentialArc& arc : exponentials_) arc.start(theta_, x_, load_);
}

void CoupledArc::state(double s, Vector& y, Vector& ydot) const {
  Vector x = Vector::Zero(x_.size());
  for (const ComplexModeArc& arc : modes_) x += arc.state(s);
  for (const ExponentialArc& arc : exponentials_) x += arc.state(s);
  y = origin_ + x.head(y_.size()).cwiseQuotient(flow_->scale_);
  ydot = x.tail(y_.size());
}

// The extended system is autonomous: a later start is a deviation of (cos theta, sin theta).
Matrix CoupledArc::growth(double s, const Matrix& deviations,
                          const Eigen::RowVectorXd& delay) const {
  const CoupledFlow& flow = *flow_;
  const Eigen::Index n = x_.size(), m = n / 2;
  Vector unit(n);
  unit << flow.scale_, Vector::Ones(m);
  Matrix x = Matrix::Zero(n + 3, deviations.cols());
  x.topRows(n) = unit.asDiagonal() * deviations;
  x.row(n) = -flow.whole_.frequency * std::sin(theta_) * delay;
  x.row(n + 1) = flow.whole_.frequency * std::cos(theta_) * delay;
  const Matrix change = exponential_change(extended_generator(flow.whole_, load_, s), x);
  return unit.cwiseInverse().asDiagonal() * change.topRows(n);
}

Vector CoupledArc::weight_of(const Observable<double>& observable) const {
  Vector weight = Vector::Zero(x_.size());
  weight.head(y_.size()) = observable.displacement.cwiseQuotient(flow_->scale_);
  if (observable.velocity.size() > 0) weight.tail(y_.size()) = observable.velocity;
  return weight;
}

bool CoupledArc::each_term(const Observable<double>& observable,
                           const std::function<void(Complex, Complex)>& add) const {
  if (!exponentials_.empty()) return false;
  const Vector weight = weight_of(observable);
  for (const ComplexModeArc& arc : modes_) arc.each_term(weight, add);
  add(observable.constant + observable.displacement.dot(origin_), 0.0);
  if (flow_->whole_.frequency > 0.0)
    add(Complex(observable.harmonic.re, observable.harmonic.im) * std::polar(1.0, theta_),
        Complex(0.0, flow_->whole_.frequency));
  return true;
}

ArcCurve<double> CoupledArc::curve(const Observable<double>& observable, double window,
                                   bool from_zero) const {
  CurvePoint<double> start;
  if (!from_zero) start = observed(observable, theta_, y_, ydot_);
  ArcCurve<double> curve(start.value, start.noise, window);
  const Vector weight = weight_of(observable);
  Complex harmonic(observable.harmonic.re, observable.harmonic.im);
  for (const ComplexModeArc& arc : modes_) harmonic += arc.add_to(curve, weight);
  if (flow_->whole_.frequency > 0.0) {
    harmonic *= std::polar(1.0, theta_);
    curve.add_exponential({harmonic.real(), harmonic.imag()}, 0.0, flow_->whole_.frequency, 0.0);
  }
  if (exponentials_.empty()) return curve;
  ExponentialSum sum(window);
  for (const ExponentialArc& arc : exponentials_) sum.add(arc, weight);
  curve.set_part(std::move(sum));
  return curve;
}

}  // namespace graze
