#include "graze/bifurcation/bounds/detail/closed_form_survey.hpp"

#include <algorithm>
#include <array>

#include "graze/base/stop_scope.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {
namespace {

// Samples over the range fall with the number of modes so that they take about a second at most.
int samples_for(int modes) { return std::clamp(16384 / modes, 512, 4096); }

// Samples of an interval that has fewer of those.
constexpr int kLeastOfRange = 16;

}  // namespace

ClosedFormSurvey::ClosedFormSurvey(const SystemFamily& family, int stop, int period, double lowest,
                                   double highest)
    : family_(family),
      stop_(stop),
      period_(period),
      ranges_(family, stop, period, lowest, highest) {}

std::vector<ImpactPoint> ClosedFormSurvey::solutions_at(double value,
                                                        std::optional<System>& system) const {
  system = family_.at(value);
  if (!system) return {};
  const ClosedFormAnswer answer = closed_form(*system, stop_, period_);
  if (!answer.form) return {};
  return answer.form->solutions(system->stops[static_cast<std::size_t>(stop_)].gap);
}

void ClosedFormSurvey::start_in_every_range() {
  for (const SolutionRanges::Range& range : ranges_.ranges()) {
    const double value = range.from + 0.5 * (range.to - range.from);
    std::optional<System> system;
    for (const ImpactPoint& point : solutions_at(value, system)) starts_.push_back({value, point});
  }
}

void ClosedFormSurvey::start_in_every_run() {
  const int over_all = samples_for(family_.scene().modes());
  spacing_ = ranges_.length() / over_all;
  for (const SolutionRanges::Range& range : ranges_.ranges()) {
    const double width = range.to - range.from;
    const int count = std::max(kLeastOfRange, static_cast<int>(width / spacing_) + 1);
    std::array<std::vector<Start>, 2> runs;  // of the two solutions
    const auto finish = [&](std::vector<Start>& run) {
      if (!run.empty()) starts_.push_back(run[run.size() / 2]);
      run.clear();
    };
    for (int i = 0; i <= count; ++i) {
      if (StopScope::current().requested()) break;
      const double value = i == count ? range.to : range.from + width * i / count;
      std::optional<System> system;
      const std::vector<ImpactPoint> solutions = solutions_at(value, system);
      ++samples_;
      for (std::size_t k = 0; k < 2; ++k) {
        if (k < solutions.size() &&
            admissibility(*system, {period_, {stop_}}, {solutions[k]}).admissible)
          runs[k].push_back({value, solutions[k]});
        else
          finish(runs[k]);
      }
    }
    for (std::vector<Start>& run : runs) finish(run);
  }
}

}  // namespace graze
