#include "graze/report/page/page_tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/assembly/probes.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/axis.hpp"
#include "graze/report/json/detail/json_page.hpp"

namespace graze {
namespace {

constexpr const char* kNothing = "–";
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// "−3.4·10⁻⁵"
std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return kNothing;
  std::string text = fmt::format("{:.{}g}", std::abs(value), digits);
  if (const std::size_t power = text.find('e'); power != std::string::npos)
    text = text.substr(0, power) + "·" +
           plain_text(fmt::format("10^{{{}}}", std::stoi(text.substr(power + 1))));
  return (value < 0.0 ? "−" : "") + text;
}

// A table that is filled column by column.
class Columns {
 public:
  explicit Columns(std::string name) : table_{std::move(name), {}, {}} {}

  void words(const std::string& name, const std::vector<std::string>& cells) {
    table_.columns.push_back(name);
    if (table_.rows.size() < cells.size()) table_.rows.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) table_.rows[i].push_back(cells[i]);
  }

  // In the unit in which the largest of them is read best.
  void numbers(const std::string& name, const std::string& si_unit,
               const std::vector<double>& values, int digits = 6) {
    double largest = 0.0;
    for (const double value : values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    const AxisUnit unit = axis_unit(si_unit, largest);
    std::vector<std::string> cells;
    for (const double value : values) cells.push_back(number_text(unit.factor * value, digits));
    words(plain_text(unit.unit.empty() ? name : name + " (" + unit.unit + ")"), cells);
  }

  PageTable take() { return std::move(table_); }

 private:
  PageTable table_;
};

// Of every element of a list.
template <class List, class Part>
auto each(const List& list, const Part& part) {
  std::vector<std::decay_t<decltype(part(list.front()))>> parts;
  for (const auto& element : list) parts.push_back(part(element));
  return parts;
}

double known(const std::optional<double>& value) { return value.value_or(kNoNumber); }

PageTable parameters_table(const FitResult& result) {
  PageTable table{
      "Fitted parameters", {"parameter", "value", "uncertainty", "95 % interval", "start"}, {}};
  for (const FittedParameter& one : result.parameters) {
    std::string uncertainty = one.at_limit ? "at its limit" : kNothing, interval = kNothing;
    if (one.uncertainty) {
      uncertainty = measured_text(*one.uncertainty, one.unit, 3);
      interval = measured_text(one.interval_low, one.unit, 8) + " to " +
                 measured_text(one.interval_high, one.unit, 8);
    }
    table.rows.push_back({one.name, measured_text(one.value, one.unit, 10), uncertainty, interval,
                          measured_text(one.start, one.unit)});
  }
  return table;
}

PageTable correlations_table(const FitResult& result) {
  PageTable table{"Correlations of the parameters", {""}, {}};
  if (result.parameters.size() < 2 || result.correlations.size() == 0) return table;
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    table.columns.push_back(result.parameters[i].name);
    std::vector<std::string> row = {result.parameters[i].name};
    for (std::size_t j = 0; j < result.parameters.size(); ++j)
      row.push_back(number_text(
          result.correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)), 3));
    table.rows.push_back(std::move(row));
  }
  return table;
}

PageTable motions_table(const ComparisonRecord& record) {
  Columns table("Motions");
  const auto of_first = [](double RunImpact::*part) {
    return [part](const ComparedMotion& motion) {
      return motion.first.empty() ? kNoNumber : motion.first.front().*part;
    };
  };
  const std::vector<ComparedMotion>& motions = record.motions;
  table.words("motion", {record.names.begin(),
                         record.names.begin() + static_cast<std::ptrdiff_t>(motions.size())});
  table.words("settles on", each(motions, [](const ComparedMotion& motion) {
                return attractor_title(motion.attractor);
              }));
  table.numbers("first impact", unit_in(record.info.units, "s"),
                each(motions, of_first(&RunImpact::time)), 9);
  table.numbers("its speed", unit_in(record.info.units, "m/s"),
                each(motions, of_first(&RunImpact::speed)));
  table.numbers("mean energy", unit_in(record.info.units, "J"),
                each(motions, [](const ComparedMotion& motion) { return known(motion.energy); }));
  table.numbers("lost at the stops a period", unit_in(record.info.units, "J"),
                each(motions, [](const ComparedMotion& motion) { return known(motion.taken); }));
  return table.take();
}

// Of each motion from the one before.
PageTable differences_table(const ComparisonRecord& record) {
  Columns table("Differences");
  const std::vector<MotionDifference>& differences = record.differences;
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < differences.size(); ++i)
    pairs.push_back(record.names[i] + " to " + record.names[i + 1]);
  table.words("", pairs);
  table.words("first impacts that agree", each(differences, [](const MotionDifference& difference) {
                return fmt::format("{} of {}", difference.agreeing, difference.first);
              }));
  const auto column = [&](const char* name, auto part, double times) {
    table.words(name, each(differences, [&](const MotionDifference& difference) {
                  return number_text(times * known(difference.*part), 4);
                }));
  };
  column("first impact (periods)", &MotionDifference::first_time, 1.0);
  column("its speed (%)", &MotionDifference::first_speed, 100.0);
  column("displacement (%)", &MotionDifference::displacement, 100.0);
  column("velocity (%)", &MotionDifference::velocity, 100.0);
  column("mean energy (%)", &MotionDifference::energy, 100.0);
  column("lost at the stops (%)", &MotionDifference::taken, 100.0);
  return table.take();
}

std::string largest_percent(const Matrix& part, Eigen::Index probe) {
  double most = 0.0;
  for (const double value : part.col(probe))
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return fmt::format("{:.2f}", 100.0 * most);
}

}  // namespace

std::string measured_text(double value, const std::string& si_unit, int digits) {
  if (!std::isfinite(value)) return kNothing;
  if (si_unit.empty()) return number_text(value, digits);
  const AxisUnit unit = axis_unit(si_unit, std::abs(value));
  return number_text(unit.factor * value, digits) + (unit.unit.starts_with("10^") ? "·" : " ") +
         plain_text(unit.unit);
}

std::vector<PageTable> page_tables(const FitRecord& record) {
  PageTable residuals{"Residuals", {"series", "values", "spread", "largest"}, {}};
  for (const FittedSeries& series : record.result.series) {
    const Vector missed = series.predicted - series.measured;
    residuals.rows.push_back({series.name, std::to_string(missed.size()),
                              measured_text(series.noise, series.unit, 3),
                              measured_text(missed.cwiseAbs().maxCoeff(), series.unit, 3)});
  }
  return {parameters_table(record.result), correlations_table(record.result), residuals};
}

std::vector<PageTable> page_tables(const CostRecord& record) {
  const FlowCosts& costs = record.costs;
  const std::string per = costs.forced ? " a period" : " a second";
  Columns table("Flows and settings");
  table.words("flow", each(costs.rows, [](const FlowCost& row) { return row.flow; }));
  table.words("setting", each(costs.rows, [](const FlowCost& row) { return row.setting; }));
  table.words(costs.impacts > 0
                  ? record.info.units == Units::kSi ? "error of impacts (s)" : "error of impacts"
                  : "error / amplitude",
              each(costs.rows,
                   [](const FlowCost& row) { return number_text(known(row.compared.error), 2); }));
  table.words("time" + per, each(costs.rows, [](const FlowCost& row) {
                return measured_text(row.seconds_per_period, "s", 3);
              }));
  table.words("evaluations" + per, each(costs.rows, [](const FlowCost& row) {
                return number_text(row.evaluations_per_period, 4);
              }));
  table.words("same impacts", each(costs.rows, [](const FlowCost& row) -> std::string {
                if (!row.compared.message.empty()) return row.compared.message;
                return row.compared.impacts_agree ? "yes" : "no";
              }));
  return {table.take()};
}

std::vector<PageTable> page_tables(const ComparisonRecord& record) {
  return {motions_table(record), differences_table(record)};
}

std::vector<PageTable> page_tables(const SensitivityRecord& record) {
  PageTable table{"Largest sensitivities", {"probe", "", "|s1| (%)", "|s2| (%)"}, {}};
  table.columns[1] = record.second.empty() ? "" : plain_text(parameter_title(record.second));
  for (const SensitivityCurve& curve : record.curves)
    for (std::size_t i = 0; i < record.probes.size(); ++i) {
      const auto probe = static_cast<Eigen::Index>(i);
      table.rows.push_back(
          {fmt::format("{} ({})", i + 1, probe_quantity_name(record.probes[i].quantity)),
           record.second.empty() ? "" : measured_text(curve.second, record.second_unit),
           largest_percent(curve.s1, probe), largest_percent(curve.s2, probe)});
    }
  return {table};
}

std::vector<PageTable> page_tables(const RunDiagramRecord& record) {
  Columns table("Runs");
  const std::vector<ValueRun>& runs = record.runs;
  const auto of_first = [](double RunImpact::*part) {
    return [part](const ValueRun& run) {
      return run.impacts.empty() ? kNoNumber : run.impacts.front().*part;
    };
  };
  table.numbers(parameter_title(record.parameter), record.unit,
                each(runs, [](const ValueRun& run) { return run.value; }), 8);
  table.words("impacts", each(runs, [](const ValueRun& run) {
                return std::to_string(run.impacts.size()) +
                       (run.outcome == RunOutcome::kReachedEnd ? "" : ", cut");
              }));
  if (record.stops > 0) {
    table.numbers("first impact", unit_in(record.info.units, "s"),
                  each(runs, of_first(&RunImpact::time)));
    table.numbers("its speed", unit_in(record.info.units, "m/s"),
                  each(runs, of_first(&RunImpact::speed)));
  }
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    table.numbers(fmt::format("largest size at probe {}", i + 1),
                  unit_in(record.info.units, probe_unit(record.probes[i].quantity)),
                  each(runs, [i](const ValueRun& run) { return run.peaks[i]; }));
  return {table.take()};
}

}  // namespace graze
