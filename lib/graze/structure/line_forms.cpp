#include "graze/structure/detail/line_forms.hpp"

#include "graze/base/linalg/detail/products.hpp"

namespace graze {
namespace {

using Eigen::Index;

// Adds a row on the field's value or slope at a node.
struct NodeRows {
  RatedRows values, slopes;
  LineForm& form;
  bool rates;
  Index next;

  void add(std::size_t node, bool on_slope, Rated weight) {
    const RatedRows& from = on_slope ? slopes : values;
    const auto k = static_cast<Index>(node);
    form.rows.value.row(next) = from.value.row(k);
    if (rates) form.rows.rate.row(next) = from.rate.row(k);
    form.weight[next] = weight.value;
    form.weight_rate[next++] = weight.rate;
  }
};

NodeRows more_rows(LineForm& form, const LineMesh& mesh, Index inside, Index count, bool rates) {
  form.rows.value.conservativeResize(inside + count, mesh.unknowns());
  if (rates) form.rows.rate.conservativeResize(inside + count, mesh.unknowns());
  form.weight.conservativeResize(inside + count);
  form.weight_rate.conservativeResize(inside + count);
  return {mesh.values_at_nodes(rates),
          mesh.order() == 2 ? mesh.slopes_at_nodes(rates) : RatedRows{}, form, rates, inside};
}

}  // namespace

Matrix LineForm::factor() const { return weight.cwiseSqrt().asDiagonal() * rows.value; }

Matrix LineForm::between(const Matrix& modes, const Matrix& others) const {
  return transposed_product<double>(product<double>(rows.value, modes),
                                    weight.asDiagonal() * product<double>(rows.value, others));
}

Matrix LineForm::rate_between(const Matrix& modes, const Matrix& others) const {
  const Matrix left = product<double>(rows.value, modes),
               right = product<double>(rows.value, others);
  Matrix rate = transposed_product<double>(left, weight_rate.asDiagonal() * right);
  if (rows.rate.isZero(0.0)) return rate;
  rate +=
      transposed_product<double>(product<double>(rows.rate, modes), weight.asDiagonal() * right);
  rate +=
      transposed_product<double>(left, weight.asDiagonal() * product<double>(rows.rate, others));
  return rate;
}

Matrix LineForm::times(const Matrix& modes) const {
  return transposed_product<double>(rows.value,
                                    weight.asDiagonal() * product<double>(rows.value, modes));
}

LineForm kinetic_form(const Line& line, const LineMesh& mesh, bool rates) {
  const LineMesh::Weights weights = mesh.weights(line);
  LineForm form{mesh.values_inside(rates), weights.mass, weights.mass_rate};
  const bool turns = line.order == 2;
  const auto points = static_cast<Index>(line.masses.size());
  if (points == 0) return form;
  NodeRows more = more_rows(form, mesh, form.weight.size(), turns ? 2 * points : points, rates);
  for (const LineMass& point : line.masses) {
    const std::size_t node = mesh.node(point.x.value);
    more.add(node, false, point.mass);
    if (turns) more.add(node, true, point.inertia);
  }
  return form;
}

LineForm tension_form(const Line& line, const LineMesh& mesh, bool rates) {
  const LineMesh::Weights weights = mesh.weights(line);
  return {mesh.slopes_inside(rates), weights.length, weights.length_rate};
}

namespace {

LineForm spring_form(const Line& line, const LineMesh& mesh) {
  LineForm form;
  NodeRows more = more_rows(form, mesh, 0, static_cast<Index>(line.springs.size()), true);
  for (const LineSpring& spring : line.springs)
    more.add(mesh.node(spring.x.value), spring.on_slope, spring.stiffness);
  return form;
}

// Calls f(first unknown, matrix of the stiffness) of every element.
void for_each_element(const LineMesh& mesh, const Vector& weight, const auto& f) {
  const Matrix& strains = mesh.strains();
  for (std::size_t e = 0; e < mesh.elements().size(); ++e) {
    const auto here = weight.segment(static_cast<Index>(e) * strains.rows(), strains.rows());
    const Matrix matrix = transposed_product<double>(here.asDiagonal() * strains, strains);
    f(mesh.first(e), matrix);
  }
}

// The rows of the strain depend on no length; only its products are formed.
Matrix strain_form_times(const Line& line, const LineMesh& mesh, const Matrix& modes) {
  Matrix all = Matrix::Zero(modes.rows(), modes.cols());
  for_each_element(mesh, mesh.weights(line).stiffness, [&](Index first, const Matrix& matrix) {
    all.middleRows(first, matrix.rows()) =
        product<double>(matrix, modes.middleRows(first, matrix.rows()));
  });
  return all;
}

Matrix strain_form_rate(const Line& line, const LineMesh& mesh, const Matrix& modes,
                        const Matrix& others) {
  Matrix sum = Matrix::Zero(modes.cols(), others.cols());
  for_each_element(mesh, mesh.weights(line).stiffness_rate, [&](Index first, const Matrix& matrix) {
    if (matrix.isZero(0.0)) return;
    sum += transposed_product<double>(
        modes.middleRows(first, matrix.rows()),
        product<double>(matrix, others.middleRows(first, matrix.rows())));
  });
  return sum;
}

}  // namespace

ElasticForm::ElasticForm(const Line& line, const LineMesh& mesh)
    : line_(line), mesh_(mesh), springs_(spring_form(line, mesh)) {
  if (line.tension.value != 0.0 || line.tension.rate != 0.0)
    tension_ = tension_form(line, mesh, true);
}

Matrix ElasticForm::times(const Matrix& modes) const {
  Matrix product = strain_form_times(line_, mesh_, modes);
  if (!line_.springs.empty()) product += springs_.times(modes);
  if (tension_) product += line_.tension.value * tension_->times(modes);
  return product;
}

Matrix ElasticForm::rate_between(const Matrix& modes, const Matrix& others) const {
  Matrix rate = strain_form_rate(line_, mesh_, modes, others);
  if (!line_.springs.empty()) rate += springs_.rate_between(modes, others);
  if (tension_)
    rate += line_.tension.value * tension_->rate_between(modes, others) +
            line_.tension.rate * tension_->between(modes, others);
  return rate;
}

}  // namespace graze
