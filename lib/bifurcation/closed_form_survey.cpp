#include "graze/bifurcation/closed_form_survey.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/orbit.hpp"

namespace graze {
namespace {

// Samples fall with the number of modes so that a survey takes about a second at most.
int samples_for(int modes) { return std::clamp(16384 / modes, 512, 4096); }

}  // namespace

ClosedFormSurvey::ClosedFormSurvey(const SystemFamily& family, int stop, int period, double lowest,
                                   double highest, bool admissible_only)
    : family_(family),
      stop_(stop),
      period_(period),
      samples_(samples_for(family.scene().modes())),
      lowest_(lowest),
      spacing_((highest - lowest) / samples_) {
  std::array<std::vector<Start>, 2> runs;  // of the two solutions
  const auto finish = [&](std::vector<Start>& run) {
    if (!run.empty()) starts_.push_back(run[run.size() / 2]);
    run.clear();
  };
  bool inside = false;
  for (int i = 0; i <= samples_; ++i) {
    const double value = i == samples_ ? highest : lowest + i * spacing_;
    const std::optional<System> system = family.at(value);
    const ClosedFormAnswer answer =
        system ? closed_form(*system, stop, period) : ClosedFormAnswer{};
    std::vector<ImpactPoint> solutions;
    if (answer.form)
      solutions = answer.form->solutions(system->stops[static_cast<std::size_t>(stop_)].gap);
    if (!solutions.empty() && !inside) intervals_.push_back({i, i});
    inside = !solutions.empty();
    if (inside) intervals_.back().last = i;
    for (std::size_t k = 0; k < 2; ++k) {
      const bool wanted =
          inside &&
          (!admissible_only || admissibility(*system, {period, {stop}}, {solutions[k]}).admissible);
      if (wanted)
        runs[k].push_back({value, solutions[k]});
      else
        finish(runs[k]);
    }
  }
  for (std::vector<Start>& run : runs) finish(run);
}

std::optional<int> ClosedFormSurvey::component(double value, double phase) const {
  const double at = (value - lowest_) / spacing_;
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    const Interval& interval = intervals_[k];
    // A branch reaches beyond the outermost samples of its interval, but not to the next ones.
    if (at <= interval.first - 1 || at >= interval.last + 1) continue;
    const int name = 2 * static_cast<int>(k);
    const bool folds = interval.first > 0 || interval.last < samples_;
    const std::optional<System> system = family_.at(value);
    if (folds || !system) return name;
    const ClosedFormAnswer answer = closed_form(*system, stop_, period_);
    if (!answer.form) return name;
    const std::vector<ImpactPoint> solutions =
        answer.form->solutions(system->stops[static_cast<std::size_t>(stop_)].gap);
    if (solutions.empty()) return name;
    const auto distance = [&](const ImpactPoint& point) {
      return std::abs(std::remainder(point.theta - phase, kTurn));
    };
    return distance(solutions[0]) <= distance(solutions[1]) ? name : name + 1;
  }
  return {};
}

}  // namespace graze
