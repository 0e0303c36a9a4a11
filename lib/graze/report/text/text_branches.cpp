#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/records.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// An end by its special point, "GR1", which the other table describes; the limits of the range are
// known, any other place is given by its value.
std::string end_text(const OrbitBranch& branch, std::size_t which) {
  const OrbitBranchEnd kind = branch.ends[which];
  const OrbitBranchPoint& point = which == 0 ? branch.points.front() : branch.points.back();
  const std::string name = name_of(kind);
  for (const SpecialPoint& special : branch.special)
    if (special.at.value == point.value && special.id.starts_with(name)) return special.id;
  if (kind == OrbitBranchEnd::kParameterLimit) return name;
  return fmt::format("{} at {}", name, digits_text(point.value, 8));
}

std::string ends_text(const OrbitBranch& branch) {
  return branch.ends[0] == OrbitBranchEnd::kClosed
             ? name_of(branch.ends[0])
             : end_text(branch, 0) + ", " + end_text(branch, 1);
}

std::string branches_text(const BranchRecord& record, const TextOptions& options) {
  const std::vector<OrbitBranch>& traced = record.traced.branches;
  const bool switched = std::any_of(traced.begin(), traced.end(), [](const OrbitBranch& branch) {
    return !branch.origin.empty();
  });
  std::vector<std::string> columns = {"branch",
                                      "connected branch",
                                      "orbit",
                                      "points",
                                      "stable",
                                      with_unit("lowest", record.unit),
                                      with_unit("highest", record.unit),
                                      "ends"};
  if (switched) columns.emplace_back("from");
  Table table(columns);
  for (const OrbitBranch& branch : traced) {
    std::size_t stable = 0;
    double lowest = branch.points.front().value, highest = lowest;
    for (const OrbitBranchPoint& point : branch.points) {
      if (point.orbit.stable.value_or(false)) ++stable;
      lowest = std::min(lowest, point.value);
      highest = std::max(highest, point.value);
    }
    std::vector<std::string> row = {
        fmt::format("{}", branch.id),
        fmt::format("{}", branch.component),
        branch.sticks() ? fmt::format("({}, stick)", branch.pattern.period)
                        : fmt::format("({}, {})", branch.pattern.period, branch.pattern.impacts()),
        fmt::format("{}", branch.points.size()),
        fmt::format("{}", stable),
        digits_text(lowest, 8),
        digits_text(highest, 8),
        ends_text(branch)};
    if (switched) row.push_back(branch.origin.empty() ? "-" : branch.origin);
    table.add(row);
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

// A special point together with the branches that meet there.
struct Meeting {
  const SpecialPoint* point = nullptr;  // the first of those that have an impact
  std::string ids, branches;
  std::vector<OrbitImpact> impacts;  // without the one whose speed vanishes
  bool ends = false;                 // whether a branch ends there
};

// The impacts of a grazing orbit with nonzero speed.
std::vector<OrbitImpact> moving_impacts(const SpecialPoint& special) {
  std::vector<OrbitImpact> impacts = special.at.orbit.impacts;
  if (special.by_speed && !impacts.empty())
    impacts.erase(std::min_element(impacts.begin(), impacts.end(),
                                   [](const OrbitImpact& a, const OrbitImpact& b) {
                                     return std::abs(a.speed) < std::abs(b.speed);
                                   }));
  return impacts;
}

// Whether a branch of other orbits begins there: grazings of one motion, whose grazing impact has
// zero speed on one branch and is absent on the other. Both were solved for separately, to some
// 1e-12 of the range and of the speeds; symmetric orbits also graze at one value, but with other
// impacts.
bool is_same_motion(const Meeting& known, const SpecialPoint& special, double range,
                    double speed_scale) {
  constexpr double kSame = 1e-6;
  if (std::abs(known.point->at.value - special.at.value) > 1e-9 * range) return false;
  const std::vector<OrbitImpact> impacts = moving_impacts(special);
  return std::equal(impacts.begin(), impacts.end(), known.impacts.begin(), known.impacts.end(),
                    [&](const OrbitImpact& a, const OrbitImpact& b) {
                      return a.stop == b.stop && a.period_index == b.period_index &&
                             std::abs(a.phase - b.phase) < kSame &&
                             std::abs(a.speed - b.speed) < kSame * speed_scale;
                    });
}

bool ends_branch(const OrbitBranch& branch, const SpecialPoint& special) {
  const auto at = [&](std::size_t end, const OrbitBranchPoint& point) {
    return branch.ends[end] == OrbitBranchEnd::kGrazing && point.value == special.at.value;
  };
  return special.kind == SpecialKind::kGrazing &&
         (at(0, branch.points.front()) || at(1, branch.points.back()));
}

std::vector<Meeting> meetings_of(const BranchRecord& record) {
  std::vector<Meeting> meetings;
  const double range = std::abs(record.to - record.from);
  for (const OrbitBranch& branch : record.traced.branches)
    for (const SpecialPoint& special : branch.special) {
      const bool ends = ends_branch(branch, special);
      const std::string id = std::to_string(branch.id);
      const auto known = std::find_if(meetings.begin(), meetings.end(), [&](const Meeting& other) {
        return ends && other.ends && other.branches != id &&
               is_same_motion(other, special, range, record.traced.scale.speed);
      });
      if (known == meetings.end()) {
        meetings.push_back({&special, special.id, id, moving_impacts(special), ends});
        continue;
      }
      known->ids += ", " + special.id;
      known->branches += ", " + id;
      if (!known->point->impact()) known->point = &special;
    }
  return meetings;
}

// A vanishing impact speed is shown as zero, whatever the rounding of its equations.
std::string speed_text(const SpecialPoint& special, double speed) {
  if (!special.by_speed) return digits_text(speed, 9);
  const std::vector<OrbitImpact>& impacts = special.at.orbit.impacts;
  const bool vanishes = std::all_of(impacts.begin(), impacts.end(), [&](const OrbitImpact& other) {
    return std::abs(other.speed) >= std::abs(speed);
  });
  return vanishes ? "0" : digits_text(speed, 9);
}

std::string special_text(const BranchRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  const std::vector<std::string>& levels = record.traced.levels;
  std::vector<std::string> heads = {"point",
                                    "branch",
                                    with_unit(record.traced.parameter, record.unit),
                                    in.head("phase", "rad"),
                                    in.head("speed", "m/s"),
                                    "multiplier"};
  if (!levels.empty()) heads.emplace_back("level");
  Table table(heads);
  for (const Meeting& meeting : meetings_of(record)) {
    const SpecialPoint& special = *meeting.point;
    const std::optional<SpecialPoint::Impact> impact = special.impact();
    std::vector<std::string> row = {
        meeting.ids,
        meeting.branches,
        digits_text(special.at.value, 13),
        impact ? decimals_text(impact->phase, 9) : "-",
        impact ? speed_text(special, impact->speed) : "-",
        special.multiplier ? complex_text(*special.multiplier, 7) : "-"};
    const bool of_level = is_of_level(special.kind) && special.level < levels.size();
    if (!levels.empty()) row.push_back(of_level ? levels[special.level] : "-");
    table.add(row);
  }
  return table.empty() ? "" : table.text(options.width) + "\n";
}

std::string forms_text(const BranchRecord& record, const TextOptions& options) {
  Table table({"point", "coefficient", "beside it"});
  for (const OrbitBranch& branch : record.traced.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.normal)
        table.add({special.id, digits_text(special.normal->coefficient, 6), words_beyond(special)});
  return table.empty() ? "" : table.text(options.width) + "\n";
}

// Special points that were bracketed but not solved for.
std::string bracketed_only(const std::vector<OrbitBranch>& branches) {
  std::string text;
  for (const OrbitBranch& branch : branches)
    for (const SpecialPoint& s : branch.special)
      if (s.solution.bracket && !s.solution.bracket->converged)
        text += fmt::format("{} was not solved for: it lies between {} and {}\n", s.id,
                            digits_text(s.solution.bracket->from, 9),
                            digits_text(s.solution.bracket->to, 9));
  return text;
}

std::string counts_text(const OrbitBranches& traced, const TextOptions& options) {
  std::string text;
  const std::string starts =
      fmt::format("{} start{}, ", traced.starts, traced.starts == 1 ? "" : "s");
  if (traced.traced == 0)
    text = starts + "none traced\n";
  else if (options.verbose)
    text = starts +
           fmt::format("{} evaluations of the shooting equations\n", traced.shooting_evaluations);
  if (traced.switched > 0 || traced.left_open > 0)
    text += fmt::format("branches switched at {} special point{}, not at {} beyond --depth\n",
                        traced.switched, traced.switched == 1 ? "" : "s", traced.left_open);
  return text;
}

}  // namespace

std::string to_text(const BranchRecord& record, const TextOptions& options) {
  return branches_text(record, options) + special_text(record, options) +
         forms_text(record, options) + bracketed_only(record.traced.branches) +
         counts_text(record.traced, options) +
         notes_text(record.traced.notes, record.traced.details, options) + ending(record.outcome);
}

}  // namespace graze
