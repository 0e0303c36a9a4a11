#include "graze/report/chart/detail/motion_things.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/detail/branch_lines.hpp"

namespace graze {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

class ThingsMaker {
 public:
  ThingsMaker(const BranchRecord& record, const Sweep* swept)
      : record_(record), branches_(record.traced.branches), swept_(swept) {}

  ChartThings made(const std::vector<MotionObservable>& observables) {
    set_kinds();
    for (const MotionObservable& observable : observables) add_observable(observable);
    add_parameter();
    add_told();
    return std::move(things_);
  }

 private:
  using Number = ChartThings::Number;
  using Values = std::vector<double>;

  // Of each in its order: `row(SweepRow)`, `point(branch, index)` and `special(branch, index)`.
  template <class Row, class Point, class Special>
  void for_each(const Row& row, const Point& point, const Special& special) const {
    if (swept_)
      for (const SweepRow& one : swept_->rows) row(one);
    for (std::size_t b = 0; b < branches_.size(); ++b)
      for (std::size_t k = 0; k < branches_[b].points.size(); ++k) point(b, k);
    for (std::size_t b = 0; b < branches_.size(); ++b)
      for (std::size_t k = 0; k < branches_[b].special.size(); ++k) special(b, k);
  }

  void add_kind(const ChartThings::Kind& kind) {
    // Those of neighbours are often the same.
    const auto known = std::find_if(things_.kinds.rbegin(), things_.kinds.rend(),
                                    [&](const auto& any) { return any.title == kind.title; });
    things_.kind.push_back(static_cast<int>(things_.kinds.rend() - known) - 1);
    if (known != things_.kinds.rend()) return;
    things_.kind.back() = static_cast<int>(things_.kinds.size());
    things_.kinds.push_back(kind);
  }

  static std::string name_of(const OrbitBranch& branch) {
    return orbit_label(branch.pattern.period, branch.pattern.impacts(), branch.sticks());
  }

  void set_kinds() {
    for_each(
        [&](const SweepRow& row) {
          const std::string label = attractor_title(attractor_class(row));
          add_kind({"sweep: " + label, label, ""});
        },
        [&](std::size_t b, std::size_t k) {
          const OrbitBranch& branch = branches_[b];
          const std::string name = name_of(branch);
          add_kind({fmt::format("branch {}, {}: {}", branch.id, name,
                                line_looks()[line_kind(branch.points[k].orbit)].title),
                    fmt::format("branch {} {}", branch.id, name), name});
        },
        [&](std::size_t b, std::size_t k) {
          const SpecialPoint& special = branches_[b].special[k];
          const std::string label = label_of(special.kind);
          const std::string title = special_look(label).title;
          add_kind({fmt::format("{}: {}, {}", special.id,
                                title.empty() ? label : title.substr(0, title.find(" (")),
                                name_of(branches_[b])),
                    special.id, special.id});
          add_more(special);
        });
  }

  void add_more(const SpecialPoint& special) {
    auto& more = things_.more[static_cast<int>(things_.kind.size()) - 1];
    if (special.multiplier)
      more.emplace_back(
          "multiplier",
          fmt::format("{:.6g}{}", special.multiplier->real(),
                      special.multiplier->imag() != 0.0
                          ? fmt::format(" ± {:.6g}i", std::abs(special.multiplier->imag()))
                          : ""));
    if (const auto impact = special.impact())
      more.emplace_back(
          "phase", fmt::format("{:.6g}{}", impact->phase, unit_behind(record_.info.units, "rad")));
  }

  void add(const Values& values, Number& number) const {
    if (number.is_single)
      number.values.push_back(values.empty() ? kNoValue : values.front());
    else
      number.values.insert(number.values.end(), values.begin(), values.end());
    if (!number.is_single) number.first.push_back(number.values.size());
  }

  void add_observable(const MotionObservable& observable) {
    Number number{.axis = {.name = observable.name,
                           .unit = observable.unit,
                           .from_zero = observable.from_zero,
                           .key = observable.key},
                  .is_single = observable.is_of_motion,
                  .level = observable.reference,
                  .turn = observable.turn};
    if (!number.is_single) number.first.push_back(0);
    const auto include = [&](const Values& values) {
      for (const double value : values) number.axis.range.include(std::min(value, observable.most));
    };
    const auto add_of = [&](const Values& values) { add(values, number), include(values); };
    const bool has_curves = !observable.curves.empty();
    for_each(
        [&](const SweepRow& row) {
          add_of(has_dots(row) && observable.heights ? observable.heights(row) : Values());
          number.rough = number.values.size();
        },
        [&](std::size_t b, std::size_t k) {
          add_of(has_curves ? observable.curves[b].points[k] : Values());
        },
        [&](std::size_t b, std::size_t k) {
          add(has_curves ? observable.curves[b].special[k] : Values(), number);
        });
    AxisRange& range = number.axis.range;
    if (observable.from_zero || range.empty()) range.include(0.0);
    range.settle(0.05);
    things_.numbers.push_back(std::move(number));
  }

  void add_parameter() {
    const std::string& path = record_.traced.parameter;
    Number number{
        .axis = {.name = parameter_title(path), .unit = record_.unit, .path = path, .key = path}};
    for (const double end : {record_.from, record_.to}) number.axis.range.include(end);
    for_each([&](const SweepRow& row) { number.values.push_back(row.value); },
             [&](std::size_t b, std::size_t k) {
               number.values.push_back(branches_[b].points[k].value);
             },
             [&](std::size_t b, std::size_t k) {
               number.values.push_back(branches_[b].special[k].at.value);
             });
    things_.numbers.push_back(std::move(number));
  }

  void add_told() {
    Number unstable{.axis = {.name = "multipliers outside the circle", .key = "unstable"},
                    .is_axis = false};
    for_each([&](const SweepRow&) { add({}, unstable); },
             [&](std::size_t b, std::size_t k) {
               add({static_cast<double>(branches_[b].points[k].unstable_multipliers)}, unstable);
             },
             [&](std::size_t, std::size_t) { add({}, unstable); });
    if (!branches_.empty()) things_.numbers.push_back(std::move(unstable));
    const auto is_speed = [](const Number& number) { return number.axis.key == "speed"; };
    if (!swept_ || record_.system.stops.size() < 2 ||
        std::none_of(things_.numbers.begin(), things_.numbers.end(), is_speed))
      return;
    Number stop{.axis = {.name = "at stop", .key = "stop"},
                .is_single = false,
                .is_axis = false,
                .first = {0}};
    for_each(
        [&](const SweepRow& row) {
          Values stops;
          for (const MetImpact& impact : row.motion.impacts) stops.push_back(impact.stop + 1.0);
          add(stops, stop);
        },
        [&](std::size_t, std::size_t) { add({}, stop); },
        [&](std::size_t, std::size_t) { add({}, stop); });
    things_.numbers.push_back(std::move(stop));
  }

  const BranchRecord& record_;
  const std::vector<OrbitBranch>& branches_;
  const Sweep* swept_;
  ChartThings things_;
};

}  // namespace

MotionNumbers::MotionNumbers(const std::vector<OrbitBranch>& branches, std::size_t rows) {
  int next = static_cast<int>(rows);
  for (const OrbitBranch& branch : branches) {
    points_.push_back(next);
    next += static_cast<int>(branch.points.size());
  }
  for (const OrbitBranch& branch : branches) {
    special_.push_back(next);
    next += static_cast<int>(branch.special.size());
  }
}

ChartThings motion_things(const BranchRecord& record, const Sweep* swept,
                          const std::vector<MotionObservable>& observables) {
  return ThingsMaker(record, swept).made(observables);
}

}  // namespace graze
