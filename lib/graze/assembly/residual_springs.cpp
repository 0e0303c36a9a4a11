#include "graze/assembly/detail/residual_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/scene/detail/table_paths.hpp"
#include "graze/structure/static_response.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Largest relative error of the residual flexibility that is accepted: two digits are known.
constexpr double kKnown = 0.01;

bool is_residual(const SceneStop& stop) { return stop.spring && stop.spring->is_residual; }

bool any_is_residual(const Scene& scene) {
  return std::any_of(scene.stops.begin(), scene.stops.end(), is_residual);
}

std::string stiffness_path(std::size_t stop) {
  return numbered_path("stop", stop + 1) + ".spring.stiffness";
}

// The row of a stop, positive towards it.
Vector row_of(const Scene& scene, const ModalModel& model, std::size_t stop) {
  return (scene.stops[stop].side == Side::kAbove ? 1.0 : -1.0) * model.shapes[stop];
}

// Whether two stops are on either side of one place, so that only one of them can be touched.
bool face_each_other(const Scene& scene, const ModalModel& model, std::size_t a, std::size_t b) {
  constexpr double kRoundings = 64.0;
  const Vector first = row_of(scene, model, a), second = row_of(scene, model, b);
  return scene.stops[a].gap + scene.stops[b].gap > 0.0 &&
         (first + second).norm() <=
             kRoundings * std::numeric_limits<double>::epsilon() * first.norm();
}

std::string modes_text(int modes) { return modes == 1 ? "mode" : fmt::format("{} modes", modes); }

void check_left(const Scene& scene, const ModalModel& model, const Matrix& left,
                const Vector& uncertain) {
  const int free = free_motions(scene, model);
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    const auto k = static_cast<Index>(i);
    if (!is_residual(scene.stops[i])) continue;
    if (free > scene.modes())
      throw scene_error(
          scene, stiffness_path(i),
          fmt::format("\"residual\" is not allowed, the structure is free to make {} rigid "
                      "motions, which no stiffness holds; there must be at least as many modes",
                      free));
    if (uncertain[k] <= kKnown * left(k, k)) continue;
    throw scene_error(
        scene, stiffness_path(i),
        fmt::format("\"residual\" is not allowed, the flexibility that the {} leave{} out at the "
                    "stop, {:.2g}{}, is not known better than to {:.2g}; it must be a number, or "
                    "the modes fewer",
                    modes_text(scene.modes()), scene.modes() == 1 ? "s" : "", left(k, k),
                    unit_behind(scene.units, "m/N"), uncertain[k]));
  }
}

// Checks the coupling to all other stops, rigid ones too: their forces move the modes left out.
void check_coupling(const Scene& scene, const ModalModel& model, const Matrix& left,
                    const Vector& uncertain) {
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const bool last = is_residual(scene.stops[i]);
      if ((!last && !is_residual(scene.stops[k])) || face_each_other(scene, model, k, i)) continue;
      const auto m = static_cast<Index>(k), n = static_cast<Index>(i);
      const double coupling = std::abs(left(m, n)) /
                              std::sqrt((left(m, m) + uncertain[m]) * (left(n, n) + uncertain[n]));
      if (coupling <= kSeenFlexibility) continue;
      throw scene_error(
          scene, stiffness_path(last ? i : k),
          fmt::format("\"residual\" is not allowed, the modes left out couple stops {} and {} by "
                      "{:.2g}; it must be at most {:g}: more modes, or stops farther apart",
                      k + 1, i + 1, coupling, kSeenFlexibility));
    }
}

}  // namespace

std::vector<ResidualSpring> residual_springs(const Scene& scene, const ModalModel& model) {
  std::vector<ResidualSpring> springs;
  if (!any_is_residual(scene)) return springs;
  const StaticResponse whole = *static_response(scene);
  const StaticResponse left = residual_response(whole, model);
  const Vector uncertain = residual_uncertainty(scene, whole, model);
  check_left(scene, model, left.flexibility, uncertain);
  check_coupling(scene, model, left.flexibility, uncertain);
  springs.resize(scene.stops.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    if (!is_residual(scene.stops[i])) continue;
    const auto k = static_cast<Index>(i);
    springs[i].stiffness = 1.0 / left.flexibility(k, k);
    if (scene.gravity) springs[i].shift = scene.gravity->acceleration * left.under_gravity[k];
  }
  return springs;
}

std::vector<ResidualSpring> residual_spring_rates(const Scene& scene, const Scene& direction,
                                                  const ModalModel& model, const ModalModel& rate) {
  std::vector<ResidualSpring> rates;
  if (!any_is_residual(scene)) return rates;
  const StaticResponse left = residual_response(*static_response(scene), model);
  const StaticResponse moves = residual_response_rate(scene, direction, model, rate);
  rates.resize(scene.stops.size());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (!is_residual(scene.stops[i])) continue;
    const auto k = static_cast<Index>(i);
    rates[i].stiffness = -moves.flexibility(k, k) / std::pow(left.flexibility(k, k), 2.0);
    if (scene.gravity)
      rates[i].shift = direction.gravity->acceleration * left.under_gravity[k] +
                       scene.gravity->acceleration * moves.under_gravity[k];
  }
  return rates;
}

}  // namespace graze
