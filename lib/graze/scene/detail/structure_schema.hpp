// The keys of structures (schema.hpp): beam, string, bar, given modes.
#pragma once

#include <array>

#include "graze/scene/detail/choices.hpp"
#include "graze/scene/detail/matrix_schema.hpp"
#include "graze/scene/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

void describe(auto& v, Of<Section> auto& section, const Scene&) {
  v.choice({"shape", "", kAny, "of the cross-section"}, section.shape, kSectionShapes);
  const SectionShape shape = section.shape;
  const auto length = [&](const char* name, const char* meaning, bool applies, const char* needed,
                          auto& values) {
    v.taper(Key{name, "m", kPositive.told("> 0, or two of them"), meaning}
                .needed(needed)
                .where(applies, "a section of this shape has none, it must be left out")
                .as("a number greater than 0, in m, or a list of two"),
            values);
  };
  const bool rectangle = shape == SectionShape::kRectangle, tube = shape == SectionShape::kTube;
  length("width", "b; of two numbers the first holds at the left end, the second at the right one",
         rectangle, "required with `\"rectangle\"`", section.width);
  length("height", "h, in the direction of u: I = b h^3/12", rectangle,
         "required with `\"rectangle\"`", section.height);
  length("diameter", "D, outer", !rectangle, "required with `\"circle\"` and `\"tube\"`",
         section.diameter);
  length("inner_diameter", "d < D", tube, "required with `\"tube\"`", section.inner_diameter);
}

void describe(auto& v, Of<Piece> auto& piece, const Scene& scene) {
  const char* follows = "it follows from the section, it must be left out";
  v.number(Key{"to", "m", own_rule("rising, < L"), "where the piece ends"}.needed(
               "required but of the last, which ends at L"),
           piece.to);
  v.number(Key{"second_moment", "m^4", kPositive, "I, of a beam"}
               .needed("that of the whole; with `area`")
               .where(!piece.section && scene.bar() == nullptr,
                      piece.section ? follows : "a bar does not bend, it must be left out"),
           piece.second_moment);
  v.number(
      Key{"area", "m^2", kPositive, "A"}.needed("that of the whole").where(!piece.section, follows),
      piece.area);
  v.table({"section", Form::kInline}, piece.section);
  v.number(Key{"youngs_modulus", "Pa", kPositive, "E"}.needed("that of the whole"),
           piece.youngs_modulus);
  v.number(Key{"density", "kg/m^3", kPositive, "rho"}.needed("that of the whole"), piece.density);
}

void describe(auto& v, Of<Support> auto& support, const Scene& scene) {
  v.number(Key{"position", "m", own_rule("in [0, L]"), "distance from the left end"}.needed("L"),
           support.position);
  const Key kind =
      Key{"kind", "",
          own_rule(
              "`\"pinned\"`, `\"clamped\"` or `\"sliding\"`; of a string or a bar `\"fixed\"`"),
          "spring: by the two stiffnesses; pinned, fixed: u = 0; clamped: u = u' = 0; sliding: "
          "u' = 0"}
          .or_else();
  if (scene.beam())
    v.choice(kind, support.kind, kBeamSupports);
  else
    v.choice(kind, support.kind, kLineSupports);
  const bool yields = support.kind == Hold::kSpring;
  const char* rigid = "a rigid support has none, it must be left out";
  v.number(
      Key{"translational", "N/m", kNotNegative, "stiffness against u, of a spring"}.or_else().where(
          yields, rigid),
      support.translational);
  v.number(
      Key{"rotational", "N m/rad", kNotNegative, "stiffness against u', of a spring; of a beam"}
          .or_else()
          .where(yields && scene.beam(),
                 yields ? "only a beam resists turning, it must be left out" : rigid),
      support.rotational);
}

void describe(auto& v, Of<AttachedMass> auto& mass, const Scene& scene) {
  v.number(Key{"position", "m", own_rule("in [0, L]"), "distance from the left end"}.needed("L"),
           mass.position);
  v.number({"mass", "kg", kNotNegative, "fixed to the structure at a point"}, mass.mass);
  v.number(
      Key{"inertia", "kg m^2", kNotNegative, "against turning with u', of a beam"}.or_else().where(
          scene.beam() != nullptr, "only a beam turns it, it must be left out"),
      mass.inertia);
}

// What beams, strings and bars have in common, behind their own keys.
void describe_places(auto& v, auto& span) {
  v.tables({"support"}, span.supports);
  v.tables({"mass"}, span.masses);
}

void describe(auto& v, Of<Beam> auto& beam, const Scene&) {
  const bool whole = !beam.section;
  const char* follows = "it follows from the section, it must be left out";
  v.number({"length", "m", kPositive, "L"}, beam.length);
  v.number({"youngs_modulus", "Pa", kPositive, "E"}, beam.youngs_modulus);
  v.number(Key{"second_moment", "m^4", kPositive, "I, second moment of area"}
               .needed("required without `section`")
               .where(whole, follows),
           beam.second_moment);
  v.number({"density", "kg/m^3", kPositive, "rho"}, beam.density);
  v.number(Key{"area", "m^2", kPositive, "A, of the cross-section"}
               .needed("required without `section`")
               .where(whole, follows),
           beam.area);
  v.table({"section", Form::kInline}, beam.section);
  v.number(Key{"thickness", "m", kPositive, "h, of the section; only strains depend on it"}
               .or_else("that of the section, if any")
               .where(whole, follows),
           beam.thickness);
  v.ends(Key{"ends", "", own_rule("two of `\"clamped\"`, `\"pinned\"`, `\"sliding\"`, `\"free\"`"),
             "what holds the left and the right end"}
             .or_else("`[\"clamped\", \"free\"]`"),
         beam.ends, kBeamEnds, Beam{}.ends);
  v.number(Key{"tension", "N", kAny,
               "constant along the beam; negative: compression, less than "
               "that at which it buckles"}
               .or_else("none"),
           beam.tension);
  v.count({"modes", "", kModeCount, "N"}, beam.modes);
  v.choice(Key{"discretisation", "", kAny, "how the load is projected onto the modes"}.or_else(),
           beam.discretisation, kProjections);
  v.list(Key{"points", "m", kAny.told("N rising numbers in (0, L]"),
             "collocation points; used by the collocation projection and the collocation impulse, "
             "else ignored"}
             .or_else("i L/N, i = 1..N"),
         beam.points);
  v.tables({"piece"}, beam.pieces);
  describe_places(v, beam);
}

void describe_line_ends(auto& v, auto& span, const char* fallback,
                        const std::array<Hold, 2>& usual) {
  v.ends(Key{"ends", "", own_rule("two of `\"fixed\"`, `\"free\"`"),
             "what holds the left and the right end"}
             .or_else(fallback),
         span.ends, kLineEnds, usual);
}

void describe(auto& v, Of<TautString> auto& string, const Scene&) {
  v.number({"length", "m", kPositive, "L"}, string.length);
  v.list(
      Key{"frequencies", "rad/s", kNotNegative.told("N numbers >= 0"),
          "measured ones, w_j, in place of those that a tension gives; the shapes stay what they "
          "are. Not with supports or masses"}
          .or_else("those of the tension"),
      string.frequencies);
  v.number(Key{"tension", "N", kPositive, "T"}
               .needed("required without `frequencies`")
               .where(string.frequencies.empty(), "the frequencies are given, it must be left out"),
           string.tension);
  v.number({"mass_per_length", "kg/m", kPositive, "m"}, string.mass_per_length);
  describe_line_ends(v, string, "`[\"fixed\", \"fixed\"]`", TautString{}.ends);
  v.count({"modes", "", kModeCount, "N"}, string.modes);
  describe_places(v, string);
}

void describe(auto& v, Of<Bar> auto& bar, const Scene&) {
  v.number({"length", "m", kPositive, "L"}, bar.length);
  v.number({"youngs_modulus", "Pa", kPositive, "E"}, bar.youngs_modulus);
  v.number({"density", "kg/m^3", kPositive, "rho"}, bar.density);
  v.number(Key{"area", "m^2", kPositive, "A"}
               .needed("required without `section`")
               .where(!bar.section, "it follows from the section, it must be left out"),
           bar.area);
  v.table({"section", Form::kInline}, bar.section);
  describe_line_ends(v, bar, "`[\"fixed\", \"free\"]`", Bar{}.ends);
  v.count({"modes", "", kModeCount, "N"}, bar.modes);
  v.tables({"piece"}, bar.pieces);
  describe_places(v, bar);
}

void describe(auto& v, Of<ModalStructure> auto& modal, const Scene& scene) {
  v.list({"frequencies", "rad/s", kNotNegative, "w_j; 0 is a free mass"}, modal.frequencies);
  v.list(Key{"damping_ratios", "", kNotNegative,
             "delta_j/w_j, so the decay rate is ratio times w_j; 1 is critical"}
             .or_else("no damping"),
         modal.damping_ratios);
  // Mass-normalised coordinates q are in kg^1/2 m, so modal forces are in kg^1/2 m/s^2.
  v.list(of_load(Key{"participation", "kg^1/2 m/s^2", kAny,
                     "modal force per unit of `forcing.amplitude`"}
                     .or_else("needed by forcing `\"modal\"`"),
                 scene,
                 "forcing moves the base and not by these: forcing.kind must be \"modal\", or it "
                 "must be left out"),
         modal.participation);
  v.list(Key{"inertia", "kg^1/2", kAny, "modal force per unit of uniform acceleration"}.or_else(
             "needed by forcing `\"base\"` and by `[gravity]`"),
         modal.inertia);
}

}  // namespace graze
