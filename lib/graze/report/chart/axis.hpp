// Axes of charts: units in which values are read well, ranges, scales, names of parameters.
#pragma once

#include <limits>
#include <string>

namespace graze {

// Words that are no markup, as text that may hold some.
std::string as_markup(const std::string& words);
// "10^{-3} kg^1/2 m" as "10⁻³ kg^½ m", "q_{1}" and "q_1" as "q₁"; other markup is taken away.
std::string plain_text(const std::string& markup);

enum class AxisScale { kLinear, kLog, kDecibel };
inline constexpr AxisScale kAxisScales[] = {AxisScale::kLinear, AxisScale::kLog,
                                            AxisScale::kDecibel};
const char* name_of(AxisScale scale);  // "dB"

// How SI values are shown on an axis: `factor` times the value, in `unit`.
struct AxisUnit {
  double factor = 1.0;
  std::string unit;  // "" for a pure number
};

// The unit in which values up to `largest` are read best: "mm" for "m", or "10^{-3} kg^1/2 m".
AxisUnit axis_unit(const std::string& si_unit, double largest);

// What an axis spans, in its own unit.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(low <= high); }
  double span() const { return high - low; }
  void include(double value);  // ignored unless finite, and below 1e300
  void include(const AxisRange& other);
  // Wide enough to draw on, whatever was included; then a part of the span more on both sides.
  void settle(double margin);
  std::string text() const;  // "[low:high]"
  // Where a value stands between the ends, 0 to 1; on a logarithmic axis by its logarithm.
  double part(double value, bool is_log = false) const;
  // 1, 2 or 5 times a power of ten: the smallest step with at most `most` tics.
  double tic_step(int most) const;
};

// The label of a parameter given by its path, without the unit.
std::string parameter_title(const std::string& path);

// Of a parameter in its unit, "" of a scene without units.
bool has_hertz_axis(const std::string& parameter, const std::string& unit);

}  // namespace graze
