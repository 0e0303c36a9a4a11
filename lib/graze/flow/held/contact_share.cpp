#include "graze/flow/held/detail/contact_share.hpp"

#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {

Matrix rows_of(const System& system, const std::vector<int>& stops) {
  Matrix rows(system.modes(), static_cast<Eigen::Index>(stops.size()));
  for (std::size_t a = 0; a < stops.size(); ++a)
    rows.col(static_cast<Eigen::Index>(a)) = system.row(stops[a]);
  return rows;
}

Matrix directions_of(const System& system, const std::vector<int>& stops) {
  Matrix directions(system.modes(), static_cast<Eigen::Index>(stops.size()));
  for (std::size_t a = 0; a < stops.size(); ++a)
    directions.col(static_cast<Eigen::Index>(a)) = system.direction(stops[a]);
  return directions;
}

Vector pushing_row(const System& system, int stop, const std::vector<Contact>& frictions) {
  Vector row = system.stops[static_cast<std::size_t>(stop)].row;
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    const Friction& friction = system.frictions[k];
    if (friction.stop != stop) continue;
    if (frictions[k] == Contact::kForward) row += friction.sliding * friction.row;
    if (frictions[k] == Contact::kBackward) row -= friction.sliding * friction.row;
  }
  return row;
}

Matrix contact_share(const System& system, const std::vector<int>& closed) {
  const Matrix rows = rows_of(system, closed);
  return LuFactors(rows.transpose() * directions_of(system, closed))
      .solve_columns(rows.transpose());
}

Matrix contact_share_rate(const System& system, const System& tangent,
                          const std::vector<int>& closed) {
  const Matrix rows = rows_of(system, closed), rows_rate = rows_of(tangent, closed);
  const Matrix directions = directions_of(system, closed);
  const Matrix acting_rate =
      rows_rate.transpose() * directions + rows.transpose() * directions_of(tangent, closed);
  return LuFactors(rows.transpose() * directions)
      .solve_columns(rows_rate.transpose() - acting_rate * contact_share(system, closed));
}

Matrix held_projection(const System& system, const std::vector<int>& closed) {
  const Eigen::Index n = system.modes();
  if (closed.empty()) return Matrix::Identity(n, n);
  return Matrix::Identity(n, n) - directions_of(system, closed) * contact_share(system, closed);
}

Matrix held_projection_rate(const System& system, const System& tangent,
                            const std::vector<int>& closed) {
  const Eigen::Index n = system.modes();
  if (closed.empty()) return Matrix::Zero(n, n);
  return -directions_of(tangent, closed) * contact_share(system, closed) -
         directions_of(system, closed) * contact_share_rate(system, tangent, closed);
}

}  // namespace graze
