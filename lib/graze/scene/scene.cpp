#include "graze/scene/scene.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "graze/scene/detail/table_paths.hpp"

namespace graze {

int Scene::modes() const {
  if (const Span* has_span = span()) return has_span->modes;
  if (const DiscreteStructure* given = discrete(); given && given->modes > 0) return given->modes;
  return static_cast<int>(modal()->frequencies.size());
}

namespace {

// The structure as one of those with this base, or null.
template <class Base>
Base* structure_as(auto& structure) {
  return std::visit(
      []<class Structure>(Structure& has) -> Base* {
        if constexpr (std::is_base_of_v<Base, Structure>)
          return &has;
        else
          return nullptr;
      },
      structure);
}

}  // namespace

const Span* Scene::span() const { return const_cast<Scene*>(this)->span(); }
Span* Scene::span() { return structure_as<Span>(structure); }
const DiscreteStructure* Scene::discrete() const { return const_cast<Scene*>(this)->discrete(); }
DiscreteStructure* Scene::discrete() { return structure_as<DiscreteStructure>(structure); }

const char* Scene::structure_name() const {
  if (string()) return "string";
  if (bar()) return "bar";
  if (matrices()) return "matrices";
  if (lumped()) return "lumped";
  return beam() ? "beam" : "modal";
}

InputError scene_error(const Scene& scene, const std::string& key, const std::string& sentence) {
  if (scene.origins == nullptr || scene.origins->empty()) {
    return InputError(fmt::format("{}: {}", key, sentence));
  }
  std::string above = first_unnumbered(key);
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
