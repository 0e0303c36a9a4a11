#include "graze/scene/detail/span_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "graze/scene/closed_modes.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/section_numbers.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

constexpr const char* kLengthWords = "a number greater than 0, in m";

void check_section(const ValueChecker& checker, const Section& section) {
  if (section.shape != SectionShape::kTube) return;
  for (const std::size_t end : {0u, 1u}) {
    const auto at = [&](const Taper& taper) { return taper.size() == 2 ? taper[end] : taper[0]; };
    const double inner = at(section.inner_diameter), outer = at(section.diameter);
    if (inner < outer) continue;
    const std::string key = section.inner_diameter.size() == 2
                                ? fmt::format("section.inner_diameter.{}", end + 1)
                                : "section.inner_diameter";
    checker.refuse(key, inner, fmt::format("less than the diameter there, which is {}", outer));
  }
}

// Properties that a beam and a bar, and their pieces, give in the same words.
void check_properties(const ValueChecker& checker, bool is_needed, bool bends,
                      const std::optional<Section>& section,
                      const std::optional<double>& second_moment,
                      const std::optional<double>& area) {
  if (section) {
    check_section(checker, *section);
    return;
  }
  if (bends && !second_moment && (is_needed || area))
    checker.fail("second_moment", "the key is missing, it must be a number greater than 0, in m^4");
  if (!area && (is_needed || second_moment))
    checker.fail("area", "the key is missing, it must be a number greater than 0, in m^2");
}

void check_pieces(const Scene& scene, const std::vector<Piece>& pieces, double length) {
  const std::string list = fmt::format("{}.piece", scene.structure_name());
  double before = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const ValueChecker checker(scene, numbered_path(list, k + 1));
    const Piece& piece = pieces[k];
    const bool last = k + 1 == pieces.size();
    if (last && piece.to)
      checker.fail("to", fmt::format("the last piece ends where the {} does, it must be left out",
                                     scene.structure_name()));
    if (!last && !piece.to)
      checker.fail("to",
                   fmt::format("the key is missing, it must be {}: only the last piece has none",
                               kLengthWords));
    if (!last && !(*piece.to > before && *piece.to < length))
      checker.refuse("to", *piece.to,
                     fmt::format("greater than {}, where the piece begins, and less than the "
                                 "length {}",
                                 before, length));
    if (!last) before = *piece.to;
    const bool own = piece.section || piece.area || piece.second_moment;
    check_properties(checker, own, scene.beam() != nullptr, piece.section, piece.second_moment,
                     piece.area);
  }
}

// A beam or a bar as a whole: what it gives is needed where a piece has nothing of its own.
void check_whole(const Scene& scene, const auto& span, bool bends,
                 const std::optional<double>& second_moment) {
  const ValueChecker checker(scene, scene.structure_name());
  const bool all_own = !span.pieces.empty() &&
                       std::all_of(span.pieces.begin(), span.pieces.end(), [](const Piece& piece) {
                         return piece.section || piece.area || piece.second_moment;
                       });
  check_properties(checker, !all_own, bends, span.section, second_moment, span.area);
  check_pieces(scene, span.pieces, span.length);
}

void check_string(const Scene& scene, const TautString& string) {
  const ValueChecker checker(scene, "string");
  if (string.frequencies.empty() && !string.tension)
    checker.fail("tension", "the key is missing, it must be a number greater than 0, in N");
  if (!string.frequencies.empty() && !has_closed_modes(scene))
    checker.fail("frequencies",
                 "supports and masses change the shapes of a string, which are not given, it must "
                 "be left out");
}

double place(const std::optional<double>& position, const Span& span) {
  return position.value_or(span.length);
}

void check_place(const ValueChecker& checker, const Scene& scene,
                 const std::optional<double>& position) {
  const double length = scene.span()->length;
  if (position && !(*position >= 0.0 && *position <= length))
    checker.refuse(
        "position", *position,
        fmt::format("at least 0 and at most the {}'s length {}", scene.structure_name(), length));
}

bool holds_value(Hold hold) { return hold == Hold::kPinned || hold == Hold::kClamped; }

void check_supports(const Scene& scene, const Span& span) {
  const std::string list = fmt::format("{}.support", scene.structure_name());
  for (std::size_t k = 0; k < span.supports.size(); ++k) {
    const Support& support = span.supports[k];
    const ValueChecker checker(scene, numbered_path(list, k + 1));
    check_place(checker, scene, support.position);
    if (support.kind == Hold::kSpring && support.translational == 0.0 && support.rotational == 0.0)
      checker.fail("kind",
                   scene.beam()
                       ? "a spring needs a stiffness, translational or rotational must be "
                         "greater than 0"
                       : "a spring needs a stiffness, translational must be greater than 0");
    if (support.kind == Hold::kSpring) continue;
    for (std::size_t other = 0; other < k; ++other)
      if (span.supports[other].kind != Hold::kSpring &&
          place(span.supports[other].position, span) == place(support.position, span))
        checker.fail(
            "position",
            fmt::format("support {} holds this place already, one of them must be left out",
                        other + 1));
  }
}

void check_masses(const Scene& scene, const Span& span) {
  const std::string list = fmt::format("{}.mass", scene.structure_name());
  for (std::size_t k = 0; k < span.masses.size(); ++k) {
    const ValueChecker checker(scene, numbered_path(list, k + 1));
    check_place(checker, scene, span.masses[k].position);
    if (span.masses[k].mass == 0.0 && span.masses[k].inertia == 0.0)
      checker.fail("mass", scene.beam() ? "mass and inertia are 0, one of them must be greater"
                                        : "0 is not allowed, it must be a number greater than 0");
  }
}

// Area times density of every piece of a beam or bar, 0 where it varies.
double even_mass(const auto& span) {
  const auto area = [](const std::optional<Section>& section, const std::optional<double>& given) {
    if (section) return is_tapered(*section) ? 0.0 : section_numbers(*section).area;
    return given.value_or(0.0);
  };
  const double whole = area(span.section, span.area);
  double mass = span.pieces.empty() ? whole * span.density : -1.0;
  for (const Piece& piece : span.pieces) {
    const double own = piece.section || piece.area ? area(piece.section, piece.area) : whole;
    const double here = own * piece.density.value_or(span.density);
    if (mass >= 0.0 && std::abs(here - mass) > 1e-14 * mass) return 0.0;
    mass = here;
  }
  return mass;
}

bool is_mass_even(const Scene& scene) {
  if (const TautString* string = scene.string()) return string->masses.empty();
  if (!scene.span()->masses.empty()) return false;
  return (scene.beam() ? even_mass(*scene.beam()) : even_mass(*scene.bar())) > 0.0;
}

// Whether a rigid support, or an end, holds u = 0 there.
bool is_held(const Span& span, double x) {
  const auto at = [&](double place) {
    return std::abs(x - place) <= 8.0 * std::numeric_limits<double>::epsilon() * span.length;
  };
  if (at(0.0) && holds_value(span.ends[0])) return true;
  if (at(span.length) && holds_value(span.ends[1])) return true;
  return std::any_of(span.supports.begin(), span.supports.end(), [&](const Support& support) {
    return holds_value(support.kind) && at(place(support.position, span));
  });
}

bool is_held_anywhere(const Span& span) {
  return holds_value(span.ends[0]) || holds_value(span.ends[1]) ||
         std::any_of(span.supports.begin(), span.supports.end(), [](const Support& support) {
           return holds_value(support.kind) || support.translational > 0.0;
         });
}

}  // namespace

void check_span(const Scene& scene) {
  const Span* span = scene.span();
  if (span == nullptr) return;
  if (const Beam* beam = scene.beam()) check_whole(scene, *beam, true, beam->second_moment);
  if (const Bar* bar = scene.bar()) check_whole(scene, *bar, false, {});
  check_supports(scene, *span);
  check_masses(scene, *span);
  if (const TautString* string = scene.string()) check_string(scene, *string);
  const ValueChecker checker(scene, scene.structure_name());
  if (!has_closed_modes(scene) && span->modes > kMostElementModes)
    checker.fail("modes",
                 fmt::format("{} is not allowed, modes that have no closed form are found by "
                             "elements, it must be at most {}",
                             span->modes, kMostElementModes));
}

namespace {

void check_projection(const Scene& scene) {
  const Beam* beam = scene.beam();
  const bool closed = has_closed_modes(scene);
  const char* sentence =
      "the collocation is that of a uniform clamped-free beam without supports, masses and "
      "tension, it must be";
  if (beam && !closed && beam->discretisation == Projection::kCollocation)
    throw scene_error(scene, "beam.discretisation", fmt::format("{} \"galerkin\"", sentence));
  for (std::size_t k = 0; k < scene.stops.size(); ++k)
    if (!scene.stops[k].spring && scene.stops[k].impulse == Impulse::kCollocation && !closed &&
        beam)
      throw scene_error(scene, numbered_path("stop", k + 1) + ".impulse",
                        fmt::format("{} \"momentum\"", sentence));
  if (scene.hub && beam && !closed)
    throw scene_error(scene, "hub",
                      "a hub carries a uniform clamped-free beam without supports, masses and "
                      "tension, it must be left out");
}

// The section, if any, at a place; that of the whole where a piece has none.
bool has_height(const Beam& beam, double x) {
  for (const Piece& piece : beam.pieces) {
    if (piece.to && x > *piece.to) continue;
    if (piece.section) return true;
    return !piece.area && beam.section;
  }
  return beam.section.has_value();
}

void check_strain(const Scene& scene, const Probe& probe, std::size_t number) {
  if (probe.quantity != ProbeQuantity::kStrain) return;
  const Beam* beam = scene.beam();
  if (beam && !beam->thickness && !has_height(*beam, probe.position))
    throw scene_error(scene, "beam.thickness",
                      "the key is missing, a probe of the strain needs a number greater than 0, "
                      "in m");
  if (scene.string())
    throw scene_error(scene, numbered_path("probe", number) + ".quantity",
                      "the strain of a string is that of its tension, it must be "
                      "\"displacement\", \"velocity\" or \"deflection\"");
}

}  // namespace

void check_on_span(const Scene& scene) {
  const Span* span = scene.span();
  if (span == nullptr) return;
  check_projection(scene);
  if (scene.damping && std::holds_alternative<ViscousDamping>(*scene.damping) &&
      !is_mass_even(scene))
    throw scene_error(scene, "damping.viscous",
                      "viscous damping per length couples the modes where the mass per length "
                      "varies or masses are attached, it must be rayleigh = { mass = .., "
                      "stiffness = .. }, which is spread like the mass, or ratios");
  if (scene.has_load(ForcingKind::kBase) && !is_held_anywhere(*span))
    throw scene_error(scene, "forcing.kind",
                      fmt::format("nothing holds the {} against u, so no base moves it; it must be "
                                  "distributed",
                                  scene.structure_name()));
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const double x = scene.stops[k].position;
    const ValueChecker checker(scene, numbered_path("stop", k + 1));
    if (is_held(*span, x))
      checker.fail("position", fmt::format("at {} the {} is held and cannot move, it must be "
                                           "another place",
                                           x, scene.structure_name()));
  }
  for (std::size_t k = 0; k < scene.probes.size(); ++k) check_strain(scene, scene.probes[k], k + 1);
}

}  // namespace graze
