#include "graze/bifurcation/bounds/detail/admissible_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include "graze/bifurcation/bounds/detail/solution_family_form.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {
namespace {

// Cells narrower than this part of the range are not searched: branches end at a grazing that is
// located to 1e-10.
constexpr double kResolution = 1e-9;

// Most cells times modes in one search: about a second's worth.
constexpr long long kMostRunWork = 1LL << 17;

// Values that traced branches cover, as disjoint intervals.
class Coverage {
 public:
  void add(double from, double to) {
    if (from > to) std::swap(from, to);
    auto at = parts_.upper_bound(from);
    if (at != parts_.begin() && std::prev(at)->second >= from) --at;
    while (at != parts_.end() && at->first <= to) {
      from = std::min(from, at->first);
      to = std::max(to, at->second);
      at = parts_.erase(at);
    }
    parts_[from] = to;
  }
  // The part of an interval that is not covered.
  std::vector<std::pair<double, double>> rest(double from, double to) const {
    std::vector<std::pair<double, double>> list;
    auto at = parts_.upper_bound(from);
    if (at != parts_.begin()) --at;
    for (; at != parts_.end() && at->first < to; ++at) {
      if (at->second <= from) continue;
      if (at->first > from) list.emplace_back(from, at->first);
      from = std::max(from, at->second);
    }
    if (from < to) list.emplace_back(from, to);
    return list;
  }

 private:
  std::map<double, double> parts_;
};

// An instant at which a solution penetrates a stop.
struct Witness {
  int stop = 0;
  double part = 0.0;  // of the way to the next impact
};

struct Cell {
  std::size_t range = 0;
  int family = 1;
  double low = 0.0, high = 0.0;
  std::optional<Witness> witness;  // of the cell that it is a half of
};

class Search {
 public:
  Search(const SystemFamily& family, const SolutionRanges& ranges, const RunTracer& tracer)
      : ranges_(ranges), tracer_(tracer), cursor_(family), modes_(family.scene().modes()) {}

  RunSearch run() {
    const auto& all = ranges_.ranges();
    if (all.empty()) return result_;
    result_.resolution = kResolution * ranges_.length();
    std::deque<Cell> open;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const SystemInterpolant::Piece& piece : ranges_.interpolant().pieces()) {
        const double low = std::max(piece.low, all[i].from), high = std::min(piece.high, all[i].to);
        for (const int family : {1, -1})
          if (low < high) open.push_back({i, family, low, high, {}});
      }
    covered_[0].resize(all.size());
    covered_[1].resize(all.size());
    take_new_branches();
    for (; !open.empty() && !tracer_.stopped(); open.pop_front()) {
      const Cell cell = open.front();
      for (const auto& [low, high] : coverage(cell).rest(cell.low, cell.high)) {
        if (high - low <= result_.resolution) continue;
        look_at({cell.range, cell.family, low, high, cell.witness}, open);
      }
    }
    return result_;
  }

 private:
  Coverage& coverage(const Cell& cell) { return covered_[cell.family > 0 ? 0 : 1][cell.range]; }

  void look_at(Cell cell, std::deque<Cell>& open) {
    if (result_.cells * modes_ > kMostRunWork) {
      ++result_.undecided;
      result_.widest = std::max(result_.widest, cell.high - cell.low);
      return;
    }
    ++result_.cells;
    const std::optional<SystemForms> forms = ranges_.system_over(cell.low, cell.high);
    const auto family =
        forms ? SolutionFamilyForm::over(*forms, ranges_.stop(), ranges_.period(), cell.family)
              : std::nullopt;
    Extent no_orbit = family ? no_orbit_over(*forms, *family, cell.witness) : Extent::kNowhere;
    if (no_orbit == Extent::kEverywhere) return;
    const double middle = cell.low + 0.5 * (cell.high - cell.low);
    if (no_orbit == Extent::kNowhere) {
      const std::optional<ImpactPoint> solution = solution_at(middle, cell.family);
      if (solution && judge(*solution, middle, cell, open)) return;
      if (family) no_orbit = no_orbit_over(*forms, *family, cell.witness);
      if (no_orbit == Extent::kEverywhere) return;
    }
    open.push_back({cell.range, cell.family, cell.low, middle, cell.witness});
    open.push_back({cell.range, cell.family, middle, cell.high, cell.witness});
  }

  // Traces the solution in the middle of a cell when it is an orbit, and opens the rest of the
  // cell; else the cell gets the instant that shows it is none.
  bool judge(const ImpactPoint& solution, double middle, Cell& cell, std::deque<Cell>& open) {
    const System& system = *cursor_.at(middle);
    const ImpactPattern pattern{ranges_.period(), {ranges_.stop()}};
    const Admissibility classification = admissibility(system, pattern, {solution});
    if (classification.admissible) {
      tracer_.trace(solution, middle);
      take_new_branches();
      if (coverage(cell).rest(middle, std::nextafter(middle, cell.high)).empty())
        open.push_back(cell);
      else
        ++result_.lost;
      return true;
    }
    const double flight = ranges_.period() * system.period();
    if (classification.nearest && classification.nearest->gap < 0.0 &&
        classification.nearest->after > 0.0)
      cell.witness = Witness{classification.nearest->stop, classification.nearest->after / flight};
    return false;
  }

  // Where the family certainly has no orbit: nowhere, in the middle of the cell, or all over it. In
  // the second case the middle need not be solved for: the bounds are too wide, and the instant is
  // well chosen.
  // the witness a poor one.
  enum class Extent { kNowhere, kMiddle, kEverywhere };
  static Extent extent_of_negative(const MeanValueForm& form) {
    if (form.value.high < 0.0) return Extent::kEverywhere;
    return form.middle.high < 0.0 ? Extent::kMiddle : Extent::kNowhere;
  }
  static Extent no_orbit_over(const SystemForms& system, const SolutionFamilyForm& family,
                              const std::optional<Witness>& witness) {
    const Extent by_speed = extent_of_negative(family.speed());
    if (by_speed == Extent::kEverywhere || !witness) return by_speed;
    const auto gap = family.gap(system, witness->stop, witness->part);
    return gap ? std::max(by_speed, extent_of_negative(*gap)) : by_speed;
  }

  std::optional<ImpactPoint> solution_at(double value, int family) {
    const System* system = cursor_.at(value);
    if (system == nullptr) return {};
    const ClosedFormAnswer answer = closed_form(*system, ranges_.stop(), ranges_.period());
    if (!answer.form) return {};
    const double gap = system->stops[static_cast<std::size_t>(ranges_.stop())].gap;
    for (const ImpactPoint& point : answer.form->solutions(gap))
      if (ranges_.family(value, point.theta) == family) return point;
    return {};
  }

  void take_new_branches() {
    tracer_.new_branches([this](const OrbitBranch& branch) { cover(branch); });
  }

  void cover(const OrbitBranch& branch) {
    const auto& all = ranges_.ranges();
    const OrbitBranchPoint* last = nullptr;
    int last_family = 0;
    std::size_t last_range = 0;
    for (const OrbitBranchPoint& point : branch.points) {
      const auto range = ranges_.range_of(point.value);
      const double phase = point.orbit.impacts.front().phase;
      const int family = range ? ranges_.family(point.value, phase) : 0;
      if (family == 0) {
        last = nullptr;
        continue;
      }
      Coverage& here = covered_[family > 0 ? 0 : 1][*range];
      if (last != nullptr && last_range == *range) {
        if (last_family == family) {
          here.add(last->value, point.value);
        } else {
          // The nearer fold leads from one family to the other.
          const bool upwards = all[*range].to - point.value < point.value - all[*range].from;
          const double fold = upwards ? all[*range].to : all[*range].from;
          here.add(point.value, fold);
          covered_[last_family > 0 ? 0 : 1][*range].add(last->value, fold);
        }
      }
      last = &point;
      last_family = family;
      last_range = *range;
    }
  }

  const SolutionRanges& ranges_;
  const RunTracer& tracer_;
  SystemCursor cursor_;
  long long modes_;
  std::array<std::vector<Coverage>, 2> covered_;  // by family and range
  RunSearch result_;
};

}  // namespace

RunSearch search_runs(const SystemFamily& family, const SolutionRanges& ranges,
                      const RunTracer& tracer) {
  return Search(family, ranges, tracer).run();
}

bool bounded_runs(const System& system, int stop) {
  const Restitution& restitution = system.stops[static_cast<std::size_t>(stop)].restitution();
  if (!restitution.is_constant() || restitution.at_rest() == 0.0) return false;
  if (!(system.omega.minCoeff() > 0.0)) return false;
  return restitution.at_rest() < 1.0 || system.delta().maxCoeff() > 0.0;
}

}  // namespace graze
