#include "graze/bifurcation/bounds/detail/speed_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graze/assembly/detail/system_interpolant.hpp"
#include "graze/base/interval/detail/isolated_zeros.hpp"
#include "graze/bifurcation/bounds/detail/one_impact_form.hpp"
#include "graze/orbit/closed_form/detail/periodic_response.hpp"

namespace graze {
namespace {

// Number of values over the range: a few milliseconds for each mode.
constexpr int kValues = 1025;

// Most cells for the speeds at one value: some fifty are usual.
constexpr long long kMostCells = 4096;

// r(v), clamped to [0, 1], over a cell of speeds.
MeanValueForm restitution_over(const Restitution& restitution, const MeanValueForm& v) {
  const std::vector<double>& a = restitution.coefficients();
  MeanValueForm sum = 0.0;
  for (std::size_t i = a.size(); i-- > 1;) sum = (sum + a[i]) * v;
  const MeanValueForm r = MeanValueForm(a.front()) - sum;
  const auto clamped = [](const Interval& x) {
    return Interval(std::clamp(x.low, 0.0, 1.0), std::clamp(x.high, 0.0, 1.0));
  };
  const bool inside = r.value.low >= 0.0 && r.value.high <= 1.0;
  const bool outside = r.value.high <= 0.0 || r.value.low >= 1.0;
  const Interval slope = inside ? r.slope
                         : outside
                             ? Interval(0.0)
                             : Interval(std::min(r.slope.low, 0.0), std::max(r.slope.high, 0.0));
  return {clamped(r.middle), clamped(r.value), slope, r.reach};
}

// The equation of the speeds at one value.
class SpeedEquation {
 public:
  SpeedEquation(const System& system, const OneImpactForm& form, int stop)
      : restitution_(system.stops[static_cast<std::size_t>(stop)].restitution()),
        frequency_(system.forcing()->frequency),
        forced_(form.forced_real.middle.middle(), form.forced_imaginary.middle.middle()),
        displaced_(form.displaced.middle.middle()),
        returned_(form.returned.middle.middle()),
        level_(form.level.middle.middle()) {}

  MeanValueForm over(double low, double high) const {
    const MeanValueForm v = low < high ? MeanValueForm::variable(low, high) : MeanValueForm(low);
    const MeanValueForm u = v * (restitution_over(restitution_, v) + 1.0);
    return square(u * displaced_ + level_) + square((v + u * returned_) / frequency_) -
           std::norm(forced_);
  }

  // No speed is larger: |a + g u| and |v + H u|/Omega are |A| at most, and |v| <= |u| <= 2 |v|.
  std::optional<double> largest() const {
    const double reach = std::abs(forced_);
    double most = std::numeric_limits<double>::infinity();
    if (displaced_ != 0.0) most = (reach + std::abs(level_)) / std::abs(displaced_);
    const double least_rate = 1.0 + std::min(2.0 * returned_, returned_);
    if (least_rate > 0.0) most = std::min(most, frequency_ * reach / least_rate);
    if (!std::isfinite(most)) return {};
    return most;
  }

  double impulse(double v) const { return restitution_.jump(v); }
  double phase(double v) const {
    const double u = impulse(v);
    const Complex turned(level_ + displaced_ * u, -(v + returned_ * u) / frequency_);
    return std::arg(turned / forced_);
  }

 private:
  const Restitution& restitution_;
  double frequency_;
  Complex forced_;
  double displaced_, returned_, level_;
};

class Survey {
 public:
  Survey(const SystemFamily& family, int stop, int period, bool with_virtual)
      : cursor_(family), stop_(stop), period_(period), with_virtual_(with_virtual) {}

  void look_at(double value, const SystemForms& forms) {
    ++result.values;
    const System* system = cursor_.at(value);
    const auto form = one_impact_form(forms, stop_, period_);
    const PeriodicResponseAnswer answer =
        system != nullptr ? periodic_response(*system, period_) : PeriodicResponseAnswer{};
    if (!form || form->free_mass || form->has_factors || !answer.response) {
      ++result.unsolved;
      return;
    }
    const SpeedEquation equation(*system, *form, stop_);
    const std::optional<double> largest = equation.largest();
    if (!largest || !(*largest > 0.0)) {
      result.unsolved += largest ? 0 : 1;
      return;
    }
    const auto f = [&](double low, double high) { return std::optional(equation.over(low, high)); };
    const IsolatedZeros speeds =
        isolated_zeros(f, with_virtual_ ? -*largest : 0.0, *largest, kMostCells);
    if (speeds.undecided > 0) ++result.unsolved;
    for (const double v : speeds.zeros) {
      const double theta = equation.phase(v), u = equation.impulse(v);
      State before = answer.response->forced_state(theta);
      const State kick = answer.response->impulse_state(stop_, answer.response->duration());
      before.q -= u * kick.q;
      before.qdot -= u * kick.qdot;
      result.starts.push_back({value, {theta, before}});
    }
  }

  SpeedSurvey result;

 private:
  SystemCursor cursor_;
  int stop_, period_;
  bool with_virtual_;
};

}  // namespace

SpeedSurvey survey_speeds(const SystemFamily& family, int stop, int period, double lowest,
                          double highest, bool with_virtual) {
  const SystemInterpolant interpolant(family, lowest, highest);
  Survey survey(family, stop, period, with_virtual);
  survey.result.spacing = (highest - lowest) / (kValues - 1);
  auto piece = interpolant.pieces().begin();
  for (int i = 0; i < kValues; ++i) {
    const double value =
        i + 1 == kValues ? highest : std::min(highest, lowest + i * survey.result.spacing);
    while (value > piece->high) ++piece;
    if (piece->exists()) survey.look_at(value, interpolant.over(*piece, value, value));
  }
  return std::move(survey.result);
}

}  // namespace graze
