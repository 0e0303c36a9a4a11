#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

#include "graze/structure/detail/line.hpp"
#include "graze/structure/detail/span_modes.hpp"
#include "graze/structure/modal_model.hpp"

namespace graze {
namespace {

// A field through points, linear between them and even beyond them.
struct PointField {
  const std::vector<double>&x, &u;

  std::size_t behind(double at) const {
    return static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  }
  double slope(double at) const {
    const std::size_t i = behind(at);
    return i == 0 || i == x.size() ? 0.0 : (u[i] - u[i - 1]) / (x[i] - x[i - 1]);
  }
  double value(double at) const {
    const std::size_t i = behind(at);
    return i == 0 ? u.front() : u[i - 1] + slope(at) * (at - x[i - 1]);
  }
};

}  // namespace

// Gauss' rule on panels that end at every point and every change of the section, none longer than
// half a wave of the last mode, so that 15 nodes integrate to rounding.
Vector modal_coordinates(const Scene& scene, const std::vector<double>& places,
                         const std::vector<double>& values) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const PointField field{places, values};
  const Line line = line_of(scene, nullptr);
  const SpanModes modes = span_modes(scene);
  const auto shapes = [&](double x) {
    return std::visit([x](const auto& has) { return has.shapes(x); }, modes);
  };
  Vector q = Vector::Zero(scene.modes());
  for (const LinePiece& piece : line.pieces) {
    const double start = piece.start.value, end = piece.end.value;
    std::vector<double> ends{start, end};
    for (const double x : places)
      if (x > start && x < end) ends.push_back(x);
    std::ranges::sort(ends);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const int panels =
          1 + static_cast<int>(scene.modes() * (ends[k] - ends[k - 1]) / line.length.value);
      const double half = 0.5 * (ends[k] - ends[k - 1]) / panels;
      for (int p = 0; p < panels; ++p) {
        const double middle = ends[k - 1] + (2 * p + 1) * half;
        const auto node = [&](double s, double weight) {
          const double x = middle + s * half;
          const double mass =
              value_at(piece.mass, {(x - start) / (end - start), 0.0}).value * weight * half;
          q += mass * field.value(x) * shapes(x);
        };
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
          node(Rule::abscissa()[i], Rule::weights()[i]);
          if (Rule::abscissa()[i] > 0.0) node(-Rule::abscissa()[i], Rule::weights()[i]);
        }
      }
    }
  }
  for (const LineMass& mass : line.masses) {
    q += mass.mass.value * field.value(mass.x.value) * shapes(mass.x.value);
    if (const auto* elements = std::get_if<ElementModes>(&modes))
      q += mass.inertia.value * field.slope(mass.x.value) * elements->slopes(mass.x.value);
  }
  return q;
}

}  // namespace graze
