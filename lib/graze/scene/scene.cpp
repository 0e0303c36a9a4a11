#include "graze/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "graze/scene/detail/table_paths.hpp"

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
  const auto is_it = [&](const HarmonicLoad& load) { return load.kind == kind; };
  return forcing && (is_it(*forcing) || std::any_of(further.begin(), further.end(), is_it));
}

// A signal that stands first and repeats has a period, which further ones may have, too.
bool Scene::repeats() const {
  if (forcing && further.empty() && !forcing->signal) return true;
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

std::vector<StopMotion> Scene::motion_of(const SceneStop& stop) const {
  std::vector<StopMotion> terms = stop.motion;
  if (stop.frame == StopFrame::kClamp) return terms;
  for (const HarmonicLoad* load : harmonic_loads())
    if (load->kind == ForcingKind::kBase && !load->own && !load->signal)
      terms.push_back({-load->amplitude, load->order, load->phase});
  return terms;
}

bool Scene::has_moving_stop() const {
  const bool is_shaken = has_load(ForcingKind::kBase);
  return std::any_of(stops.begin(), stops.end(), [&](const SceneStop& stop) {
    return !stop.motion.empty() ||
           (is_shaken && stop.frame == StopFrame::kSpace && !motion_of(stop).empty());
  });
}

double Scene::common_order() const {
  // Beyond such denominators a motion would have to be followed over hundreds of periods.
  constexpr int kLargestDenominator = 64;
  // Of a ratio as it is written: 0.3333333333 is a third.
  constexpr double kWritten = 1e-9;
  const auto moves = [](const SceneStop& stop) { return !stop.motion.empty(); };
  const bool is_alone = further.empty() && std::none_of(stops.begin(), stops.end(), moves);
  if (is_alone && forcing && !forcing->signal && !forcing->order) return 1.0;
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
