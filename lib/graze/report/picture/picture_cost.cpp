#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "graze/record/detail/cost_record.hpp"
#include "graze/report/picture/detail/picture_contact_order.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

struct FlowStyle {
  const char* colour;
  int mark;  // of gnuplot
};

const std::map<std::string, FlowStyle>& flow_styles() {
  static const std::map<std::string, FlowStyle> styles = {{"exact", {kVermillion, 7}},
                                                          {"rk4", {kBlue, 5}},
                                                          {"dopri5", {kGreen, 9}},
                                                          {"fehlberg78", {kPurple, 13}}};
  return styles;
}

// An error that is nothing at all has no place on a logarithmic axis: it is drawn at the last bit.
constexpr double kLeastError = 1e-17;

double drawn_error(const FlowCost& row) { return std::max(*row.compared.error, kLeastError); }

// Rows that no other one beats in error and in time, by time.
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

class CostPicture {
 public:
  explicit CostPicture(const CostRecord& record) : costs_(record.costs) {
    if (record.contact) contact_ = record.contact->lines;
    const FlowCosts& costs = costs_;
    for (const FlowCost& row : costs.rows) {
      if (!row.compared.error) continue;
      include(time_, row.seconds_per_period);
      include(error_, drawn_error(row));
    }
    include(error_, costs.allowed);
    // Where nothing could be compared the axes are bare.
    if (time_.empty()) include(time_, 1e-6);
  }

  // Height over width.
  double proportion() const { return height() / kWidth; }

  GnuplotScript script() {
    set_style(script_);
    if (!contact_.empty()) script_.command("set multiplot");
    std::size_t flows = 0;
    for (const auto& [flow, style] : flow_styles()) flows += add_flow(flow, style) ? 1 : 0;
    add_front();
    add_allowed();
    Margins margins;
    margins.bottom += legend_height(flows + 2, 2);
    place(margins);
    script_.command("set logscale xy");
    script_.command("set format xy '10^{%L}'");
    script_.command(fmt::format("set xrange [{:g}:{:g}]", time_.low, time_.high));
    script_.command(fmt::format("set yrange [{:g}:{:g}]", error_.low, error_.high));
    script_.command("set xlabel " + axis_label(costs_.forced
                                                   ? "computing time per forcing period"
                                                   : "computing time per second of motion",
                                               "s"));
    name_vertical_axis(script_,
                       costs_.impacts > 0 ? costs_.compliant
                                                ? "largest error of the time of a contact"
                                                : "largest error of an impact time"
                                          : "largest error of displacement / amplitude",
                       costs_.impacts > 0 ? "s" : "");
    script_.plot(layers_);
    if (contact_.empty()) return script_;
    draw_contact_orders(script_, contact_, height());
    script_.command("unset multiplot");
    return script_;
  }

 private:
  // cm
  static constexpr double kWidth = 12.0, kHeight = 9.0;
  double height() const { return kHeight + (contact_.empty() ? 0.0 : kContactOrderHeight); }

  // Margins of a picture of flows alone; it stands above what follows.
  void place(Margins margins) {
    const double part = kHeight / height();
    const Margins whole = margins;
    margins.bottom = 1.0 - part * (1.0 - margins.bottom);
    margins.top *= part;
    set_margins(script_, margins);
    set_legend(script_, whole, 2);
    if (!contact_.empty())
      script_.command(fmt::format("set key at screen {:.4g}, screen {:.4g}",
                                  0.5 * (1.0 + whole.left - whole.right), 1.0 - 0.99 * part));
  }

  // To whole decades.
  static void include(AxisRange& range, double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return;
    const double decade = std::floor(std::log10(value));
    range.low = std::min(range.low, std::pow(10.0, decade));
    range.high = std::max(range.high, std::pow(10.0, decade + 1.0));
  }

  bool add_flow(const std::string& flow, const FlowStyle& style) {
    PlotTable table;
    for (const FlowCost& row : costs_.rows)
      if (row.flow == flow && row.compared.error)
        table.row({row.seconds_per_period, drawn_error(row)});
    if (table.empty()) return false;
    script_.data(flow, table);
    layers_.push_back(fmt::format(
        "${} using 1:2 with linespoints lw 1.5 pt {} ps 1.3*mark lc rgb '{}' title '{}'", flow,
        style.mark, style.colour, flow));
    return true;
  }

  void add_front() {
    PlotTable table;
    for (const FlowCost* row : front_of(costs_))
      table.row({row->seconds_per_period, drawn_error(*row)});
    if (table.empty()) return;
    script_.data("front", table);
    layers_.push_back(fmt::format(
        "$front using 1:2 with points pt 6 ps 1.9*mark lw 1.5 lc rgb '{}' title 'beaten by none'",
        kBlack));
  }

  void add_allowed() {
    PlotTable table;
    table.row({time_.low, costs_.allowed});
    table.row({time_.high, costs_.allowed});
    script_.data("allowed", table);
    layers_.push_back(fmt::format(
        "$allowed using 1:2 with lines dt (8,4) lc rgb '{}' title 'solver.tolerance'", kGrey));
  }

  const FlowCosts& costs_;
  std::vector<ContactOrder> contact_;
  AxisRange time_, error_;
  GnuplotScript script_;
  std::vector<std::string> layers_;
};

}  // namespace

void draw_costs(const std::string& file, const CostRecord& record) {
  CostPicture picture(record);
  draw_picture(file, picture.script(), picture.proportion());
}

}  // namespace graze
