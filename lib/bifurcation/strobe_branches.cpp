#include "graze/bifurcation/strobe_branches.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "graze/assembly/initial_state.hpp"
#include "graze/bifurcation/found_branches.hpp"
#include "graze/bifurcation/strobe_parts.hpp"
#include "graze/bifurcation/strobe_pieces.hpp"
#include "graze/continuation/switching.hpp"
#include "graze/hybrid/simulation.hpp"

namespace graze {
namespace {

class StrobeTracer {
 public:
  StrobeTracer(const SystemFamily& family, const BranchOptions& options)
      : family_(family), options_(options), own_(*family.at(family.value())) {
    result_.parameter = family.parameter();
    result_.scale = motion_scale(own_);
    result_.range = std::abs(options.to - options.from);
    range_.from = options.from;
    range_.to = options.to;
    range_.max_step = options.max_step;
    range_.stop = options.stop;
    strobe_.max_impacts = options.finder.max_impacts;
    strobe_.stop = options.stop;
    const State at_rest{Vector::Zero(own_.modes()), Vector::Zero(own_.modes())};
    const State start = clear_start(family.scene(), own_).value_or(at_rest);
    strobe_.closure_speed = options.finder.closure_speed.value_or(
        default_closure_speed(own_, start, family.scene().solver.tolerance));
  }

  OrbitBranches trace() {
    if (options_.start)
      trace_from_special(*options_.start);
    else
      trace_from_values();
    follow();
    const double speed = result_.scale.speed;
    result_.branches = put_in_order(std::move(found_), Components(result_.range, speed),
                                    [](const OrbitBranch&) { return std::nullopt; });
    result_.stopped = options_.stop.reason();
    return std::move(result_);
  }

 private:
  struct Traced {
    const PassageEquations* equations;
    Branch branch;
  };

  // The scene's own, and values spread over the range.
  std::vector<double> start_values() const {
    const double low = std::min(options_.from, options_.to),
                 high = std::max(options_.from, options_.to);
    std::vector<double> values;
    if (family_.value() >= low && family_.value() <= high) values.push_back(family_.value());
    for (int i = 0; i < options_.start_values; ++i)
      values.push_back(low + (high - low) * i / std::max(options_.start_values - 1, 1));
    return values;
  }

  // First from the closed forms, which cost next to nothing, then from simulations, which may never
  // settle: whoever stops them has the branches of the former.
  void trace_from_values() {
    FinderOptions quick = options_.finder, slow = options_.finder;
    quick.from_simulation = quick.from_random = false;
    slow.from_closed_form = false;
    const std::vector<double> values = start_values();
    double done = 0.0;
    for (const FinderOptions* finder : {&quick, &slow})
      for (const double value : values) {
        if (options_.stop.requested()) return;
        if (options_.progress)
          options_.progress(done++ / (2.0 * static_cast<double>(values.size())));
        trace_at(value, *finder);
        // Random starts cost more than all else: at the first value only.
        if (finder == &slow) slow.from_random = false;
      }
  }

  // At the family's own value.
  void trace_from_special(const BranchStart& start) {
    if (!start.at.followed || start.at.sticks()) {
      result_.notes.push_back("the point is of orbits on rigid stops, and these give way");
      return;
    }
    ++result_.starts;
    PassageEquations& equations = equations_of(start.at.followed->period);
    std::vector<State> turns;
    for (const MotionState<double>& at : start.at.followed->states)
      turns.push_back({at.q, at.qdot});
    const Vector u = equations.shooting().pack(turns);
    const std::optional<BranchPoint> point =
        solve_near(equations.problem(), range_, u, family_.value());
    const bool doubles = start.at.kind == SpecialKind::kPeriodDoubling;
    if (!point)
      result_.notes.push_back("the orbit there was not found again");
    else if (!start.switched)
      add(equations, *point, Directions::kBoth, -1, 0);
    else if (!doubles ||
             !switch_from(equations, {CriticalKind::kPeriodDoubling, *point, 0, {}}, -1, 0))
      result_.notes.push_back("no other branch was found there");
  }

  PassageEquations& equations_of(int period, double section = 0.0) {
    auto& place = equations_[{period, section}];
    if (!place) {
      const double range = result_.range > 0.0 ? result_.range : 1.0;
      place = std::make_unique<PassageEquations>(family_.scene(), std::vector{family_.parameter()},
                                                 std::vector{range}, own_,
                                                 PassageLayout::strobe(period, section), strobe_);
    }
    return *place;
  }

  void trace_at(double value, FinderOptions finder) {
    const std::optional<System> system = family_.at(value);
    if (!system) return;
    finder.period = options_.period;
    finder.impacts = options_.impacts;
    finder.stop = options_.stop;
    finder.closure_speed = strobe_.closure_speed;
    const FoundOrbits found = find_orbits(*system, clear_start(family_.scene(), *system), finder);
    if (result_.notes.empty()) result_.notes = found.notes;
    for (const Orbit& orbit : found.orbits) {
      ++result_.starts;
      PassageEquations& equations = equations_of(orbit.period);
      const std::optional<BranchPoint> start =
          solve_at(equations.problem(), range_, equations.shooting().pack(turns_of(orbit)), value);
      if (start && !knows(equations, *start)) add(equations, *start, Directions::kBoth, -1, 0);
    }
  }

  // A solution begins with any of its turns.
  bool knows(const PassageEquations& equations, const BranchPoint& point) const {
    const Eigen::Index n = equations.map().size(), size = point.u.size();
    for (const Traced& traced : traced_) {
      if (traced.equations->period() != equations.period()) continue;
      const std::optional<BranchPoint> there =
          traced.equations == &equations ? point
                                         : equations.carried_to(*traced.equations, range_, point);
      if (!there) continue;
      BranchPoint turned = *there;
      for (Eigen::Index first = 0; first < size; first += n) {
        turned.u << there->u.tail(size - first), there->u.head(first);
        if (first > 0) {
          turned.tangent.head(size) << there->tangent.segment(first, size - first),
              there->tangent.head(first);
        }
        if (lies_on(traced.equations->problem(), range_, traced.branch, turned)) return true;
      }
    }
    return false;
  }

  void add(PassageEquations& equations, const BranchPoint& start, Directions directions,
           int origin_branch, std::size_t origin_special) {
    const AtSection at_section = [&](double section) -> PassageEquations& {
      return equations_of(equations.period(), section);
    };
    std::vector<StrobePart> parts;
    for (StrobePiece& piece : trace_pieces(at_section, equations, range_, start, directions)) {
      result_.shooting_evaluations += piece.branch.evaluations;
      result_.rejected_steps += piece.branch.rejected;
      append_parts(parts, parts_of(*piece.equations, range_, piece.branch));
      traced_.push_back({piece.equations, std::move(piece.branch)});
    }
    const auto cuts = [](OrbitBranchEnd end) {
      return end == OrbitBranchEnd::kNotConverged || end == OrbitBranchEnd::kStepLimit;
    };
    bool cut = false;
    for (StrobePart& part : parts) {
      cut = cut || cuts(part.branch.ends[0]) || cuts(part.branch.ends[1]);
      critical_.push_back(std::move(part.critical));
      on_.push_back(std::move(part.on));
      found_.push_back(
          {std::move(part.branch), nullptr, result_.traced, origin_branch, origin_special});
    }
    ++result_.traced;
    if (cut) ++result_.cut_short;
    if (origin_branch >= 0) ++result_.switched;
  }

  // Onto doubled orbits and crossing branches, those of one depth after the other.
  void follow() {
    std::size_t first = 0;
    for (int depth = 0; depth < options_.follow_depth; ++depth) {
      const std::size_t last = found_.size();
      for (std::size_t i = first; i < last; ++i)
        for (std::size_t k = 0; k < critical_[i].size() && !options_.stop.requested(); ++k)
          if (critical_[i][k]) switch_at(i, k);
      first = last;
    }
    for (std::size_t i = first; i < found_.size() && options_.follow_depth > 0; ++i)
      for (const auto& critical : critical_[i]) result_.left_open += leads_on(critical) ? 1 : 0;
  }

  static bool leads_on(const std::optional<CriticalPoint>& critical) {
    return critical && (critical->kind == CriticalKind::kPeriodDoubling ||
                        critical->kind == CriticalKind::kBranchPoint);
  }

  void switch_at(std::size_t index, std::size_t which) {
    if (leads_on(critical_[index][which]))
      switch_from(*on_[index][which], *critical_[index][which], static_cast<int>(index), which);
  }

  // Whether another branch leads away from there that was not known.
  bool switch_from(PassageEquations& known, CriticalPoint critical, int origin_branch,
                   std::size_t origin_special) {
    const bool doubles = critical.kind == CriticalKind::kPeriodDoubling;
    PassageEquations& equations =
        doubles ? equations_of(2 * known.period(), known.layout().theta) : known;
    const BranchPoint at = doubles ? twice_round(equations, critical.point) : critical.point;
    const std::optional<BranchPoint> start = other_branch(equations.problem(), range_, at);
    if (!start) return false;
    // The special point itself lies on every branch through it.
    ContinuationOptions some = range_;
    some.max_points = 2;
    ZeroProblem bare = equations.problem();
    bare.multipliers = nullptr;
    const Branch away = trace_branch(bare, some, *start, Directions::kForward);
    if (away.points.size() > 1 && knows(equations, away.points.back())) return false;
    // Either way from a doubling lead the same orbits, half a period apart.
    add(equations, *start, doubles ? Directions::kForward : Directions::kBoth, origin_branch,
        origin_special);
    return true;
  }

  const SystemFamily& family_;
  const BranchOptions& options_;
  System own_;
  OrbitBranches result_;
  ContinuationOptions range_;
  PassageOptions strobe_;
  std::map<std::pair<int, double>, std::unique_ptr<PassageEquations>>
      equations_;  // by period and section
  std::vector<Traced> traced_;
  // Of each found branch: its special points in the trace, and the equations they solve.
  std::vector<FoundBranch> found_;
  std::vector<std::vector<std::optional<CriticalPoint>>> critical_;
  std::vector<std::vector<PassageEquations*>> on_;
};

}  // namespace

OrbitBranches trace_strobe_orbits(const SystemFamily& family, const BranchOptions& options) {
  return StrobeTracer(family, options).trace();
}

}  // namespace graze
