#include "graze/assembly/start_table.hpp"

#include <fmt/format.h>

#include "graze/assembly/initial_state.hpp"
#include "graze/scene/data_table.hpp"
#include "graze/scene/detail/text_file.hpp"
#include "graze/scene/matrix_structure.hpp"

namespace graze {

State state_in_table(const std::string& file, Scene scene, const System& system) {
  const DataTable table(read_text_file(file, "a table"), file, ColumnNames::kOptional);
  const bool of_masses = scene.discrete() != nullptr;
  const auto n = of_masses ? scene.discrete()->solved->modes.shapes.rows()
                           : static_cast<Eigen::Index>(scene.modes());
  if (static_cast<Eigen::Index>(table.columns()) != 2 * n + 1)
    throw table.error(
        fmt::format("the table has {} columns, it must have {}: time, {} displacements "
                    "and {} velocities, of the {}",
                    table.columns(), 2 * n + 1, n, n, of_masses ? "degrees of freedom" : "modes"));
  if (table.number(0, 0) != 0.0)
    throw table.cell_error(
        0, 0,
        fmt::format("{:g} is not allowed, the first row must be at t = 0", table.number(0, 0)));
  scene.initial.emplace();
  auto& at = of_masses ? scene.initial->displacement : scene.initial->q;
  auto& rate = of_masses ? scene.initial->velocity : scene.initial->qdot;
  for (std::size_t k = 1; k < table.columns(); ++k)
    (k <= static_cast<std::size_t>(n) ? at : rate).push_back(table.number(0, k));
  try {
    return initial_state(scene, system);
  } catch (const InputError& error) {
    throw table.cell_error(0, 1, fmt::format("no state of the structure: {}", error.what()));
  }
}

}  // namespace graze
