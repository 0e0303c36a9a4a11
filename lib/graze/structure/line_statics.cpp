#include "graze/structure/detail/line_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/products.hpp"
#include "graze/structure/detail/line_coordinates.hpp"
#include "graze/structure/detail/line_forms.hpp"
#include "graze/structure/detail/moving_supports.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Whether elements meet at x without the loads.
bool is_node(const Line& line, double x) {
  const auto meets = [&](const Rated& at) {
    return std::abs(at.value - x) <=
           8.0 * std::numeric_limits<double>::epsilon() * line.length.value;
  };
  const auto any_at = [&](const auto& list, auto place) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& one) { return meets(one.*place); });
  };
  return meets({}) || any_at(line.pieces, &LinePiece::end) ||
         any_at(line.supports, &LineSupport::x) || any_at(line.springs, &LineSpring::x) ||
         any_at(line.masses, &LineMass::x);
}

// A load at a place is exact where elements meet there; a mass of 0 makes them. The strain of a bar
// jumps at its load, so that a load cannot move away from a node; that of a beam only has a kink,
// and what a node that stays behind misses of it is of the third order in the distance.
Line meeting_at(Line line, const std::vector<Rated>& places) {
  for (const Rated& x : places)
    if (line.order == 1 || !is_node(line, x.value)) line.masses.push_back({x, {}, {}});
  return line;
}

// Rate of the row of a place, which moves with its node or away from it.
Eigen::RowVectorXd moving_row(const LineMesh& mesh, const RatedRows& nodes, const Rated& place) {
  if (mesh.order() == 2) return mesh.row_rate(place.value, place.rate).transpose();
  return nodes.rate.row(static_cast<Index>(mesh.node(place.value)));
}

// Rows that the loads work on, one a load.
RatedRows load_rows(const Line& line, const LineMesh& mesh, const std::vector<Rated>& places,
                    bool rates) {
  const auto count = static_cast<Index>(places.size());
  const RatedRows nodes = mesh.values_at_nodes(rates), inside = mesh.values_inside(rates);
  const LineMesh::Weights weights = mesh.weights(line);
  RatedRows rows{Matrix(count + 1, mesh.unknowns()), {}};
  if (rates) rows.rate.resizeLike(rows.value);
  for (Index i = 0; i < count; ++i) {
    const auto node = static_cast<Index>(mesh.node(places[static_cast<std::size_t>(i)].value));
    rows.value.row(i) = nodes.value.row(node);
    if (rates) rows.rate.row(i) = moving_row(mesh, nodes, places[static_cast<std::size_t>(i)]);
  }
  rows.value.row(count) = weights.mass.transpose() * inside.value;
  if (rates)
    rows.rate.row(count) =
        weights.mass_rate.transpose() * inside.value + weights.mass.transpose() * inside.rate;
  for (const LineMass& point : line.masses) {
    const auto node = static_cast<Index>(mesh.node(point.x.value));
    rows.value.row(count) += point.mass.value * nodes.value.row(node);
    if (rates)
      rows.rate.row(count) +=
          point.mass.rate * nodes.value.row(node) + point.mass.value * nodes.rate.row(node);
  }
  return rows;
}

// Rates of the rigid motions: a rotation about a held place moves with that place. Rates within the
// rigid motions themselves are left out.
RigidMotions rigid_rates(const Line& line, const RigidMotions& rigid) {
  RigidMotions rates = RigidMotions::Zero(rigid.rows(), rigid.cols());
  if (line.order != 2) return rates;
  const auto follow = [&](const Rated& x) { rates.row(0) = -x.rate * rigid.row(1); };
  for (const LineSpring& spring : line.springs)
    if (!spring.on_slope) follow(spring.x);
  for (const LineSupport& support : line.supports)
    if (support.holds_value) follow(support.x);
  return rates;
}

// With K y + C^T l + D^T m = f, C y = 0 of the supports and D y = 0 of the rigid motions B,
// D = B^T M, m = B^T f:
//
//   (f_i.y_k)' = f_i'.y_k + y_i.f_k' - y_i.K' y_k - (l_i.C' y_k + m_i.D' y_k) - (the same of k, i).
Matrix rate_of(const Line& line, const LineCoordinates& coordinates, const RatedRows& loads,
               const Matrix& y) {
  const LineMesh& mesh = coordinates.mesh();
  const LineForm kinetic = kinetic_form(line, mesh, true);
  const ElasticForm elastic(line, mesh);
  const RigidMotions& rigid = coordinates.rigid();
  Matrix b = Matrix::Zero(mesh.unknowns(), rigid.cols()), b_rate = b;
  b.topRows(line.order) = rigid;
  b_rate.topRows(line.order) = rigid_rates(line, rigid);
  const Matrix held_by_inertia = b.transpose() * loads.value.transpose();
  Matrix half = product<double>(loads.rate, y);
  half -= transposed_product<double>(
      held_by_inertia,
      transposed_product<double>(b_rate, kinetic.times(y)) + kinetic.rate_between(b, y));
  const MovingSupports supports(line, mesh);
  if (supports.any_moves()) {
    const Matrix borne = loads.value.transpose() - elastic.times(y) -
                         product<double>(kinetic.times(b), held_by_inertia);
    half -= transposed_product<double>(supports.reactions(borne), supports.moved(y));
  }
  return half + half.transpose() - elastic.rate_between(y, y);
}

}  // namespace

LineStatics line_statics(const Line& line, const std::vector<Rated>& places, bool rates) {
  // A field of degree 24 is as fine as the modes are; a tapered beam bends as smoothly.
  constexpr int kDegree = 24, kModes = 8;
  const Line met = meeting_at(line, places);
  const LineCoordinates coordinates(met, {kDegree - line.order + 1, kModes});
  LineStatics found;
  found.is_torn = coordinates.mesh().is_torn();
  const bool rated = rates && !found.is_torn;
  const RatedRows loads = load_rows(met, coordinates.mesh(), places, rated);
  const Matrix x = coordinates.rows(loads.value).transpose();
  found.displacement = transposed_product<double>(x, x);
  if (rated) found.rate = rate_of(met, coordinates, loads, coordinates.unknowns(x));
  return found;
}

}  // namespace graze
