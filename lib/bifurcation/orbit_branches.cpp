#include "graze/bifurcation/orbit_branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/bifurcation/orbit_component.hpp"
#include "graze/orbit/closed_form.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {
namespace {

// Where, across the range, the closed form has solutions: the middle of every run of samples with
// |kappa| > |gap| that holds none of `known`. Sampling is cheap beside tracing, so it is fine
// enough to see components that fit between the start values.
std::vector<double> unseen_intervals(const SystemFamily& family, int period, double lowest,
                                     double highest, const std::vector<double>& known) {
  constexpr int kSamples = 2048;
  std::vector<double> middles;
  double begin = 0.0, end = 0.0;
  bool inside = false;
  const auto finish = [&] {
    const bool seen = std::any_of(known.begin(), known.end(),
                                  [&](double value) { return value >= begin && value <= end; });
    if (inside && !seen) middles.push_back(0.5 * (begin + end));
    inside = false;
  };
  for (int i = 0; i <= kSamples; ++i) {
    const double value = lowest + (highest - lowest) * i / kSamples;
    const std::optional<System> system = family.at(value);
    const ClosedFormAnswer answer = system ? closed_form(*system, 0, period) : ClosedFormAnswer{};
    if (!answer.form || std::abs(answer.form->kappa) <= std::abs(system->stops[0].gap)) {
      finish();
      continue;
    }
    if (!inside) begin = value;
    end = value;
    inside = true;
  }
  finish();
  return middles;
}

class OrbitTracer {
 public:
  OrbitTracer(const SystemFamily& family, const BranchOptions& options)
      : family_(family), options_(options) {
    const double lowest = std::min(options.from, options.to);
    const double highest = std::max(options.from, options.to);
    result_.parameter = family.parameter();
    if (family.value() >= lowest && family.value() <= highest) values_.push_back(family.value());
    for (int i = 0; i < options.start_values; ++i)
      values_.push_back(lowest + (highest - lowest) * i / std::max(options.start_values - 1, 1));
    if (options.start_values > 0 && options.finder.from_closed_form) {
      const auto unseen = unseen_intervals(family, options.period, lowest, highest, values_);
      values_.insert(values_.end(), unseen.begin(), unseen.end());
    }
    continuation_.from = options.from;
    continuation_.to = options.to;
    continuation_.max_step = options.max_step;
    continuation_.stop = options.stop;
  }

  OrbitBranches trace() {
    // One scale for all values: the metric of the branch must not change on the way.
    std::optional<System> reference = family_.at(family_.value());
    const ShootingProblem shooting({options_.period, {0}}, shooting_scale(*reference));
    const OrbitComponents components(family_, shooting, continuation_);
    std::vector<Branch> traced;
    for (std::size_t i = 0; i < values_.size() && !options_.stop.requested(); ++i) {
      if (options_.progress)
        options_.progress(static_cast<double>(i) / static_cast<double>(values_.size()));
      for (const Vector& x : starts_at(values_[i], shooting, i == 0)) {
        ++result_.starts;
        const auto start = solve_at(components.problem(), continuation_, x, values_[i]);
        if (!start) continue;
        const bool known = std::any_of(traced.begin(), traced.end(), [&](const Branch& branch) {
          return lies_on(components.problem(), continuation_, branch, *start);
        });
        if (known) continue;
        traced.push_back(trace_branch(components.problem(), continuation_, *start));
        add_component(components, traced.back(), static_cast<int>(traced.size()));
      }
    }
    number_special_points();
    // What the simulation does is worth a line only where it explains that there is nothing else.
    if (!result_.branches.empty()) result_.notes.clear();
    result_.stopped = options_.stop.reason();
    return std::move(result_);
  }

 private:
  // Solutions at one value; the simulation and the random guesses join in at the first one only.
  std::vector<Vector> starts_at(double value, const ShootingProblem& shooting, bool first) {
    std::vector<Vector> starts;
    const std::optional<System> system = family_.at(value);
    if (!system) return starts;
    FinderOptions finder = options_.finder;
    finder.period = options_.period;
    finder.impacts = 1;
    finder.keep_virtual = true;
    finder.stop = options_.stop;
    if (!first) {
      finder.from_simulation = false;
      finder.from_random = finder.from_random && !finder.from_closed_form;
    }
    State rest{Vector::Zero(system->modes()), Vector::Zero(system->modes())};
    if (first && finder.from_simulation) {
      try {
        rest = initial_state(family_.scene(), *system);
      } catch (const InputError&) {
        finder.from_simulation = false;  // nothing to simulate from; the other starts remain
      }
    }
    const FoundOrbits found = find_orbits(*system, rest, finder);
    for (const Orbit& orbit : found.orbits) starts.push_back(shooting.pack(orbit.points()));
    if (first) result_.notes = found.notes;
    return starts;
  }

  void add_component(const OrbitComponents& components, const Branch& branch, int component) {
    ++result_.components;
    const auto is_cut = [](BranchEnd end) {
      return end == BranchEnd::kStepLimit || end == BranchEnd::kNotConverged;
    };
    bool cut = std::any_of(branch.ends.begin(), branch.ends.end(), is_cut);
    result_.shooting_evaluations += branch.evaluations;
    result_.rejected_steps += branch.rejected;
    for (OrbitBranch& part : components.parts(branch, options_.keep_virtual)) {
      cut = cut || part.ends[0] == OrbitBranchEnd::kNotConverged ||
            part.ends[1] == OrbitBranchEnd::kNotConverged;
      part.component = component;
      part.id = static_cast<int>(result_.branches.size()) + 1;
      result_.branches.push_back(std::move(part));
    }
    if (cut) ++result_.cut_short;
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
  ContinuationOptions continuation_;
  std::vector<double> values_;
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
    for (Eigen::Index at = 0; at < problem.wrap.size(); at += block)
      problem.wrap[at] = 2.0 * std::numbers::pi;
  return problem;
}

OrbitBranches trace_orbits(const SystemFamily& family, const BranchOptions& options) {
  return OrbitTracer(family, options).trace();
}

}  // namespace graze
