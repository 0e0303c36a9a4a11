// The keys of discrete structures (schema.hpp), matrices or masses and springs, and of points of
// any structure.
#pragma once

#include "graze/scene/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

inline constexpr const char* kSpringEnds = "a list of two masses by their numbers or names";

// A key of a load on the structure, which acts where the forcing is of the kind "modal" or "load".
// In a scene made in code it may stand beside another forcing.
inline Key of_load(const Key& key, const Scene& scene, const char* refusal) {
  return key
      .where(scene.has_load(ForcingKind::kModal),
             scene.forcing ? refusal : "there is no [forcing] that it is for, it must be left out")
      .or_ignored();
}

void describe(auto& v, Of<MatrixStructure> auto& matrices, const Scene& scene) {
  const auto file_of = [&](const char* name, const char* meaning, const char* fallback) {
    return Key{name, "", own_rule("a file"), meaning}.or_else(fallback);
  };
  const auto file = [&](const char* name, const char* meaning, const char* fallback, auto& value) {
    v.path(file_of(name, meaning, fallback)
               .where(matrices.mass_entries.empty(),
                      "it goes with matrices in files, and these stand in the scene; it must be "
                      "left out"),
           value);
  };
  const char* based =
      "forcing moves the base and not this load: forcing.kind must be \"load\", or it must be left "
      "out";
  const Range matrix = own_rule("rows of numbers, or a file");
  v.entries({"mass", "kg", matrix,
             "M, `[[m11, m12, ..], [m21, ..], ..]`, or a file, formats in "
             "[matrices.md](matrices.md)"},
            matrices.mass, matrices.mass_entries);
  v.entries({"stiffness", "N/m", matrix, "K"}, matrices.stiffness, matrices.stiffness_entries);
  v.entries(
      Key{"damping", "N s/m", matrix, "C, in place of `[damping]`"}.or_else("none").of_any_matrix(),
      matrices.damping, matrices.damping_entries);
  file("dofs", "names of the rows, where the matrices have none", "1, 2, ..", matrices.dofs);
  file("coordinates",
       "nodes with x, y, z, for pictures; an input file of CalculiX or Abaqus also tells elements "
       "and sets of nodes",
       "none", matrices.coordinates);
  const Key modes = Key{"modes", "", kModeCount, "N, the lowest ones"};
  v.count(matrices.mass_entries.empty() ? modes.needed("required with files, else all")
                                        : modes.or_else("all"),
          matrices.modes);
  const Range dofs = own_rule("degrees of freedom");
  v.labels(Key{"constraints", "", dofs, "held at zero"}.or_else("none"), matrices.constraints);
  file("constraints_file", "with one in each line", "none", matrices.constraints_file);
  v.count(Key{"direction", "", kDirection,
              "of base forcing and `[gravity]`; 0: all degrees of freedom, where these have none"}
              .or_else("0"),
          matrices.direction);
  v.labels(of_load(Key{"load", "", dofs, "where forcing of the kind `\"load\"` acts"}.or_else(
                       "needed by forcing `\"load\"`"),
                   scene, based),
           matrices.load);
  v.list(of_load(Key{"load_values", "N", own_rule("one number for each"),
                     "forces there, per unit of `forcing.amplitude`"}
                     .or_else("1 each")
                     .as("a list of numbers in N, one for each entry of load")
                     .fixed(),
                 scene, based),
         matrices.load_values);
  v.path(
      of_load(file_of("load_file", "in place of `load` and `load_values`", "none"), scene, based),
      matrices.load_file);
  v.text(Key{"checksum", "", own_rule("64 hexadecimal digits"),
             "SHA-256 of the files; written by `--out`, and compared where it is given"}
             .or_else("none"),
         matrices.checksum);
}

void describe(auto& v, Of<LumpedSpring> auto& spring, const Scene&) {
  v.labels(Key{"between", "", own_rule("two of 0 and the masses"),
               "what it connects; 0 or `\"ground\"` is the ground, or the base where that moves"}
               .as(kSpringEnds),
           spring.between);
  v.number(Key{"stiffness", "N/m", kNotNegative, "k"}.or_else(), spring.stiffness);
  v.number(Key{"damping", "N s/m", kNotNegative, "c, of a dashpot beside it"}.or_else(),
           spring.damping);
}

void describe(auto& v, Of<GyroscopicPair> auto& pair, const Scene&) {
  v.labels(Key{"between", "", own_rule("two of the masses"),
               "the planes of a disc that turns, as two masses"}
               .as(kSpringEnds),
           pair.between);
  v.number({"coefficient", "N s/m", kAny, "g: -g u2' on the first, g u1' on the second"},
           pair.coefficient);
}

void describe(auto& v, Of<LumpedStructure> auto& lumped, const Scene&) {
  v.values(Key{"masses", "kg", kPositive.told("numbers > 0"), "m_1, m_2, .."}.as(
               "a list of numbers in kg, one for each mass"),
           lumped.masses);
  v.labels(Key{"names", "", own_rule("one for each mass"),
               "by which springs, stops and the like may call them, beside their numbers from 1"}
               .or_else("none")
               .as("a list of names, one for each mass"),
           lumped.names);
  v.count(Key{"modes", "", kModeCount, "N, the lowest ones"}.or_else("all"), lumped.modes);
  v.tables({"spring"}, lumped.springs);
  v.tables({"gyroscopic"}, lumped.gyroscopic);
}

// Describes the keys of a point: `position` of a beam, a string or a bar, `shape` of given modes,
// `node` and `mass` of discrete structures. `applies`: whether there is one, else the sentence
// `otherwise` holds.
void describe_point(auto& v, auto& point, const Scene& scene, const Key& position, const Key& shape,
                    bool applies = true, const char* otherwise = nullptr) {
  const bool span = scene.span() != nullptr, matrices = scene.matrices() != nullptr;
  const bool lumped = scene.lumped() != nullptr;
  const auto where = [&](const Key& key, bool condition, const char* refusal) {
    return applies ? key.where(condition, refusal) : key.where(false, otherwise).or_ignored();
  };
  v.number(where(position.needed("required with `[beam]`, `[string]`, `[bar]`"), span,
                 matrices ? "a point of [matrices] has no position, it must have a node"
                 : lumped ? "a point of [lumped] has no position, it must have a mass"
                          : "a point of a [modal] structure has no position, it must have a shape"),
           point.position);
  // Of a discrete structure the shape follows from the node or the mass.
  const Key given =
      where(shape.needed("required with `[modal]`"), !span && !matrices && !lumped,
            matrices ? "a point of [matrices] has no shape, it must have a node"
            : lumped ? "a point of [lumped] has no shape, it must have a mass"
                     : "a point of a [beam], [string] or [bar] has no shape, it must have a "
                       "position");
  v.list(matrices || lumped ? given.or_ignored() : given, point.shape);
  v.label(
      where(Key{"node", "", own_rule("node.direction or a number"), "the degree of freedom there"}
                .needed("required with `[matrices]`"),
            matrices, "nodes are those of [matrices], it must be left out"),
      point.node);
  v.label(where(Key{"mass", "", own_rule("a mass"), "its number, or its name"}
                    .needed("required with `[lumped]`")
                    .as("a mass by its number or its name"),
                lumped, "masses are those of [lumped], it must be left out"),
          point.node);
  v.label(where(Key{"against", "", own_rule("as `node` or `mass`"),
                    "another one: the displacement is that relative to it"}
                    .or_else("none"),
                matrices || lumped,
                "it is a node of [matrices] or a mass of [lumped], it must be left out"),
          point.against);
}

}  // namespace graze
