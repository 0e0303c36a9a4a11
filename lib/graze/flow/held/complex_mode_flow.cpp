#include "graze/flow/held/detail/complex_mode_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
bool are_usable(const ComplexModes& modes, const FirstOrderSystem& system, double quickest) {
  if (!(modes.condition <= kLargestLoss * static_cast<double>(system.load.size()))) return false;
  const bool loaded = system.loads_vary || system.load.squaredNorm() > 0.0;
  // Without a force nothing is at resonance: several harmonics are motions of their own.
  const bool forced = system.frequency > 0.0 && system.force.squaredNorm() > 0.0;
  for (const Complex l : modes.values) {
    const bool resonant = forced &&
                          std::abs(Complex(0.0, system.frequency) - l) * kLargestLoss < std::abs(l);
    const bool soft = std::abs(l) * kLargestLoss * kLargestLoss < quickest;
    if (resonant || (soft && loaded) || l.real() > modes.error) return false;
  }
  return true;
}

ComplexModeFlow::ComplexModeFlow(const FirstOrderSystem& system, ComplexVector values,
                                 Eigen::MatrixXcd vectors, Eigen::MatrixXcd inverse)
    : frequency_(system.frequency),
      values_(std::move(values)),
      vectors_(std::move(vectors)),
      inverse_(std::move(inverse)) {
  is_loaded_ = system.loads_vary || system.load.squaredNorm() > 0.0;
  ComplexVector harmonic = inverse_ * system.force.cast<Complex>();
  for (Eigen::Index k = 0; k < values_.size(); ++k)
    harmonic[k] = frequency_ > 0.0 && harmonic[k] != 0.0
                      ? harmonic[k] / (Complex(0.0, frequency_) - values_[k])
                      : 0.0;
  harmonic_ = vectors_ * harmonic;
  inverse_size_ = inverse_.cwiseAbs();
  harmonic_size_ = harmonic_.cwiseAbs();
}

void ComplexModeArc::start(double theta, const Vector& x, const Vector& load) {
  theta_ = theta;
  const ComplexModeFlow& flow = *flow_;
  // A mode without load may have no rate to divide by.
  rest_ = Vector::Zero(x.size());
  if (flow.is_loaded_) {
    const ComplexVector share = flow.inverse_ * load.cast<Complex>();
    rest_ = -(flow.vectors_ * share.cwiseQuotient(flow.values_)).real();
  }
  const Vector forced = (flow.harmonic_ * std::polar(1.0, theta)).real();
  amplitude_ = flow.inverse_ * (x - rest_ - forced).cast<Complex>();
  formed_from_ = flow.inverse_size_ * (rest_.cwiseAbs() + flow.harmonic_size_ + x.cwiseAbs());
}

Vector ComplexModeArc::state(double s) const {
  const ComplexModeFlow& flow = *flow_;
  const ComplexVector grown = amplitude_.cwiseProduct((flow.values_ * s).array().exp().matrix());
  return (flow.vectors_ * grown).real() + rest_ +
         (flow.harmonic_ * std::polar(1.0, theta_ + flow.frequency_ * s)).real();
}

void ComplexModeArc::each_term(const Vector& weight,
                               const std::function<void(Complex, Complex)>& add) const {
  const ComplexModeFlow& flow = *flow_;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k)
    if (!(flow.values_[k].imag() < 0.0))  // else the conjugate of another
      add((flow.values_[k].imag() > 0.0 ? 2.0 : 1.0) * amplitude_[k] *
              weight.cast<Complex>().dot(flow.vectors_.col(k)),
          flow.values_[k]);
  if (flow.frequency_ > 0.0)
    add(weight.cast<Complex>().dot(flow.harmonic_) * std::polar(1.0, theta_),
        Complex(0.0, flow.frequency_));
  if (flow.is_loaded_) add(weight.dot(rest_), 0.0);
}

Complex ComplexModeArc::add_to(ArcCurve<double>& curve, const Vector& weight) const {
  const ComplexModeFlow& flow = *flow_;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    const Complex l = flow.values_[k];
    if (l.imag() < 0.0) continue;  // the conjugate of another
    const Complex share =
        (l.imag() > 0.0 ? 2.0 : 1.0) * weight.cast<Complex>().dot(flow.vectors_.col(k));
    const Complex c = share * amplitude_[k];
    // Growth within the rounding of the eigenvalue counts as none.
    curve.add_exponential({c.real(), c.imag()}, std::max(-l.real(), 0.0), l.imag(),
                          std::abs(share) * formed_from_[k]);
  }
  return weight.cast<Complex>().dot(flow.harmonic_);
}

}  // namespace graze
