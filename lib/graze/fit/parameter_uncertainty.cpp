#include "graze/fit/detail/parameter_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "graze/fit/detail/jacobian_factors.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

constexpr double kTail = 0.025;     // on either side of a 95 % interval
constexpr double kUnlikely = 0.01;  // what is less likely is said
// A deviation of a normal distribution that is exceeded once in a hundred, on either side.
constexpr double kUnlikelyDeviation = 2.576;

std::vector<Eigen::Index> free_parameters(const FitResult& result) {
  std::vector<Eigen::Index> free;
  for (std::size_t j = 0; j < result.parameters.size(); ++j)
    if (!result.parameters[j].at_limit) free.push_back(static_cast<Eigen::Index>(j));
  return free;
}

std::string untold_sentence(const FitResult& result, const std::vector<Eigen::Index>& parts) {
  std::vector<std::string> names;
  for (const Eigen::Index j : parts)
    names.push_back(result.parameters[static_cast<std::size_t>(j)].name);
  if (names.size() == 1) return fmt::format("the data do not determine {}", names[0]);
  return fmt::format("the data determine only a combination of {}", joined(names, "and"));
}

void set_uncertainties(const Matrix& covariance, const std::vector<Eigen::Index>& told,
                       FitResult& result) {
  for (std::size_t a = 0; a < told.size(); ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    FittedParameter& parameter = result.parameters[static_cast<std::size_t>(told[a])];
    parameter.uncertainty = std::sqrt(covariance(i, i));
    parameter.interval_low = parameter.value - result.quantile * *parameter.uncertainty;
    parameter.interval_high = parameter.value + result.quantile * *parameter.uncertainty;
    for (std::size_t b = 0; b < told.size(); ++b) {
      const auto k = static_cast<Eigen::Index>(b);
      const double size = std::sqrt(covariance(i, i) * covariance(k, k));
      result.correlations(told[a], told[b]) = a == b       ? 1.0
                                              : size > 0.0 ? covariance(i, k) / size
                                                           : 0.0;
    }
  }
}

// Correlation of neighbouring residuals; for m independent ones it is normal with deviation
// 1/sqrt(m).
double neighbour_correlation(const Vector& residuals) {
  const Eigen::Index pairs = residuals.size() - 1;
  return residuals.head(pairs).dot(residuals.tail(pairs)) / residuals.squaredNorm();
}

void warn_of_neighbours(const Vector& residuals, FitResult& result) {
  const Eigen::Index rows = result.at.size();
  for (std::size_t k = 0; k < result.series.size(); ++k) {
    const Vector part = residuals.segment(static_cast<Eigen::Index>(k) * rows, rows);
    // A few values show nothing, and rounding has a pattern of its own.
    if (rows < 20 || !(part.norm() > 1e-9 * std::sqrt(static_cast<double>(rows)))) continue;
    const double correlation = neighbour_correlation(part);
    if (correlation * std::sqrt(static_cast<double>(rows)) <= kUnlikelyDeviation) continue;
    result.warnings.push_back(fmt::format(
        "{}: residuals follow one another (correlation of neighbours {:.2f}); something is left "
        "that the model does not have, or the noise is not that of single values, and the "
        "uncertainties are too small",
        result.series[k].name, correlation));
  }
}

void warn_of_size(FitResult& result) {
  if (!result.knows_uncertainty || result.freedom < 1) return;
  const boost::math::chi_squared law(static_cast<double>(result.freedom));
  const double above = boost::math::cdf(boost::math::complement(law, result.sum_of_squares));
  const double ratio = std::sqrt(result.sum_of_squares / static_cast<double>(result.freedom));
  if (above < kUnlikely)
    result.warnings.push_back(fmt::format(
        "the residuals are {:.3g} times as large as the uncertainties of the data say (less likely "
        "than 1 in 100): the model misses something, or the uncertainties are too small",
        ratio));
  else if (above > 1.0 - kUnlikely)
    result.warnings.push_back(fmt::format(
        "the residuals are only {:.3g} times as large as the uncertainties of the data say: these "
        "are too large, and so are those of the parameters",
        ratio));
}

}  // namespace

double confidence_quantile(long long freedom) {
  using boost::math::complement;
  if (freedom <= 0) return boost::math::quantile(complement(boost::math::normal(), kTail));
  return boost::math::quantile(
      complement(boost::math::students_t(static_cast<double>(freedom)), kTail));
}

void judge_parameters(const LeastSquaresResult& solved, FitResult& result) {
  const auto count = static_cast<Eigen::Index>(result.parameters.size());
  result.correlations = Matrix::Constant(count, count, std::numeric_limits<double>::quiet_NaN());
  if (solved.jacobian.matrix.size() == 0) return;
  const std::vector<Eigen::Index> free = free_parameters(result);
  if (free.empty()) return;
  const JacobianFactors factors(solved.jacobian.matrix(Eigen::all, free), solved.jacobian.error);
  std::set<Eigen::Index> untold;
  for (std::vector<Eigen::Index> parts : factors.untold()) {
    for (Eigen::Index& j : parts) j = free[static_cast<std::size_t>(j)];
    untold.insert(parts.begin(), parts.end());
    result.end = FitEnd::kNotDetermined;
    result.message += (result.message.empty() ? "" : "; ") + untold_sentence(result, parts);
  }
  std::vector<Eigen::Index> told;
  std::copy_if(free.begin(), free.end(), std::back_inserter(told),
               [&](Eigen::Index j) { return !untold.count(j); });
  if (told.empty()) return;
  const JacobianFactors known(solved.jacobian.matrix(Eigen::all, told), solved.jacobian.error);
  if (known.rank() < static_cast<Eigen::Index>(told.size())) return;
  const double variance =
      result.knows_uncertainty
          ? 1.0
          : result.sum_of_squares / static_cast<double>(std::max(result.freedom, 1LL));
  set_uncertainties(variance * known.inverse_normal(), told, result);
}

void judge_residuals(const Vector& residuals, FitResult& result) {
  warn_of_size(result);
  warn_of_neighbours(residuals, result);
  for (const FittedParameter& parameter : result.parameters) {
    if (parameter.at_limit)
      result.warnings.push_back(fmt::format(
          "{} is held at its limit {:g}, beyond which the fit would be better: it has no "
          "uncertainty, and those of the others hold for this value of it",
          parameter.name, parameter.value));
    else if (parameter.uncertainty && parameter.interval_low < parameter.low &&
             parameter.interval_high > parameter.high)
      result.warnings.push_back(
          fmt::format("{}: its interval is wider than its limits; the data hardly determine it",
                      parameter.name));
  }
}

}  // namespace graze
