// The keys of a structure of matrices (schema.hpp), and of places on it.
#pragma once

#include "graze/scene/detail/key.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

void describe(auto& v, Of<MatrixStructure> auto& matrices, const Scene&) {
  const auto file = [&](const char* name, const char* meaning, const char* fallback, auto& value) {
    v.path(Key{name, "", own_rule("a file"), meaning}.or_else(fallback), value);
  };
  v.path({"mass", "", own_rule("a file"), "M; formats in [matrices.md](matrices.md)"},
         matrices.mass);
  v.path({"stiffness", "", own_rule("a file"), "K"}, matrices.stiffness);
  file("damping", "C, in place of `[damping]`", "none", matrices.damping);
  file("dofs", "names of the rows, where the matrices have none", "1, 2, ..", matrices.dofs);
  file("coordinates", "nodes with x, y, z, for pictures", "none", matrices.coordinates);
  v.count({"modes", "", kModeCount, "N, the lowest ones"}, matrices.modes);
  const Range dofs = own_rule("degrees of freedom");
  v.labels(Key{"constraints", "", dofs, "held at zero"}.or_else("none"), matrices.constraints);
  file("constraints_file", "with one in each line", "none", matrices.constraints_file);
  v.count(Key{"direction", "", kDirection,
              "of base forcing and `[gravity]`; 0: all degrees of freedom, where these have none"}
              .or_else("0"),
          matrices.direction);
  v.labels(Key{"load", "", dofs, "where forcing of the kind `\"load\"` acts"}.or_else(
               "needed by forcing `\"load\"`"),
           matrices.load);
  v.list(Key{"load_values", "N", own_rule("one number for each"),
             "forces there, per unit of `forcing.amplitude`"}
             .or_else("1 each")
             .as("a list of numbers in N, one for each entry of load")
             .fixed(),
         matrices.load_values);
  file("load_file", "in place of `load` and `load_values`", "none", matrices.load_file);
  v.text(Key{"checksum", "", own_rule("64 hexadecimal digits"),
             "SHA-256 of the files; written by `--out`, and compared where it is given"}
             .or_else("none"),
         matrices.checksum);
}

// Of a stop or a probe.
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
