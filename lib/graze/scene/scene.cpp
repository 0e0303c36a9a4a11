#include "graze/scene/scene.hpp"

#include <fmt/format.h>

namespace graze {
namespace {

// The first stop may be called stop or stop.1, so a probe; its keys are remembered under the
// former.
std::string canonical(const std::string& key) {
  for (const std::string list : {"stop", "probe"}) {
    const std::string numbered = list + ".1";
    if (key == numbered || key.compare(0, numbered.size() + 1, numbered + ".") == 0) {
      return list + key.substr(numbered.size());
    }
  }
  return key;
}

}  // namespace

int Scene::modes() const {
  if (const Beam* has_beam = beam()) {
    return has_beam->modes;
  }
  if (const MatrixStructure* has_matrices = matrices()) return has_matrices->modes;
  return static_cast<int>(modal()->frequencies.size());
}

InputError scene_error(const Scene& scene, const std::string& key, const std::string& sentence) {
  if (scene.origins == nullptr || scene.origins->empty()) {
    return InputError(fmt::format("{}: {}", key, sentence));
  }
  std::string above = canonical(key);
  while (true) {
    const auto found = scene.origins->find(above);
    if (found != scene.origins->end()) {
      return InputError(found->second, key, sentence);
    }
    if (above.empty()) {
      // The scene as a whole: origins made by the reader always have it.
      return InputError(fmt::format("{}: {}", key, sentence));
    }
    const std::size_t dot = above.rfind('.');
    above = dot == std::string::npos ? "" : above.substr(0, dot);
  }
}

}  // namespace graze
