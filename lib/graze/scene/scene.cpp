#include "graze/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "graze/scene/detail/table_paths.hpp"
#include "graze/scene/discrete_matrices.hpp"

namespace graze {

int Scene::modes() const {
  if (const Span* has_span = span()) return has_span->modes;
  if (const DiscreteStructure* given = discrete(); given && given->modes > 0) return given->modes;
  return static_cast<int>(modal()->frequencies.size());
}

std::vector<const HarmonicLoad*> Scene::harmonic_loads() const {
  if (!forcing) return {};
  std::vector<const HarmonicLoad*> list{&*forcing};
  for (const HarmonicLoad& load : further) list.push_back(&load);
  return list;
}

bool Scene::has_load(ForcingKind kind) const {
  const std::vector<const HarmonicLoad*> list = harmonic_loads();
  return std::any_of(list.begin(), list.end(),
                     [&](const HarmonicLoad* load) { return load->kind == kind; });
}

// A signal that stands first and repeats has a period, which further ones may have, too.
bool Scene::repeats() const {
  const std::vector<const HarmonicLoad*> list = harmonic_loads();
  const auto length = [](const HarmonicLoad& load) {
    const SignalSource& signal = *load.signal;
    return signal.repeats ? signal.course->times.back() - signal.course->times.front() : 0.0;
  };
  return forcing && std::all_of(list.begin(), list.end(), [&](const HarmonicLoad* load) {
           if (!load->signal) return !load->own;
           return forcing->signal && length(*load) > 0.0 && length(*load) == length(*forcing);
         });
}

std::array<double, 2> Scene::support_of(const HarmonicLoad& load) const {
  std::array<double, 2> sums{};
  const std::optional<int> mass = mass_named(*lumped(), load.at.node);
  for (const LumpedSpring& spring : lumped()->springs) {
    const std::optional<int> first = mass_named(*lumped(), spring.between[0]),
                             second = mass_named(*lumped(), spring.between[1]);
    if (!(first == mass && second == -1) && !(first == -1 && second == mass)) continue;
    sums[0] += spring.stiffness;
    sums[1] += spring.damping;
  }
  return sums;
}

std::vector<StopMotion> Scene::motion_of(const SceneStop& stop) const {
  std::vector<StopMotion> terms = stop.motion;
  if (stop.frame == StopFrame::kClamp) return terms;
  for (const HarmonicLoad* load : harmonic_loads())
    if (load->kind == ForcingKind::kBase && !load->own && !load->signal)
      terms.push_back({-load->amplitude, load->order, load->phase});
  return terms;
}

bool Scene::has_moving_stop() const {
  return std::any_of(stops.begin(), stops.end(),
                     [&](const SceneStop& stop) { return !motion_of(stop).empty(); });
}

double Scene::common_order() const {
  // Beyond such denominators a motion would have to be followed over hundreds of periods.
  constexpr int kLargestDenominator = 64;
  // Of a ratio as it is written: 0.3333333333 is a third.
  constexpr double kWritten = 1e-9;
  std::vector<double> orders;
  for (const HarmonicLoad* load : harmonic_loads())
    if (!load->own && !load->signal) orders.push_back(load->order.value_or(1.0));
  for (const SceneStop& stop : stops)
    for (const StopMotion& term : stop.motion) orders.push_back(term.order.value_or(1.0));
  if (orders.empty()) return 1.0;
  for (int q = 1; q <= kLargestDenominator; ++q) {
    long long common = 0;
    bool fits = true;
    for (const double order : orders) {
      const double multiple = q * order, whole = std::round(multiple);
      fits = fits && whole >= 1.0 && std::abs(multiple - whole) <= kWritten * multiple;
      if (fits) common = std::gcd(common, std::llround(whole));
    }
    if (fits && common > 0) return static_cast<double>(common) / q;
  }
  return 0.0;
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
