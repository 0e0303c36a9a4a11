#include "graze/bifurcation/orbit_branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "graze/base/angle.hpp"
#include "graze/bifurcation/closed_form_survey.hpp"
#include "graze/bifurcation/orbit_component.hpp"
#include "graze/orbit/closed_form.hpp"

namespace graze {
namespace {

class OrbitTracer {
 public:
  OrbitTracer(const SystemFamily& family, const BranchOptions& options)
      : family_(family),
        options_(options),
        lowest_(std::min(options.from, options.to)),
        highest_(std::max(options.from, options.to)),
        // One scale for all values: the metric of the branch must not change on the way.
        shooting_({options.period, {0}}, shooting_scale(*family.at(family.value()))),
        components_(family, shooting_, continuation_) {
    result_.parameter = family.parameter();
    continuation_.from = options.from;
    continuation_.to = options.to;
    continuation_.max_step = options.max_step;
    continuation_.stop = options.stop;
    if (!options.keep_virtual)
      continuation_.proceed = [this](const BranchPoint& point) { return is_orbit(point); };
  }

  OrbitBranches trace() {
    trace_from_values();
    if (options_.start_values > 0 && options_.finder.from_closed_form) trace_from_survey();
    put_in_order();
    name_components();
    number_special_points();
    // What the simulation does is worth a line only where it explains that there is nothing else.
    if (!result_.branches.empty()) result_.notes.clear();
    result_.stopped = options_.stop.reason();
    return std::move(result_);
  }

 private:
  // The scene's own value, and values spread over the range.
  void trace_from_values() {
    std::vector<double> values;
    if (family_.value() >= lowest_ && family_.value() <= highest_)
      values.push_back(family_.value());
    for (int i = 0; i < options_.start_values; ++i)
      values.push_back(lowest_ + (highest_ - lowest_) * i / std::max(options_.start_values - 1, 1));
    for (std::size_t i = 0; i < values.size() && !options_.stop.requested(); ++i) {
      if (options_.progress)
        options_.progress(static_cast<double>(i) / static_cast<double>(values.size() + 1));
      for (const Vector& x : starts_at(values[i], i == 0)) trace_from(values[i], x);
    }
  }

  void trace_from_survey() {
    survey_.emplace(family_, options_.period, lowest_, highest_, !options_.keep_virtual);
    result_.surveyed_values = survey_->samples();
    for (const ClosedFormSurvey::Start& start : survey_->starts()) {
      if (options_.stop.requested()) return;
      trace_from(start.value, shooting_.pack({start.point}));
    }
  }

  // Traces the branch through the solution near x, unless it is known already or is none.
  void trace_from(double value, const Vector& x) {
    ++result_.starts;
    const auto start = solve_at(components_.problem(), continuation_, x, value);
    if (!start || (!options_.keep_virtual && !is_orbit(*start))) return;
    for (const Branch& branch : traced_)
      if (lies_on(components_.problem(), continuation_, branch, *start)) return;
    traced_.push_back(trace_branch(components_.problem(), continuation_, *start));
    add_parts(traced_.back());
  }

  bool is_orbit(const BranchPoint& point) const {
    return components_.admissibility_at(point).admissible;
  }

  // Solutions at one value; the simulation and the random guesses join in at the first one only.
  std::vector<Vector> starts_at(double value, bool first) {
    std::vector<Vector> starts;
    const std::optional<System> system = family_.at(value);
    if (!system) return starts;
    FinderOptions finder = options_.finder;
    finder.period = options_.period;
    finder.impacts = 1;
    finder.keep_virtual = true;
    finder.stop = options_.stop;
    if (!first) {
      // Random guesses cost more than all else; elsewhere they stand in where the closed form
      // cannot.
      const bool closed = finder.from_closed_form && closed_form(*system, 0, options_.period).form;
      finder.from_random = finder.from_random && !closed;
    }
    std::optional<State> start;
    if (first) start = clear_start(family_.scene(), *system);
    const FoundOrbits found = find_orbits(*system, start, finder);
    for (const Orbit& orbit : found.orbits)
      if (!orbit.sticking) starts.push_back(shooting_.pack(orbit.points()));
    if (first) result_.notes = found.notes;
    return starts;
  }

  void add_parts(const Branch& branch) {
    const auto is_cut = [](BranchEnd end) {
      return end == BranchEnd::kStepLimit || end == BranchEnd::kNotConverged;
    };
    bool cut = std::any_of(branch.ends.begin(), branch.ends.end(), is_cut);
    result_.shooting_evaluations += branch.evaluations;
    result_.rejected_steps += branch.rejected;
    for (OrbitBranch& part : components_.parts(branch, options_.keep_virtual)) {
      cut = cut || part.ends[0] == OrbitBranchEnd::kNotConverged ||
            part.ends[1] == OrbitBranchEnd::kNotConverged;
      part.component = static_cast<int>(traced_.size());
      result_.branches.push_back(std::move(part));
    }
    ++result_.traced;
    if (cut) ++result_.cut_short;
  }

  // By lowest parameter value, whatever start found them.
  void put_in_order() {
    const auto lowest = [](const OrbitBranch& branch) {
      const auto less = [](const OrbitBranchPoint& a, const OrbitBranchPoint& b) {
        return a.value < b.value;
      };
      return std::min_element(branch.points.begin(), branch.points.end(), less)->value;
    };
    std::stable_sort(
        result_.branches.begin(), result_.branches.end(),
        [&](const OrbitBranch& a, const OrbitBranch& b) { return lowest(a) < lowest(b); });
    int id = 0;
    for (OrbitBranch& branch : result_.branches) branch.id = ++id;
  }

  // Branches that were traced apart may be parts of one component, connected where the solutions
  // are no orbits; the closed form knows. Numbers follow the order of appearance.
  void name_components() {
    std::map<int, int> numbers;
    for (OrbitBranch& branch : result_.branches) {
      const OrbitBranchPoint& middle = branch.points[branch.points.size() / 2];
      const std::optional<int> name =
          survey_ && !options_.keep_virtual
              ? survey_->component(middle.value, middle.orbit.impacts.front().phase)
              : std::nullopt;
      const int key = name ? *name : -branch.component;
      branch.component =
          numbers.try_emplace(key, static_cast<int>(numbers.size()) + 1).first->second;
    }
  }

  void number_special_points() {
    int folds = 0, grazings = 0;
    for (OrbitBranch& branch : result_.branches)
      for (SpecialPoint& special : branch.special)
        special.id = special.kind == SpecialKind::kFold ? fmt::format("LP{}", ++folds)
                                                        : fmt::format("GR{}", ++grazings);
  }

  const SystemFamily& family_;
  const BranchOptions& options_;
  double lowest_, highest_;
  ShootingProblem shooting_;
  ContinuationOptions continuation_;
  OrbitComponents components_;
  std::optional<ClosedFormSurvey> survey_;
  std::vector<Branch> traced_;
  OrbitBranches result_;
};

}  // namespace

ZeroProblem orbit_problem(const SystemFamily& family, const ShootingProblem& shooting) {
  ZeroProblem problem;
  problem.evaluate = [&family, &shooting](const Vector& u,
                                          double value) -> std::optional<ZeroEvaluation> {
    const std::optional<System> system = family.at(value);
    if (!system) return {};
    const std::optional<System> tangent = family.tangent_at(value);
    ZeroEvaluation at;
    at.residual = shooting.residual(*system, u, &at.jacobian, &*tangent, &at.parameter_derivative);
    return at;
  };
  const std::optional<System> system = family.at(family.value());
  const Eigen::Index block = 2 * system->modes() + 1;
  problem.wrap = Vector::Zero(shooting.size(*system));
  // A whole orbit's phases move together; only the first can wrap on its own, and for k = 1 it is
  // the only one.
  if (shooting.pattern().impacts() == 1)
    for (Eigen::Index at = 0; at < problem.wrap.size(); at += block) problem.wrap[at] = kTurn;
  return problem;
}

OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options) {
  return OrbitTracer(family, options).trace();
}

}  // namespace graze
