#include "fuzz/extreme_scenes.hpp"

#include <cmath>
#include <cstdio>
#include <functional>

namespace graze {
namespace {

double between(double low, double high, Draw& draw) {
  constexpr std::size_t kParts = 1U << 30;
  return low + (high - low) * static_cast<double>(draw.below(kParts)) / kParts;
}

// Of any order of magnitude in between.
double scaled(double low, double high, Draw& draw) {
  return std::pow(10.0, between(std::log10(low), std::log10(high), draw));
}

std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string list_of(std::size_t count, const std::function<double()>& number) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string digits = written(number());
    text += (i > 0 ? ", " : "") + digits;
    if (digits.find_first_of(".e") == std::string::npos) text += ".0";
  }
  return text + "]";
}

std::string key(const std::string& name, const std::string& value) {
  return name + " = " + value + "\n";
}

double part(Draw& draw) {
  return draw.once_in(20) ? scaled(1e-6, 1e6, draw) : between(-1.0, 1.0, draw);
}

std::string contact(Draw& draw) {
  static const std::vector<std::string> kRestitutions{
      "0.0", "0.5", "0.8", "0.8", "1.0", "1e-300", "0.999999999", "[1.0, 0.1]", "[0.9, 1e3, -5.0]"};
  if (!draw.once_in(3)) return key("restitution", draw.of(kRestitutions));
  std::string text =
      "[stop.spring]\n" + key("stiffness", written(scaled(1e-5, 1e13, draw))) +
      key("exponent", draw.of<std::string>({"1.0", "1.0", "1.2", "1.5", "2.0", "3.7"}));
  if (draw.once_in(2))
    text += key("damping", "{model = \"" +
                               draw.of<std::string>({"kelvin-voigt", "kelvin-voigt",
                                                     "hunt-crossley", "lee-wang-1"}) +
                               "\", coefficient = " + written(scaled(1e-6, 1e6, draw)) + "}");
  if (draw.once_in(4)) text += key("release", "\"position\"");
  return text;
}

std::string gap(Draw& draw) {
  static const std::vector<std::string> kGaps{"0.0", "1e-12", "1e-6", "1e-6", "-0.001"};
  if (!draw.once_in(3)) return draw.of(kGaps);
  return written(draw.once_in(2) ? between(0.0, 1.0, draw) : scaled(1e-12, 1e2, draw));
}

}  // namespace

std::string extreme_scene(Draw& draw) {
  static const std::vector<std::size_t> kModes{1, 1, 2, 3, 10, 60, 100, 200};
  static const std::vector<std::size_t> kStops{1, 1, 1, 2, 3, 5, 12, 50};
  const std::size_t modes = draw.of(kModes), stops = draw.of(kStops);
  // Within some decades of a scale that may be any.
  const double scale = draw.once_in(3) ? scaled(1e-8, 1e8, draw) : 1.0;
  const double spread = draw.of<double>({1.0, 10.0, 1e4, 1e8});
  std::vector<double> frequencies(modes);
  for (double& frequency : frequencies) frequency = scale * scaled(1.0 / spread, spread, draw);
  const auto ratio = [&] {
    return draw.once_in(4) ? draw.of<double>({0.0, 0.0, 1e-12, 1e-12, 1.0, 1e4})
                           : between(0.0, 0.05, draw);
  };
  std::size_t at = 0;
  std::string text = "units = \"none\"\n[modal]\n" +
                     key("frequencies", list_of(modes, [&] { return frequencies[at++]; })) +
                     key("damping_ratios", list_of(modes, ratio)) +
                     key("participation", list_of(modes, [&] { return part(draw); })) +
                     key("inertia", list_of(modes, [&] { return part(draw); }));
  const double forcing = draw.once_in(2) ? draw.of(frequencies) : scale * scaled(1e-8, 1e8, draw);
  text += "[forcing]\n" + key("amplitude", written(draw.once_in(8) ? 0.0 : part(draw))) +
          key("frequency", written(forcing)) +
          key("phase", written(draw.once_in(4) ? between(-10.0, 10.0, draw) : 0.0));
  if (draw.once_in(4)) text += "[gravity]\n" + key("acceleration", written(part(draw)));
  std::string shape;
  for (std::size_t i = 0; i < stops; ++i) {
    // Some are the same, some face each other.
    if (shape.empty() || !draw.once_in(5)) shape = list_of(modes, [&] { return part(draw); });
    text += "[[stop]]\n" + key("shape", shape) + key("gap", gap(draw)) +
            key("side", draw.once_in(2) ? "\"above\"" : "\"below\"") + contact(draw);
  }
  if (draw.once_in(3)) return text;
  const auto start = [&] { return draw.once_in(2) ? 0.0 : 1e-3 * scale * part(draw); };
  return text + "[initial]\n" + key("q", list_of(modes, [&] { return 0.0; })) +
         key("qdot", list_of(modes, start));
}

std::vector<std::string> extreme_command(const std::string& scene, Draw& draw) {
  static const std::vector<std::vector<std::string>> kRanges{{"forcing.frequency", "0.5", "2"},
                                                             {"forcing.frequency", "1e-9", "1e12"},
                                                             {"forcing.phase", "1e-06", "1000"},
                                                             {"forcing.amplitude", "1e-6", "1"},
                                                             {"stop.gap", "1e-4", "1.5"}};
  static const std::vector<std::vector<std::string>> kCommands{
      {"simulate", "--duration", "100"},
      {"simulate", "--periods", "1000", "--amplitudes", "--forces", "50", "--record", "none"},
      {"simulate", "--duration", "1e6", "--record", "none", "--energy", "--amplitudes"},
      {"orbit"},
      {"orbit", "--impacts", "2", "--period", "3"},
      {"continue", "--impacts", "1"},
      {"continue", "--follow", "all"},
      {"continue", "--locus", "all"},
      {"continue", "--locus", "CH"},
      {"diagram", "--points", "6"},
      {"diagram", "--points", "6", "--exponents", "100", "--amplitudes"},
      {"map", "--points", "4", "--second-points", "3"},
      {"compare", "--against", "stop.gap=2e-3"},
      {"compare", "--against", "forcing.amplitude=2e-3"},
      {"cost"},
      {"modes"},
      {"check"}};
  std::vector<std::string> words = draw.of(kCommands);
  words.insert(words.begin() + 1, scene);
  const auto add = [&](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (words[0] != "continue" && words[0] != "diagram" && words[0] != "map") return words;
  const std::vector<std::string>& range = draw.of(kRanges);
  add({"--parameter", range[0], "--from", range[1], "--to", range[2]});
  if (words[0] == "map" || words[2] == "--locus")
    add({"--second", range[0] == "stop.gap" ? "forcing.frequency" : "stop.gap", "--second-from",
         "0.1", "--second-to", "1"});
  return words;
}

}  // namespace graze
