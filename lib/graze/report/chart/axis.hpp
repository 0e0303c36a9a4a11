// Axes of charts: units in which values are read well, ranges, scales, names of parameters.
#pragma once

#include <limits>
#include <string>

namespace graze {

// Text in which possible markup characters are escaped.
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

// The most readable unit for values up to `largest`: "mm" for "m", or "10^{-3} kg^1/2 m".
AxisUnit axis_unit(const std::string& si_unit, double largest);

// The range of an axis, in its own unit.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(low <= high); }
  double span() const { return high - low; }
  void include(double value);  // ignored unless finite, and below 1e300
  void include(const AxisRange& other);
  // Makes it wide enough to draw on, whatever was included, and adds a part of the span on both
  // sides.
  void settle(double margin);
  std::string text() const;  // "[low:high]"
  // Position of a value between the ends, 0 to 1; on a logarithmic axis by its logarithm.
  double part(double value, bool is_log = false) const;
  // 1, 2 or 5 times a power of ten: the smallest step with at most `most` tics.
  double tic_step(int most) const;
};

// The label of a parameter given by its path, without the unit.
std::string parameter_title(const std::string& path);

// Whether a parameter in this unit ("" for a scene without units) has a second axis in Hz.
bool has_hertz_axis(const std::string& parameter, const std::string& unit);

}  // namespace graze
