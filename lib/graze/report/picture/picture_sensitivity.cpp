#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostProbes = 3;
constexpr std::array kColours = {kBlue, kVermillion, kGreen, kPurple, kOrange, kSky};
constexpr std::array kDashes = {1, 2, 4, 5, 3, 6};

class SensitivityPicture {
 public:
  explicit SensitivityPicture(const SensitivityRecord& record) : record_(record), column_(script_) {
    probes_ = std::min(record.probes.size(), kMostProbes);
    shown_ = std::min(record.curves.size(), kColours.size());
  }

  GnuplotScript script() {
    set_style(script_);
    column_.lay_out(std::vector<double>(2 * probes_, 1.2 * PanelColumn::kPanel), false,
                    !record_.second.empty(), false);
    script_.command("set multiplot");
    AxisRange range;
    for (const SensitivityCurve& curve : record_.curves)
      for (const ValueRun& run : curve.runs) range.include(run.value);
    along_ = column_.set_parameter_axis(record_.parameter, record_.unit, range, 0.02);
    for (std::size_t i = 0; i < probes_; ++i) {
      draw(i, "s_1", &SensitivityCurve::s1, i == 0);
      draw(i, "s_2", &SensitivityCurve::s2, false);
    }
    script_.command("unset multiplot");
    return script_;
  }
  double proportion() const { return column_.proportion(); }

 private:
  void draw(std::size_t probe, const std::string& name, Matrix SensitivityCurve::*part,
            bool legend) {
    const auto column = static_cast<Eigen::Index>(probe);
    AxisRange range;
    range.include(0.0);
    std::vector<std::string> layers;
    for (std::size_t c = 0; c < shown_; ++c) {
      const SensitivityCurve& curve = record_.curves[c];
      PlotTable table;
      for (std::size_t k = 0; k < curve.runs.size(); ++k) {
        const double value = 100.0 * (curve.*part)(static_cast<Eigen::Index>(k), column);
        if (!std::isfinite(value)) continue;
        range.include(value);
        table.row({along_ * curve.runs[k].value, value});
      }
      const std::string data = fmt::format("{}_{}_{}", name, probe + 1, c + 1);
      script_.data(data, table);
      const std::string title = legend && !record_.second.empty()
                                    ? fmt::format("{} {:.4g} {}", parameter_title(record_.second),
                                                  curve.second, record_.second_unit)
                                    : "";
      layers.push_back(fmt::format("${} with lines lw 1.8 dt {} lc rgb '{}' title '{}'", data,
                                   kDashes[c], kColours[c], title));
    }
    range.settle(0.08);
    column_.begin_panel(
        range, fmt::format("{}\n{}", name, probe_quantity_name(record_.probes[probe].quantity)),
        "%");
    if (legend && !record_.second.empty()) column_.set_legend();
    column_.draw_zero_line();
    column_.end_panel(layers);
  }

  const SensitivityRecord& record_;
  GnuplotScript script_;
  PanelColumn column_;
  std::size_t probes_ = 0, shown_ = 0;
  double along_ = 1.0;  // factor of the horizontal axis
};

}  // namespace

void draw_sensitivity(const std::string& file, const SensitivityRecord& record) {
  SensitivityPicture picture(record);
  const GnuplotScript script = picture.script();
  draw_picture(file, script, picture.proportion());
}

}  // namespace graze
