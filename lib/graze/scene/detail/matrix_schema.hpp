// The keys of a structure of matrices (schema.hpp), and of places on it.
#pragma once

#include "graze/scene/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// A key of a load on the structure, which acts where the forcing is of the kind "modal" or "load".
// In a scene made in code it may stand beside another forcing.
inline Key of_load(const Key& key, const Scene& scene, const char* refusal) {
  return key
      .where(scene.forcing && scene.forcing->kind == ForcingKind::kModal,
             scene.forcing ? refusal : "there is no [forcing] that it is for, it must be left out")
      .or_ignored();
}

void describe(auto& v, Of<MatrixStructure> auto& matrices, const Scene& scene) {
  const auto file_of = [&](const char* name, const char* meaning, const char* fallback) {
    return Key{name, "", own_rule("a file"), meaning}.or_else(fallback);
  };
  const auto file = [&](const char* name, const char* meaning, const char* fallback, auto& value) {
    v.path(file_of(name, meaning, fallback), value);
  };
  const char* based =
      "forcing moves the base and not this load: forcing.kind must be \"load\", or it must be left "
      "out";
  v.path({"mass", "", own_rule("a file"), "M; formats in [matrices.md](matrices.md)"},
         matrices.mass);
  v.path({"stiffness", "", own_rule("a file"), "K"}, matrices.stiffness);
  file("damping", "C, in place of `[damping]`", "none", matrices.damping);
  file("dofs", "names of the rows, where the matrices have none", "1, 2, ..", matrices.dofs);
  file("coordinates",
       "nodes with x, y, z, for pictures; an input file of CalculiX or Abaqus also tells elements "
       "and sets of nodes",
       "none", matrices.coordinates);
  v.count({"modes", "", kModeCount, "N, the lowest ones"}, matrices.modes);
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

// Describes the node keys of a stop or a probe.
void describe_node(auto& v, auto& place, bool matrices) {
  const char* none = "nodes are those of [matrices], it must be left out";
  v.label(Key{"node", "", own_rule("node.direction or a number"), "the degree of freedom there"}
              .needed("required with `[matrices]`")
              .where(matrices, none),
          place.node);
  v.label(Key{"against", "", own_rule("node.direction or a number"),
              "another one: the displacement is that relative to it"}
              .or_else("none")
              .where(matrices, none),
          place.against);
}

}  // namespace graze
