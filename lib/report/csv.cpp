#include "graze/report/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "graze/report/names.hpp"

namespace graze {
namespace {

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
std::string cell(const std::optional<double>& value) { return value ? cell(*value) : ""; }
std::string cell(const std::optional<bool>& value) { return value ? (*value ? "1" : "0") : ""; }

}  // namespace

std::string events_csv(const SimulationRecord& record) {
  std::string text = "kind,time,stop,speed,phase,energy_change\n";
  for (const Event& e : record.events)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", name_of(e.kind), cell(e.time),
                   e.stop + 1, cell(e.speed), cell(e.phase), cell(e.energy_change));
  return text;
}

std::string samples_csv(const SimulationRecord& record) {
  const int n = record.system.modes();
  const auto out = [](std::string& text) { return std::back_inserter(text); };
  std::string text = "time";
  for (int j = 1; j <= n; ++j) fmt::format_to(out(text), ",q{}", j);
  for (int j = 1; j <= n; ++j) fmt::format_to(out(text), ",qdot{}", j);
  for (std::size_t i = 1; i <= record.system.stops.size(); ++i)
    fmt::format_to(out(text), ",gap{}", i);
  text += "\n";
  for (const Sample& s : record.samples) {
    text += cell(s.time);
    const auto add = [&](double value) { fmt::format_to(out(text), ",{}", cell(value)); };
    for (const double value : s.state.q) add(value);
    for (const double value : s.state.qdot) add(value);
    for (const RigidStop& stop : record.system.stops) add(stop.gap - stop.row.dot(s.state.q));
    text += "\n";
  }
  return text;
}

std::string orbits_csv(const OrbitRecord& record) {
  std::string text =
      "orbit,period,impacts,impact,stop,period_index,phase,speed,stable,admissible,clearance,"
      "largest_multiplier,residual\n";
  int number = 0;
  for (const Orbit& orbit : record.found.orbits) {
    ++number;
    int index = 0;
    const double largest =
        orbit.multipliers.empty() ? NAN : std::abs(orbit.multipliers.front().value);
    for (const OrbitImpact& impact : orbit.impacts)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", number,
                     orbit.period, orbit.impacts.size(), ++index, impact.stop + 1,
                     impact.period_index, cell(impact.phase), cell(impact.speed),
                     cell(orbit.stable), orbit.admissible ? 1 : 0, cell(orbit.clearance),
                     cell(largest), cell(orbit.residual));
  }
  return text;
}

std::string branches_csv(const BranchRecord& record) {
  std::string text =
      "branch,component,value,phase,speed,stable,admissible,unstable_multipliers,clearance\n";
  for (const OrbitBranch& branch : record.traced.branches)
    for (const OrbitBranchPoint& point : branch.points) {
      const OrbitImpact& first = point.orbit.impacts.front();
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", branch.id,
                     branch.component, cell(point.value), cell(first.phase), cell(first.speed),
                     cell(point.orbit.stable), point.orbit.admissible ? 1 : 0,
                     point.unstable_multipliers, cell(point.orbit.clearance));
    }
  return text;
}

std::string special_csv(const BranchRecord& record) {
  std::string text = "id,label,branch,value,phase,speed,multiplier_re,multiplier_im\n";
  for (const OrbitBranch& branch : record.traced.branches)
    for (const SpecialPoint& s : branch.special) {
      const OrbitImpact& first = s.at.orbit.impacts.front();
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", s.id, name_of(s.kind),
                     branch.id, cell(s.at.value), cell(first.phase), cell(first.speed),
                     s.multiplier ? cell(s.multiplier->real()) : "",
                     s.multiplier ? cell(s.multiplier->imag()) : "");
    }
  return text;
}

}  // namespace graze
