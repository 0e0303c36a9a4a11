#include "graze/study/compare/sensitivity.hpp"

#include <limits>

#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

void compare(SensitivityCurve& curve) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto values = static_cast<Eigen::Index>(curve.runs.size());
  const auto probes = static_cast<Eigen::Index>(curve.reference.ends.size());
  curve.s1 = curve.s2 = Matrix::Constant(values, probes, kNone);
  for (Eigen::Index i = 0; i < probes; ++i) {
    const auto probe = static_cast<std::size_t>(i);
    double mean = 0.0;
    for (const ValueRun& run : curve.runs)
      mean += (run.outcome == RunOutcome::kReachedEnd ? run.peaks[probe] : kNone) /
              static_cast<double>(values);
    const bool has_reference = curve.reference.outcome == RunOutcome::kReachedEnd;
    const double reference = has_reference ? curve.reference.ends[probe] : kNone;
    for (Eigen::Index k = 0; k < values; ++k) {
      const ValueRun& run = curve.runs[static_cast<std::size_t>(k)];
      if (mean != 0.0) curve.s1(k, i) = run.peaks[probe] / mean - 1.0;
      if (run.outcome == RunOutcome::kReachedEnd && reference != 0.0)
        curve.s2(k, i) = 1.0 - run.ends[probe] / reference;
    }
  }
}

}  // namespace

std::vector<SensitivityCurve> sensitivities(const Scene& scene, const SensitivityOptions& options) {
  std::vector<double> seconds = options.seconds;
  if (options.second.empty()) seconds = {0.0};
  std::vector<SensitivityCurve> curves;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const Scene own =
        options.second.empty() ? scene : with_parameter(scene, options.second, seconds[i]);
    RunSeriesOptions series = options.series;
    series.values.push_back(options.reference);
    if (options.series.progress)
      series.progress = [&](double part) {
        options.series.progress((static_cast<double>(i) + part) /
                                static_cast<double>(seconds.size()));
      };
    SensitivityCurve curve;
    curve.second = seconds[i];
    curve.runs = run_series(own, series);
    if (curve.runs.size() < series.values.size()) break;  // means want all of them
    curve.reference = std::move(curve.runs.back());
    curve.runs.pop_back();
    compare(curve);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace graze
