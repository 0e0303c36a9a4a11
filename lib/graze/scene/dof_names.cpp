#include "graze/scene/detail/dof_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/fem/detail/text_lines.hpp"
#include "graze/fem/matrix_file.hpp"
#include "graze/scene/detail/keys.hpp"

namespace graze {
namespace {

constexpr const char* kForm = "node.direction, or a number like \"7\"";

}  // namespace

std::vector<DofLabel> labels_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                                const std::string& text) {
  if (const std::optional<DofLabel> label = label_from_text(text)) return {*label};
  const std::size_t dot = std::min(text.rfind('.'), text.size());
  const auto set = mesh.sets.find(in_capitals(text.substr(0, dot)));
  if (set == mesh.sets.end())
    throw scene_error(
        scene, key,
        fmt::format("\"{}\" is not allowed, it must be {}, or in place of the node a set of nodes "
                    "(*NSET) in the file of coordinates",
                    text, kForm));
  // As the direction of a node of the set is read.
  const std::optional<DofLabel> direction = label_from_text("1" + text.substr(dot));
  if (!direction || direction->direction == 0)
    throw scene_error(
        scene, key,
        fmt::format("\"{}\" names a set of nodes without a direction there, it must be "
                    "like \"{}.3\"",
                    text, text.substr(0, dot)));
  std::vector<DofLabel> labels;
  for (const long node : set->second)
    labels.push_back({node, direction->direction, direction->row});
  return labels;
}

DofLabel label_of(const Scene& scene, const Mesh& mesh, const std::string& key,
                  const std::string& text) {
  const std::vector<DofLabel> labels = labels_of(scene, mesh, key, text);
  if (labels.size() == 1) return labels.front();
  throw scene_error(scene, key,
                    fmt::format("\"{}\" is not allowed, the set has {} nodes, it must have one",
                                text, labels.size()));
}

std::vector<DofLabel> constraints_of(const Scene& scene, const MatrixStructure& matrices,
                                     const Mesh& mesh) {
  std::vector<DofLabel> held;
  for (const std::string& text : matrices.constraints)
    for (const DofLabel& label : labels_of(scene, mesh, "matrices.constraints", text))
      held.push_back(label);
  if (!matrices.constraints_file.empty())
    for (const DofLabel& label : read_dof_names(matrices.constraints_file)) held.push_back(label);
  return held;
}

const char* left_out(const Scene& scene) {
  return scene.matrices()->dofs.empty() ? ""
                                        : "; CalculiX leaves out what *BOUNDARY holds: written "
                                          "without it, all are there and can "
                                          "be held by constraints_file";
}

}  // namespace graze
