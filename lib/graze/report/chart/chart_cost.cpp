#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"

namespace graze {
namespace {

struct FlowLook {
  const char* flow;
  Look look;
};

const std::vector<FlowLook>& flow_looks() {
  static const std::vector<FlowLook> looks = {
      {"dopri5", {.colour = kGreen, .width = 1.5, .mark = MarkShape::kUp, .size = 1.3}},
      {"exact", {.colour = kVermillion, .width = 1.5, .mark = MarkShape::kDot, .size = 1.3}},
      {"fehlberg78", {.colour = kPurple, .width = 1.5, .mark = MarkShape::kDiamond, .size = 1.3}},
      {"rk4", {.colour = kBlue, .width = 1.5, .mark = MarkShape::kSquare, .size = 1.3}}};
  return looks;
}

// An error of zero has no place on a logarithmic axis: it is drawn at the last bit.
constexpr double kLeastError = 1e-17, kRounding = 1e-16;

double drawn_error(const FlowCost& row) { return std::max(*row.compared.error, kLeastError); }

// Rows that no other row beats in both error and time, sorted by time.
std::vector<const FlowCost*> front_of(const FlowCosts& costs) {
  std::vector<const FlowCost*> rows;
  for (const FlowCost& row : costs.rows)
    if (row.compared.error) rows.push_back(&row);
  std::sort(rows.begin(), rows.end(), [](const FlowCost* a, const FlowCost* b) {
    return a->seconds_per_period < b->seconds_per_period;
  });
  std::vector<const FlowCost*> front;
  for (const FlowCost* row : rows)
    if (front.empty() || drawn_error(*row) < drawn_error(*front.back())) front.push_back(row);
  return front;
}

ChartAxis time_axis(const FlowCosts& costs) {
  return {.name = costs.forced ? "computing time per forcing period"
                               : "computing time per second of motion",
          .unit = "s",
          .scale = AxisScale::kLog};
}

ChartAxis error_axis(const FlowCosts& costs, Units units) {
  if (costs.impacts == 0)
    return {.name = "largest error of displacement / amplitude", .scale = AxisScale::kLog};
  return {.name = costs.compliant ? "largest error of the time of a contact"
                                  : "largest error of an impact time",
          .unit = unit_in(units, "s"),
          .scale = AxisScale::kLog};
}

ChartPanel flows_panel(const FlowCosts& costs, Units units) {
  ChartPanel panel{time_axis(costs), error_axis(costs, units)};
  panel.height = 6.0;
  double least = INFINITY, most = 0.0;
  for (const auto& [flow, look] : flow_looks()) {
    ChartSeries series{flow, look, true, true, {}, {}};
    for (const FlowCost& row : costs.rows)
      if (row.flow == flow && row.compared.error) {
        series.x.push_back(row.seconds_per_period);
        series.y.push_back(drawn_error(row));
        least = std::min(least, row.seconds_per_period);
        most = std::max(most, row.seconds_per_period);
      }
    if (!series.x.empty()) panel.series.push_back(series);
  }
  ChartSeries front{
      "no setting is better in both",
      {.colour = kBlack, .width = 1.5, .mark = MarkShape::kCircle, .open = true, .size = 1.9},
      false,
      true,
      {},
      {}};
  for (const FlowCost* row : front_of(costs)) {
    front.x.push_back(row->seconds_per_period);
    front.y.push_back(drawn_error(*row));
  }
  // Below the marks that it surrounds: what is open covers what lies under it.
  if (!front.x.empty()) panel.series.insert(panel.series.begin(), front);
  if (most > 0.0)
    panel.series.push_back({"solver.tolerance",
                            {.colour = kGrey, .dashes = {8, 4}, .width = 1.0},
                            true,
                            false,
                            {least, most},
                            {costs.allowed, costs.allowed}});
  if (panel.series.empty()) panel.remark = "nothing could be compared";
  return panel;
}

bool is_exact(const ContactOrder& line) { return line.method == "exact"; }

// Springs by colour; located: full marks on full lines.
Look contact_look(const ContactOrder& line) {
  Look look;
  look.colour = line.contact.exponent == 1.0   ? kBlue
                : line.contact.exponent == 1.5 ? kVermillion
                                               : kGreen;
  look.width = 1.5;
  const bool located = line.method == "rk4, located";
  look.mark = is_exact(line) ? MarkShape::kDiamond : MarkShape::kDot;
  look.open = is_exact(line) || !located;
  look.size = is_exact(line) ? 1.1 : 0.6;
  if (!located) look.dashes = {8, 4};
  return look;
}

std::string contact_title(const ContactOrder& line) {
  if (is_exact(line)) return line.spring + ", exact flow";
  return fmt::format("{}{}: order {:.2f}", line.spring, line.method.substr(3), line.order);
}

// Errors over the step and over the time that it takes.
std::vector<ChartPanel> contact_panels(const std::vector<ContactOrder>& lines) {
  const ChartAxis error{.name = "error of speed or duration, relative", .scale = AxisScale::kLog};
  ChartPanel steps{{.name = "step / duration of the contact", .scale = AxisScale::kLog}, error};
  ChartPanel seconds{
      {.name = "computing time of the contact", .unit = "s", .scale = AxisScale::kLog}, error};
  steps.height = seconds.height = 4.9;
  for (const ContactOrder& line : lines) {
    ChartSeries series{contact_title(line), contact_look(line), !is_exact(line), true, {}, {}};
    ChartSeries timed = series;
    for (const ContactOrderRow& row : line.rows) {
      series.x.push_back(row.step / line.contact.duration());
      timed.x.push_back(row.seconds);
      series.y.push_back(std::max(row.error, kRounding));
    }
    timed.y = series.y;
    // The exact flow takes no steps of one length.
    if (is_exact(line)) series.x.clear(), series.y.clear();
    steps.series.push_back(series);
    seconds.series.push_back(timed);
  }
  return {steps, seconds};
}

}  // namespace

Chart chart_of(const CostRecord& record) {
  Chart chart{"What accuracy costs", {{flows_panel(record.costs, record.info.units)}}};
  if (record.contact && !record.contact->lines.empty())
    chart.rows.push_back(contact_panels(record.contact->lines));
  return chart;
}

}  // namespace graze
