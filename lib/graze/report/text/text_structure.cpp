#include "graze/report/text/detail/text_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/report/text/detail/text_units.hpp"
#include "graze/scene/closed_modes.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {
namespace {

using Effects = std::vector<std::pair<std::string, std::string>>;

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

const char* hold_word(Hold hold, bool is_beam) {
  switch (hold) {
    case Hold::kFree:
      return "free";
    case Hold::kPinned:
      return is_beam ? "pinned" : "fixed";
    case Hold::kClamped:
      return "clamped";
    case Hold::kSliding:
      return "sliding";
    case Hold::kSpring:
      break;
  }
  return "spring";
}

// "0.02 m" or "0.02 to 0.01 m"
std::string taper_text(const Taper& taper, const TextUnits& in) {
  const std::string last = in.quantity(taper.back(), 6, "m");
  return taper.size() == 1 ? last : fmt::format("{} to {}", digits_text(taper.front(), 6), last);
}

std::string section_text(const Section& section, const TextUnits& in) {
  switch (section.shape) {
    case SectionShape::kRectangle:
      return fmt::format("rectangle, width {}, height {}", taper_text(section.width, in),
                         taper_text(section.height, in));
    case SectionShape::kCircle:
      return "circle, diameter " + taper_text(section.diameter, in);
    case SectionShape::kTube:
      break;
  }
  return fmt::format("tube, diameter {}, inner diameter {}", taper_text(section.diameter, in),
                     taper_text(section.inner_diameter, in));
}

void add_pieces(Effects& effects, const auto& whole, const TextUnits& in) {
  if (whole.section) effects.emplace_back("section", section_text(*whole.section, in));
  double start = 0.0;
  for (std::size_t k = 0; k < whole.pieces.size(); ++k) {
    const Piece& piece = whole.pieces[k];
    const double end = piece.to.value_or(whole.length);
    std::string text =
        fmt::format("from x = {} to {}", digits_text(start, 6), in.quantity(end, 6, "m"));
    if (piece.section) text += ", " + section_text(*piece.section, in);
    if (piece.area) text += ", area " + in.quantity(*piece.area, 6, "m^2");
    if (piece.youngs_modulus) text += ", E " + in.quantity(*piece.youngs_modulus, 6, "Pa");
    if (piece.density) text += ", density " + in.quantity(*piece.density, 6, "kg/m^3");
    effects.emplace_back(fmt::format("piece {}", k + 1), text);
    start = end;
  }
}

void add_places(Effects& effects, const Span& span, bool is_beam, const TextUnits& in) {
  const auto place = [&](const std::optional<double>& position) {
    return "at x = " + in.quantity(position.value_or(span.length), 6, "m");
  };
  for (std::size_t k = 0; k < span.supports.size(); ++k) {
    const Support& support = span.supports[k];
    std::string text =
        fmt::format("{}, {}", place(support.position), hold_word(support.kind, is_beam));
    if (support.translational > 0.0) text += " " + in.quantity(support.translational, 6, "N/m");
    if (support.rotational > 0.0)
      text += fmt::format("{} {}", support.translational > 0.0 ? "," : "",
                          in.quantity(support.rotational, 6, "N m/rad"));
    effects.emplace_back(fmt::format("support {}", k + 1), text);
  }
  for (std::size_t k = 0; k < span.masses.size(); ++k) {
    const AttachedMass& mass = span.masses[k];
    std::string text = place(mass.position) + ", " + in.quantity(mass.mass, 6, "kg");
    if (mass.inertia > 0.0) text += ", inertia " + in.quantity(mass.inertia, 6, "kg m^2");
    effects.emplace_back(fmt::format("mass {}", k + 1), text);
  }
}

// Below 1e-12 there is rounding only.
std::string accuracy_text(double change) { return fmt::format("{:.0e}", std::max(change, 1e-12)); }

std::string elements_text(const ElementAccuracy& found) {
  std::string text = fmt::format("{} of order {}, frequencies to {}", found.elements, found.order,
                                 accuracy_text(found.change));
  if (found.change_beyond > 0.0)
    text += fmt::format(" (modes 1 to 32) and {} (beyond)", accuracy_text(found.change_beyond));
  if (found.rigid > 0)
    text +=
        fmt::format("; {} free", counted(static_cast<std::size_t>(found.rigid), "rigid motion"));
  return text;
}

std::string span_text(const Scene& scene) {
  const Span& span = *scene.span();
  const bool is_beam = scene.beam() != nullptr;
  return fmt::format("{}-{} {}", hold_word(span.ends[0], is_beam), hold_word(span.ends[1], is_beam),
                     scene.structure_name());
}

}  // namespace

std::vector<std::pair<std::string, std::string>> structure_effects(
    const Scene& scene, const std::optional<ElementAccuracy>& elements) {
  const TextUnits in(scene.units);
  const std::string modes = counted(static_cast<std::size_t>(scene.modes()), "mode");
  if (const MatrixStructure* matrices = scene.matrices())
    return {{"structure", fmt::format("the lowest {} of matrices with {} degrees of freedom", modes,
                                      matrices->solved->free_count())}};
  if (const LumpedStructure* lumped = scene.lumped())
    return {{"structure", fmt::format("{} of {} and {}", modes,
                                      lumped->masses.size() == 1
                                          ? "1 mass"
                                          : fmt::format("{} masses", lumped->masses.size()),
                                      counted(lumped->springs.size(), "spring"))}};
  if (scene.modal()) return {{"structure", "given by " + modes}};
  Effects effects{{"structure", fmt::format("{}, {}", span_text(scene), modes)}};
  if (const Beam* beam = scene.beam()) {
    effects.front().second += beam->discretisation == Projection::kGalerkin
                                  ? ", Galerkin projection"
                                  : ", collocation projection";
    add_pieces(effects, *beam, in);
    if (beam->tension)
      effects.emplace_back(*beam->tension < 0.0 ? "compression" : "tension",
                           in.quantity(std::abs(*beam->tension), 6, "N"));
  } else if (const Bar* bar = scene.bar()) {
    add_pieces(effects, *bar, in);
  } else if (!scene.string()->frequencies.empty()) {
    effects.front().second += ", frequencies given";
  }
  add_places(effects, *scene.span(), scene.beam() != nullptr, in);
  if (elements) effects.emplace_back("elements", elements_text(*elements));
  return effects;
}

}  // namespace graze
