#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/system_family.hpp"
#include "graze/base/parallel.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_curves.hpp"

namespace graze {
namespace {

// Orbits that a page keeps, of branches and of sweeps, and samples of their curves, 12 bytes each:
// so that it stays below some ten megabytes.
constexpr std::size_t kMostOfBranches = 1200, kMostOfSweeps = 800;
constexpr std::size_t kMostSamples = 250'000;

// Collects what goes into the page: the view, and the orbits behind its points.
class DiagramPage {
 public:
  DiagramPage(const BranchRecord& record, const SystemFamily& family)
      : record_(record),
        family_(family),
        source_{record.info, record.traced.parameter, closure_speed()},
        fit_(kMostSamples /
             static_cast<std::size_t>(page_samples(record.system, 1, source_.most_samples))),
        orbits_(Json::array()) {}

  void set_view(const std::string& title, const std::vector<std::string>& notes) {
    view_ = page_view(record_.info, record_.outcome, record_.warnings, notes);
    view_["kind"] = "diagram";
    view_["title"] = title;
    AxisRange range;
    range.include(record_.from);
    range.include(record_.to);
    const std::string& path = record_.traced.parameter;
    Json parameter = page_axis(parameter_title(path), record_.unit, range);
    parameter["path"] = path;
    parameter["from"] = record_.from;
    parameter["to"] = record_.to;
    parameter["hertz"] = has_hertz_axis(path, record_.unit);
    parameter["has_logarithm"] = std::max(record_.from, record_.to) > 0.0;
    view_["parameter"] = parameter;
    view_["stops"] = record_.system.stops.size();
    // Panels of their own below the picture: name, unit, factor, low, high, values and heights.
    view_["strips"] = Json::array();
  }

  void add_sweep(const Sweep& swept, const std::vector<MotionObservable>& observables);
  void add_exponents(const Sweep& swept);
  void add_branches(const std::vector<MotionObservable>& observables);
  void add_observables(const std::vector<MotionObservable>& observables, const Sweep* swept);
  void write(const std::string& file) { write_page_file(file, view_, orbits_); }

 private:
  std::optional<double> closure_speed() const {
    for (const auto& [name, value] : record_.info.options)
      if (name == "closure_speed") return std::get<double>(value);
    return {};
  }

  // Indices into the page's orbits, -1 where none is kept, of `count` things of which those at
  // `kept` are told by `told`.
  template <class Told>
  std::vector<std::int32_t> keep(std::size_t count, const std::vector<std::size_t>& kept,
                                 const Told& told) {
    std::vector<Json> made(kept.size());
    for_each_index(kept.size(), 0, [&](std::size_t i) { made[i] = told(kept[i]); });
    std::vector<std::int32_t> indices(count, -1);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (made[i].is_null()) continue;
      indices[kept[i]] = static_cast<std::int32_t>(orbits_.size());
      orbits_.push_back(std::move(made[i]));
    }
    return indices;
  }

  Json orbit_at(const OrbitBranchPoint& point) const {
    const std::optional<System> system = family_.at(point.value);
    if (!system) return nullptr;
    return page_orbit(source_, *system, point.orbit, point.value);
  }

  Json branch_json(const OrbitBranch& branch, std::size_t most);
  Json special_json(std::size_t branch, std::size_t index,
                    const std::vector<MotionObservable>& observables);

  const BranchRecord& record_;
  const SystemFamily& family_;
  PageSource source_;
  std::size_t fit_;  // orbits of one period that have that many samples
  Json view_, orbits_;
};

// The dots of all rows, one after the other; of what a motion has one of, one a row.
struct DotLists {
  std::vector<std::int32_t> first{0};  // dot of each row
  std::vector<std::uint8_t> stop;      // of each dot that is an impact
  std::vector<std::vector<float>> values;

  explicit DotLists(std::size_t observables) : values(observables) {}

  // Whether the row has any.
  bool add(const SweepRow& row, const std::vector<MotionObservable>& observables) {
    bool any = false;
    std::size_t dots = 0;
    for (std::size_t i = 0; i < observables.size(); ++i) {
      if (!observables[i].heights) continue;
      const std::vector<double> heights =
          has_dots(row) ? observables[i].heights(row) : std::vector<double>();
      any = any || !heights.empty();
      if (observables[i].is_of_motion)
        values[i].push_back(static_cast<float>(heights.empty() ? std::nan("") : heights.front()));
      else
        values[i].insert(values[i].end(), heights.begin(), heights.end());
      if (!observables[i].is_of_motion) dots = heights.size();
    }
    first.push_back(first.back() + static_cast<std::int32_t>(dots));
    for (std::size_t k = 0; k < std::min(dots, row.motion.impacts.size()); ++k)
      stop.push_back(static_cast<std::uint8_t>(row.motion.impacts[k].stop + 1));
    return any;
  }
};

void DiagramPage::add_sweep(const Sweep& swept, const std::vector<MotionObservable>& observables) {
  std::vector<double> values;
  std::vector<std::int32_t> label;
  std::vector<std::uint8_t> wild;
  std::vector<std::string> labels;
  std::vector<std::size_t> shown;
  DotLists lists(observables.size());
  for (const SweepRow& row : swept.rows) {
    values.push_back(row.value);
    const std::string name = attractor_label(attractor_class(row));
    const auto known = std::find(labels.begin(), labels.end(), name);
    label.push_back(static_cast<std::int32_t>(known - labels.begin()));
    if (known == labels.end()) labels.push_back(name);
    const bool any = lists.add(row, observables);
    if (any) shown.push_back(values.size() - 1);
    wild.push_back(!any ? 2 : row.status == SweepStatus::kNotPeriodic ? 1 : 0);
  }
  Json dots = Json::object();
  for (std::size_t i = 0; i < observables.size(); ++i)
    if (observables[i].heights) dots[observables[i].key] = packed(lists.values[i]);
  std::vector<std::size_t> kept;
  for (const std::size_t i : kept_of(shown.size(), std::min(fit_, kMostOfSweeps)))
    kept.push_back(shown[i]);
  const std::vector<std::int32_t> orbits =
      keep(swept.rows.size(), kept, [&](std::size_t i) -> Json {
        const SweepRow& row = swept.rows[i];
        const std::optional<System> system = family_.at(row.value);
        if (!system) return nullptr;
        return page_motion(source_, *system, page_motion_of(source_, row));
      });
  view_["sweep"] = {{"direction", name_of(swept.options.direction)},
                    {"values", packed(values)},
                    {"label", packed(label)},
                    {"labels", labels},
                    {"wild", packed(wild)},
                    {"first", packed(lists.first)},
                    {"dots", dots},
                    {"orbit", packed(orbits)}};
  if (dots.contains("speed") && record_.system.stops.size() > 1)
    view_["sweep"]["stop"] = packed(lists.stop);
}

void DiagramPage::add_exponents(const Sweep& swept) {
  if (swept.options.exponent_periods == 0) return;
  std::vector<double> values, lower_values;
  std::vector<float> heights, lower_heights;
  for (const SweepRow& row : swept.rows) {
    values.push_back(row.value);
    const bool known = row.exponents && row.exponents->values.size() > 0;
    const double height = known ? row.exponents->values[0] : std::nan("");
    heights.push_back(static_cast<float>(height));
    for (Eigen::Index j = 1; known && j < row.exponents->values.size(); ++j) {
      if (!std::isfinite(row.exponents->values[j])) continue;
      lower_values.push_back(row.value);
      lower_heights.push_back(static_cast<float>(row.exponents->values[j]));
    }
  }
  Json strip = page_axis("exponents", unit_in(record_.info.units, "1/s"), exponent_range(swept));
  strip["reference"] = 0.0;
  strip["values"] = packed(values);
  strip["heights"] = packed(heights);
  strip["lower"] = {{"values", packed(lower_values)}, {"heights", packed(lower_heights)}};
  view_["strips"].push_back(strip);
}

Json DiagramPage::branch_json(const OrbitBranch& branch, std::size_t most) {
  std::vector<std::int32_t> unstable;
  std::vector<double> values;
  for (const OrbitBranchPoint& point : branch.points) {
    unstable.push_back(point.unstable_multipliers);
    values.push_back(point.value);
  }
  const std::vector<std::int32_t> orbits =
      keep(branch.points.size(), kept_of(branch.points.size(), most),
           [&](std::size_t k) { return orbit_at(branch.points[k]); });
  return {{"id", branch.id},
          {"name", orbit_label(branch.pattern.period, branch.pattern.impacts(), branch.sticks())},
          {"value", packed(values)},
          {"unstable", packed(unstable)},
          {"orbit", packed(orbits)}};
}

Json DiagramPage::special_json(std::size_t branch, std::size_t index,
                               const std::vector<MotionObservable>& observables) {
  const OrbitBranch& from = record_.traced.branches[branch];
  const SpecialPoint& special = from.special[index];
  const std::string label = label_of(special.kind);
  Json more = Json::array();
  if (special.multiplier)
    more.push_back(
        {"multiplier",
         fmt::format("{:.6g}{}", special.multiplier->real(),
                     special.multiplier->imag() != 0.0
                         ? fmt::format(" ± {:.6g}i", std::abs(special.multiplier->imag()))
                         : "")});
  if (const auto impact = special.impact())
    more.push_back(
        {"phase", fmt::format("{:.6g}{}", impact->phase, unit_behind(record_.info.units, "rad"))});
  const std::vector<std::int32_t> orbit =
      keep(1, {0}, [&](std::size_t) { return orbit_at(special.at); });
  Json heights = Json::object();
  for (const MotionObservable& observable : observables) {
    if (observable.curves.empty()) continue;
    heights[observable.key] = json_list(observable.curves[branch].special[index]);
  }
  return {{"type", special.at.orbit.admissible ? label : virtual_special_look().id},
          {"label", label},
          {"id", special.id},
          {"branch", from.id},
          {"value", json_number(special.at.value)},
          {"more", more},
          {"orbit", orbit.front()},
          // One mark is enough for all that a chatter shows.
          {"marks", special.at.orbit.sticks() ? 1 : 1000},
          {"y", heights}};
}

void DiagramPage::add_branches(const std::vector<MotionObservable>& observables) {
  const std::vector<OrbitBranch>& branches = record_.traced.branches;
  const std::size_t most = std::min(fit_, kMostOfBranches);
  std::size_t points = 0;
  for (const OrbitBranch& branch : branches) points += branch.points.size();
  Json list = Json::array(), special = Json::array();
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const std::size_t share = points > most ? most * branches[i].points.size() / points : points;
    list.push_back(branch_json(branches[i], std::max<std::size_t>(2, share)));
    for (std::size_t k = 0; k < branches[i].special.size(); ++k)
      special.push_back(special_json(i, k, observables));
  }
  view_["branches"] = list;
  view_["special"] = special;
  view_["lines"] = page_lines(record_, observables);
  view_["values"] = page_values(observables);
}

void DiagramPage::add_observables(const std::vector<MotionObservable>& observables,
                                  const Sweep* swept) {
  Json list = Json::array();
  for (const MotionObservable& observable : observables) {
    AxisRange range;
    const auto include = [&](double height) { range.include(std::min(height, observable.most)); };
    for (const DiagramCurve& curve : observable.curves)
      for (const std::vector<double>& heights : curve.points)
        for (const double height : heights) include(height);
    if (swept && observable.heights)
      for (const SweepRow& row : swept->rows)
        if (has_dots(row))
          for (const double height : observable.heights(row)) include(height);
    const bool has_logarithm = range.high > 0.0;
    if (observable.from_zero) range.include(0.0);
    Json axis = page_axis(observable.name, observable.unit, range);
    axis["has_logarithm"] = has_logarithm;
    axis["key"] = observable.key;
    axis["of_motion"] = observable.is_of_motion;
    if (observable.turn) axis["turn"] = *observable.turn;
    if (observable.reference) axis["reference"] = *observable.reference;
    list.push_back(axis);
  }
  view_["observables"] = list;
}

}  // namespace

void write_page(const std::string& file, const BranchRecord& record, const Scene& scene) {
  const SystemFamily family(scene, record.traced.parameter);
  DiagramPage page(record, family);
  page.set_view("Branches of orbits", record.traced.notes);
  const std::vector<MotionObservable> observables = motion_observables(record, nullptr);
  page.add_observables(observables, nullptr);
  page.add_branches(observables);
  page.write(file);
}

void write_page(const std::string& file, const DiagramRecord& record, const Scene& scene) {
  const SystemFamily family(scene, record.swept.parameter);
  DiagramPage page(record.branches, family);
  page.set_view("Bifurcation diagram", record.branches.traced.notes);
  const std::vector<MotionObservable> observables = motion_observables(record);
  page.add_observables(observables, &record.swept);
  page.add_sweep(record.swept, observables);
  page.add_exponents(record.swept);
  page.add_branches(observables);
  page.write(file);
}

}  // namespace graze
