#include "graze/scene/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// The lines of a scene's text, each with the header of its table: "[[stop]] gap = 0.01".
std::vector<std::string> lines_of(const Scene& scene) {
  std::istringstream text(write_scene(scene));
  std::vector<std::string> lines;
  std::string header;
  for (std::string line; std::getline(text, line);) {
    if (line.empty()) continue;
    if (line.front() == '[')
      header = line;
    else
      lines.push_back(header + " " + line);
  }
  return lines;
}

// Keeps only what an orbit depends on.
void strip(Scene& scene) {
  scene.title.clear();
  scene.initial.reset();
  scene.probes.clear();
  scene.solver = {};
  if (scene.forcing) scene.forcing->frequency.write_in_hertz(false);
}

}  // namespace

std::string scene_difference(Scene there, Scene here, const std::vector<std::string>& free) {
  strip(there);
  strip(here);
  for (const std::string& name : free) {
    try {
      const std::vector<TiedNumber> from = parameter_numbers(there, name);
      const std::vector<TiedNumber> to = parameter_numbers(here, name);
      for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k)
        *to[k].number = *from[k].number;
    } catch (const InputError&) {
      return fmt::format("one of them has no {}", name);
    }
  }
  // No orbit depends on the thickness, though it may be the parameter.
  for (Scene* scene : {&there, &here})
    if (Beam* beam = std::get_if<Beam>(&scene->structure)) beam->thickness.reset();
  const std::vector<std::string> before = lines_of(there), now = lines_of(here);
  for (std::size_t i = 0; i < before.size() || i < now.size(); ++i) {
    if (i >= before.size()) return fmt::format("it has no '{}'", now[i]);
    if (i >= now.size()) return fmt::format("it has '{}', this one has not", before[i]);
    if (before[i] != now[i]) return fmt::format("it has '{}', this one '{}'", before[i], now[i]);
  }
  return "";
}

}  // namespace graze
