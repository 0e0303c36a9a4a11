#include "graze/report/chart/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace graze {

std::string as_markup(const std::string& words) {
  std::string plain;
  for (const char c : words) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) {
      plain += ' ';
      continue;
    }
    if (c == '_' || c == '^' || c == '{' || c == '}' || c == '@' || c == '&' || c == '~' ||
        c == '\\')
      plain += '\\';
    plain += c;
  }
  return plain;
}

std::string plain_text(const std::string& markup) {
  static const std::map<char, std::string> kRaised = {
      {'-', "⁻"}, {'0', "⁰"}, {'1', "¹"}, {'2', "²"}, {'3', "³"}, {'4', "⁴"},
      {'5', "⁵"}, {'6', "⁶"}, {'7', "⁷"}, {'8', "⁸"}, {'9', "⁹"}};
  static const std::map<char, std::string> kLowered = {
      {'0', "₀"}, {'1', "₁"}, {'2', "₂"}, {'3', "₃"}, {'4', "₄"},
      {'5', "₅"}, {'6', "₆"}, {'7', "₇"}, {'8', "₈"}, {'9', "₉"}};
  std::string text = markup;
  if (const std::size_t root = text.find("^1/2"); root != std::string::npos)
    text.replace(root, 4, "^½");
  std::string plain;
  const std::map<char, std::string>* shifted = nullptr;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const std::map<char, std::string>& single = c == '^' ? kRaised : kLowered;
    if (c == '\\') {
      if (++i < text.size()) plain += text[i];
    } else if ((c == '^' || c == '_') && i + 1 < text.size() && single.contains(text[i + 1])) {
      plain += single.at(text[++i]);
    } else if ((c == '^' || c == '_') && i + 1 < text.size() && text[i + 1] == '{') {
      shifted = c == '^' ? &kRaised : &kLowered;
      ++i;
    } else if (shifted && c == '}') {
      shifted = nullptr;
    } else if (shifted && shifted->contains(c)) {
      plain += shifted->at(c);
    } else {
      plain += c;
    }
  }
  return plain;
}

const char* name_of(AxisScale scale) {
  switch (scale) {
    case AxisScale::kLinear:
      return "linear";
    case AxisScale::kLog:
      return "log";
    case AxisScale::kDecibel:
      break;
  }
  return "dB";
}

AxisUnit axis_unit(const std::string& si_unit, double largest) {
  if (!(largest > 0.0)) return {1.0, si_unit};
  struct Named {
    const char* si;
    double below;  // of the largest value, in SI
    AxisUnit unit;
  };
  // The first that fits; a unit's last entry takes what is larger.
  static const std::array<Named, 15> kNamed = {{{"m", 1e-4, {1e6, "µm"}},
                                                {"m", 0.1, {1e3, "mm"}},
                                                {"m/s", 1e-5, {1e6, "µm/s"}},
                                                {"m/s", 0.02, {1e3, "mm/s"}},
                                                {"s", 1e-3, {1e6, "µs"}},
                                                {"s", 0.5, {1e3, "ms"}},
                                                {"N", 5e-4, {1e6, "µN"}},
                                                {"N", 0.5, {1e3, "mN"}},
                                                {"J", 5e-7, {1e9, "nJ"}},
                                                {"J", 5e-4, {1e6, "µJ"}},
                                                {"J", 0.5, {1e3, "mJ"}},
                                                {"J", 1e4, {1e0, "J"}},
                                                {"Pa", 1e6, {1e0, "Pa"}},
                                                {"Pa", 1e9, {1e-6, "MPa"}},
                                                {"Pa", 1e300, {1e-9, "GPa"}}}};
  for (const Named& named : kNamed)
    if (si_unit == named.si && largest < named.below && named.unit.factor * largest >= 0.02)
      return named.unit;
  // Numbers too long for an axis pass their power of a thousand to the unit.
  if (largest >= 0.02 && largest < 1e5) return {1.0, si_unit};
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
  return {std::pow(10.0, -power),
          fmt::format("10^{{{}}}{}{}", power, si_unit.empty() ? "" : " ", si_unit)};
}

void AxisRange::include(double value) {
  // Values near the end of double precision must not spoil the axis.
  if (!(std::abs(value) < 1e300)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void AxisRange::include(const AxisRange& other) {
  if (other.empty()) return;
  include(other.low);
  include(other.high);
}

void AxisRange::settle(double margin) {
  if (empty()) low = 0.0, high = 1.0;
  // For a smaller span the tics of a double axis would coincide.
  const double size = std::max(std::abs(low), std::abs(high));
  const double least = size > 0.0 ? 1e-9 * size : 1.0;
  if (span() < least) {
    const double more = size > 0.0 ? 0.05 * size : 1.0;
    low -= more;
    high += more;
  }
  const double more = margin * span();
  low -= more;
  high += more;
}

std::string AxisRange::text() const { return fmt::format("[{:.12g}:{:.12g}]", low, high); }

double AxisRange::part(double value, bool is_log) const {
  if (is_log) return std::log(value / low) / std::log(high / low);
  return (value - low) / span();
}

double AxisRange::tic_step(int most) const {
  double step = std::pow(10.0, std::floor(std::log10(span() / most)));
  for (const double more : {2.0, 2.5, 2.0})
    if (span() / step > most) step *= more;
  return step;
}

namespace {

// Looked up by the path without its numbers.
const std::map<std::string, std::string>& quantity_names() {
  static const std::map<std::string, std::string> kNames = {
      {"forcing.frequency", "forcing frequency Ω"},
      {"forcing.frequency_hz", "forcing frequency"},
      {"forcing.amplitude", "forcing amplitude"},
      {"forcing.phase", "forcing phase"},
      {"damping.viscous", "viscous damping η"},
      {"damping.ratio", "damping ratio ζ"},
      {"damping.ratios", "damping ratio ζ"},
      {"damping.rayleigh.mass", "damping by mass"},
      {"damping.rayleigh.stiffness", "damping by stiffness"},
      {"modal.frequencies", "natural frequency ω"},
      {"modal.damping_ratios", "damping ratio ζ"},
      {"modal.inertia", "inertia"},
      {"modal.participation", "participation"},
      {"beam.length", "beam length"},
      {"beam.tension", "tension"},
      {"beam.density", "density"},
      {"beam.area", "area of the cross-section"},
      {"beam.thickness", "thickness of the beam"},
      {"beam.youngs_modulus", "Young’s modulus"},
      {"beam.second_moment", "second moment of area"},
      {"beam.mass.mass", "mass on the beam"},
      {"beam.mass.inertia", "rotary inertia on the beam"},
      {"beam.mass.position", "position of the mass"},
      {"beam.support.position", "position of the support"},
      {"beam.support.translational", "stiffness of the support"},
      {"beam.support.rotational", "rotational stiffness of the support"},
      {"beam.piece.to", "end of the piece"},
      {"beam.piece.section.width", "width of the section"},
      {"beam.piece.section.height", "height of the section"},
      {"string.length", "string length"},
      {"string.tension", "tension"},
      {"bar.length", "bar length"},
      {"bar.density", "density"},
      {"bar.area", "area of the cross-section"},
      {"bar.youngs_modulus", "Young’s modulus"},
      {"lumped.masses", "mass"},
      {"lumped.spring.stiffness", "stiffness of the spring"},
      {"lumped.spring.damping", "coefficient of the dashpot"},
      {"lumped.gyroscopic.coefficient", "gyroscopic coefficient"},
      {"friction.force", "friction"},
      {"friction.static_force", "static friction"},
      {"friction.coefficient", "coefficient of friction"},
      {"friction.static_coefficient", "coefficient of static friction"},
      {"friction.normal_force", "normal force"},
      {"friction.speed", "speed of the belt"},
      {"friction.series", "spring in series with the friction"},
      {"friction.parallel", "spring beside the friction"},
      {"friction.position", "position of the friction"},
      {"friction.shape", "mode shape at the friction"},
      {"forcing.position", "position of the force"},
      {"load.force", "constant force"},
      {"load.position", "position of the constant force"},
      {"initial.speed", "speed at the start"},
      {"gravity.acceleration", "acceleration of gravity"},
      {"hub.torque.amplitude", "torque of the hub"},
      {"hub.torque.duration", "duration of the torque"},
      {"hub.inertia", "inertia of the hub"},
      {"hub.radius", "radius of the hub"},
      {"initial.rate", "first rate of the hub"},
      {"stop.gap", "gap"},
      {"stop.motion.amplitude", "amplitude of the stop’s motion"},
      {"stop.motion.phase", "phase of the stop’s motion"},
      {"beam.section.diameter", "diameter"},
      {"beam.section.inner_diameter", "inner diameter"},
      {"stop.position", "position of the stop"},
      {"stop.restitution", "coefficient of restitution"},
      {"stop.shape", "mode shape at the stop"},
      {"stop.spring.stiffness", "stiffness k"},
      {"stop.spring.exponent", "exponent n"},
      {"stop.spring.damping.coefficient", "damping coefficient C"},
      {"stop.spring.damping.mass", "mass that the damping is for"},
      {"stop.spring.damping.onset", "depth h of the damping’s onset"},
      {"stop.spring.damping.sharpness", "sharpness Q of the damping’s onset"},
      {"stop.spring.damping.restitution", "restitution of the contact"},
      {"stop.spring.damping.speed", "reference speed of the contact"},
  };
  return kNames;
}

bool is_number(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::string parameter_title(const std::string& name) {
  const std::string path = name.substr(0, name.find(','));  // others are tied to it
  if (path.starts_with("matrices.")) {
    std::vector<std::string> words;
    std::istringstream parts(path);
    for (std::string word; std::getline(parts, word, '.');) words.push_back(word);
    if (words.size() == 4)
      return fmt::format("entry ({}, {}) of the matrix of {}", words[2], words[3], words[1]);
  }
  if (path.starts_with("initial.displacement."))
    return "displacement " + path.substr(21) + " at the start";
  if (path.starts_with("initial.velocity.")) return "velocity " + path.substr(17) + " at the start";
  if (path.starts_with("initial.qdot.")) return "dq_{" + path.substr(13) + "}/dt at the start";
  if (path.starts_with("initial.q.")) return "q_{" + path.substr(10) + "} at the start";
  std::string known, own, which, before;
  std::istringstream words(path);
  for (std::string word; std::getline(words, word, '.'); before = word) {
    if (word == "*") {
      which += ", every " + before;
      continue;
    }
    if (!is_number(word)) {
      known += (known.empty() ? "" : ".") + word;
      continue;
    }
    // A number at the end counts modes, elsewhere one of several tables.
    const bool is_last = words.peek() == std::istringstream::traits_type::eof();
    if (is_last)
      own = (before == "height" || before == "masses" ? " " : " of mode ") + word;
    else
      which += fmt::format(", {} {}", before, word);
  }
  const auto found = quantity_names().find(known);
  return found == quantity_names().end() ? as_markup(path) : found->second + own + which;
}

bool has_hertz_axis(const std::string& parameter, const std::string& unit) {
  return parameter == "forcing.frequency" && !unit.empty();
}

}  // namespace graze
