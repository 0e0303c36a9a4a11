// The degrees of freedom of matrices that the texts of a scene name. `key`: that of the text, for
// messages; all throw InputError.
#pragma once

#include <string>
#include <vector>

#include "graze/fem/dof_label.hpp"
#include "graze/fem/mesh_file.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// One, or one at each node of a set of the mesh, "TIP.3".
std::vector<DofLabel> labels_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                                const std::string& text);
DofLabel label_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                  const std::string& text);

// Those that are held.
std::vector<DofLabel> constraints_of(const Scene& scene, const MatrixStructure& matrices,
                                     const Mesh& mesh);

// A hint for messages: CalculiX writes no row of a held degree of freedom, nor its mass.
const char* left_out(const Scene& scene);

}  // namespace graze
