#include "graze/structure/detail/line_mesh.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <cmath>
#include <limits>

namespace graze {
namespace {

using Eigen::Index;

// Exact up to degree 59: mass times the square of a field of degree 24 has at most 52.
constexpr int kPoints = 30;
using Rule = boost::math::quadrature::gauss<double, kPoints>;

struct Quadrature {
  Vector points{Vector(kPoints)}, weights{Vector(kPoints)};
};

const Quadrature& quadrature() {
  static const Quadrature rule = [] {
    Quadrature made;
    Index k = 0;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0}) {
        made.points[k] = side * Rule::abscissa()[i];
        made.weights[k++] = Rule::weights()[i];
      }
    return made;
  }();
  return rule;
}

// P_0 .. P_{count-1}
Vector legendre(double s, Index count) {
  Vector p(std::max<Index>(count, 2));
  p[0] = 1.0;
  p[1] = s;
  for (Index n = 1; n + 1 < count; ++n)
    p[n + 1] =
        ((2.0 * static_cast<double>(n) + 1.0) * s * p[n] - static_cast<double>(n) * p[n - 1]) /
        (static_cast<double>(n) + 1.0);
  return p;
}

// P_n at s, integrated from -1 `times` times.
Vector integrals(double s, Index functions, int times) {
  const Vector p = legendre(s, functions + 2);
  if (times == 0) return p.head(functions);
  Vector once(functions);
  const auto single = [&](Index n) {
    return n == 0 ? s + 1.0 : (p[n + 1] - p[n - 1]) / (2.0 * static_cast<double>(n) + 1.0);
  };
  for (Index n = 0; n < functions; ++n) {
    if (times == 1)
      once[n] = single(n);
    else if (n == 0)
      once[n] = 0.5 * (s + 1.0) * (s + 1.0);
    else
      once[n] = ((p[n + 2] - p[n]) / (2.0 * static_cast<double>(n) + 3.0) - single(n - 1)) /
                (2.0 * static_cast<double>(n) + 1.0);
  }
  return once;
}

double ratio_of(double a, double b) { return std::max(a, b) / std::min(a, b); }

double number_at(const Quartic& polynomial, const LinePiece& piece, double x) {
  return value_at(polynomial,
                  Rated{(x - piece.start.value) / (piece.end.value - piece.start.value)})
      .value;
}

// Where the stiffness of a taper has gone half the way, in its logarithm.
double middle_of_taper(const LinePiece& piece, double low, double high) {
  const double from = number_at(piece.stiffness, piece, low);
  const double wanted = std::sqrt(from) * std::sqrt(number_at(piece.stiffness, piece, high));
  double a = low, b = high;
  for (int pass = 0; pass < 40; ++pass) {
    const double middle = 0.5 * (a + b);
    const bool before = (number_at(piece.stiffness, piece, middle) < wanted) == (from < wanted);
    (before ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

// Parts [low, high] until the stiffness changes on none by more than the fourth power of 3, so that
// a wedge is at most three times as thick at one end of an element as at the other: its vertex, at
// which the solution is singular, then lies at least half an element away.
void grade_taper(const LinePiece& piece, int order, double low, double high,
                 std::vector<double>& ends) {
  const double most = order == 2 ? 81.0 : 9.0;
  if (ratio_of(number_at(piece.stiffness, piece, low), number_at(piece.stiffness, piece, high)) >
      most) {
    const double middle = middle_of_taper(piece, low, high);
    grade_taper(piece, order, low, middle, ends);
    grade_taper(piece, order, middle, high, ends);
    return;
  }
  ends.push_back(high);
}

// Tension bends a beam within about sqrt(EI/T) of where it is held. Layers of 25 of these lengths:
// what is left of e^-x beyond is 1e-11.
void part_layers(const Line& line, const LinePiece& piece, double low, double high,
                 std::vector<double>& ends) {
  const double stiffness = number_at(piece.stiffness, piece, 0.5 * (low + high));
  const double layer = line.order == 2 && line.tension.value > 0.0
                           ? 25.0 * std::sqrt(stiffness / line.tension.value)
                           : high - low;
  if (2.5 * layer < high - low) {
    ends.push_back(low + layer);
    ends.push_back(high - layer);
  }
}

// Half waves of a wave of unit frequency between two places, up to a factor.
double phase(const Line& line, const LinePiece& piece, double low, double high) {
  double sum = 0.0;
  for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double x = low + t * (high - low);
    const double ratio = number_at(piece.mass, piece, x) / number_at(piece.stiffness, piece, x);
    sum += 0.2 * std::pow(ratio, line.order == 2 ? 0.25 : 0.5);
  }
  return sum * (high - low);
}

// Ends of pieces, supports, springs and masses, rising, each once.
std::vector<Rated> breaks_of(const Line& line, bool& torn) {
  std::vector<Rated> all{{0.0, 0.0}};
  for (const LinePiece& piece : line.pieces) all.push_back(piece.end);
  for (const LineSupport& support : line.supports) all.push_back(support.x);
  for (const LineSpring& spring : line.springs) all.push_back(spring.x);
  for (const LineMass& mass : line.masses) all.push_back(mass.x);
  std::stable_sort(all.begin(), all.end(), [](Rated a, Rated b) { return a.value < b.value; });
  const double same = 8.0 * std::numeric_limits<double>::epsilon() * line.length.value;
  std::vector<Rated> breaks;
  for (const Rated& x : all) {
    if (breaks.empty() || x.value - breaks.back().value > same) {
      breaks.push_back(x);
      continue;
    }
    torn = torn || x.rate != breaks.back().rate;
  }
  return breaks;
}

}  // namespace

LineMesh::LineMesh(const Line& line, const Fineness& fineness)
    : order_(line.order), functions_(fineness.functions), fineness_(fineness) {
  place_elements(line, fineness);
  const Vector& points = quadrature().points;
  strains_.resize(kPoints, functions_);
  once_ = twice_ = strains_;
  for (Index g = 0; g < kPoints; ++g) {
    strains_.row(g) = integrals(points[g], functions_, 0).transpose();
    once_.row(g) = integrals(points[g], functions_, 1).transpose();
    twice_.row(g) = integrals(points[g], functions_, 2).transpose();
  }
}

void LineMesh::place_elements(const Line& line, const Fineness& fineness) {
  struct Part {
    Rated start, end;
    std::size_t piece;
    double phase;
  };
  std::vector<Part> parts;
  double whole = 0.0;
  const std::vector<Rated> breaks = breaks_of(line, torn_);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const Rated from = breaks[k], to = breaks[k + 1];
    const double middle = 0.5 * (from.value + to.value);
    std::size_t piece = 0;
    while (piece + 1 < line.pieces.size() && line.pieces[piece].end.value < middle) ++piece;
    std::vector<double> ends;
    grade_taper(line.pieces[piece], order_, from.value, to.value, ends);
    part_layers(line, line.pieces[piece], from.value, to.value, ends);
    std::sort(ends.begin(), ends.end());
    // Places between two breaks stay at their fraction of the way.
    Rated start = from;
    for (const double x : ends) {
      const double part = (x - from.value) / (to.value - from.value);
      const Rated end = x == to.value ? to : from + part * (to - from);
      if (!(end.value > start.value)) continue;
      parts.push_back({start, end, piece, phase(line, line.pieces[piece], start.value, end.value)});
      whole += parts.back().phase;
      start = end;
    }
  }
  for (const Part& part : parts) {
    const double half_waves = (fineness.modes + 1) * part.phase / whole;
    const int count = std::max(1, static_cast<int>(std::ceil(half_waves / fineness.half_waves)))
                      << fineness.halvings;
    Rated start = part.start;
    for (int i = 1; i <= count; ++i) {
      const Rated end =
          i == count ? part.end : part.start + (double(i) / count) * (part.end - part.start);
      elements_.push_back({start, end, part.piece});
      start = end;
    }
  }
}

Index LineMesh::unknowns() const { return first(elements_.size()); }

Index LineMesh::first(std::size_t element) const {
  return order_ + static_cast<Index>(element) * functions_;
}

std::size_t LineMesh::node(double x) const {
  const std::size_t element = element_at(x);
  const LineElement& at = elements_[element];
  return x - at.start.value < at.end.value - x ? element : element + 1;
}

std::size_t LineMesh::element_at(double x) const {
  std::size_t low = 0, high = elements_.size();
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (elements_[middle].start.value < x ? low : high) = middle;
  }
  return low;
}

RatedRows LineMesh::at_nodes(int derivative, bool rates) const {
  const auto nodes = static_cast<Index>(elements_.size()) + 1;
  const Index n = unknowns();
  Matrix value = Matrix::Zero(nodes, n), slope = value;
  Matrix value_rate = rates ? value : Matrix(), slope_rate = value_rate;
  value(0, 0) = 1.0;
  if (order_ == 2) slope(0, 1) = 1.0;
  for (Index e = 0; e + 1 < nodes; ++e) {
    const LineElement& element = elements_[static_cast<std::size_t>(e)];
    const Rated h = element.end - element.start;
    const Index c = first(static_cast<std::size_t>(e));
    value.row(e + 1) = value.row(e);
    if (rates) value_rate.row(e + 1) = value_rate.row(e);
    if (order_ == 1) {
      value(e + 1, c) += h.value;
      if (rates) value_rate(e + 1, c) += h.rate;
      continue;
    }
    value.row(e + 1) += h.value * slope.row(e);
    slope.row(e + 1) = slope.row(e);
    slope(e + 1, c) += h.value;
    value(e + 1, c) += 0.5 * h.value * h.value;
    value(e + 1, c + 1) -= h.value * h.value / 6.0;
    if (!rates) continue;
    value_rate.row(e + 1) += h.rate * slope.row(e) + h.value * slope_rate.row(e);
    slope_rate.row(e + 1) = slope_rate.row(e);
    slope_rate(e + 1, c) += h.rate;
    value_rate(e + 1, c) += h.value * h.rate;
    value_rate(e + 1, c + 1) -= h.value * h.rate / 3.0;
  }
  return derivative == 0 ? RatedRows{value, value_rate} : RatedRows{slope, slope_rate};
}

RatedRows LineMesh::values_at_nodes(bool rates) const { return at_nodes(0, rates); }
RatedRows LineMesh::slopes_at_nodes(bool rates) const { return at_nodes(1, rates); }
RatedRows LineMesh::values_inside(bool rates) const { return inside(0, rates); }
RatedRows LineMesh::slopes_inside(bool rates) const { return inside(1, rates); }

RatedRows LineMesh::inside(int derivative, bool rates) const {
  const auto count = static_cast<Index>(elements_.size());
  const RatedRows start = at_nodes(derivative, rates);
  const RatedRows slope = order_ == 2 && derivative == 0 ? at_nodes(1, rates) : RatedRows{};
  const Vector way = quadrature().points.array() + 1.0;
  RatedRows rows{Matrix(count * kPoints, unknowns()), {}};
  if (rates) rows.rate.resizeLike(rows.value);
  for (Index e = 0; e < count; ++e) {
    const LineElement& element = elements_[static_cast<std::size_t>(e)];
    const Rated half = 0.5 * (element.end - element.start);
    auto value = rows.value.middleRows(e * kPoints, kPoints);
    const Index c = first(static_cast<std::size_t>(e));
    const bool twice = order_ - derivative == 2;
    value.rowwise() = start.value.row(e);
    if (twice) value.noalias() += half.value * way * slope.value.row(e);
    const Matrix& own = twice ? twice_ : once_;
    const Rated factor = twice ? half * half : half;
    value.middleCols(c, functions_) += factor.value * own;
    if (!rates) continue;
    auto rate = rows.rate.middleRows(e * kPoints, kPoints);
    rate.rowwise() = start.rate.row(e);
    if (twice) rate += way * (half.rate * slope.value.row(e) + half.value * slope.rate.row(e));
    rate.middleCols(c, functions_) += factor.rate * own;
  }
  return rows;
}

LineMesh::Weights LineMesh::weights(const Line& line) const {
  const Index n = static_cast<Index>(elements_.size()) * kPoints;
  Weights all{Vector(n), Vector(n), Vector(n), Vector(n), Vector(n), Vector(n)};
  const Quadrature& rule = quadrature();
  Index k = 0;
  for (const LineElement& element : elements_) {
    const LinePiece& piece = line.pieces[element.piece];
    const Rated half = 0.5 * (element.end - element.start), reach = piece.end - piece.start;
    for (Index g = 0; g < kPoints; ++g, ++k) {
      const Rated length = rule.weights[g] * half;
      const Rated x = (element.start + (rule.points[g] + 1.0) * half - piece.start) / reach;
      const Rated stiffness = length * value_at(piece.stiffness, x);
      const Rated mass = length * value_at(piece.mass, x);
      all.stiffness[k] = stiffness.value;
      all.mass[k] = mass.value;
      all.length[k] = length.value;
      all.stiffness_rate[k] = stiffness.rate;
      all.mass_rate[k] = mass.rate;
      all.length_rate[k] = length.rate;
    }
  }
  return all;
}

Vector LineMesh::row_in(std::size_t element, double s, int derivative) const {
  const LineElement& at = elements_[element];
  const double half = 0.5 * (at.end.value - at.start.value);
  const int times = order_ - derivative;
  assert(times >= 0);
  Vector row = Vector::Zero(unknowns());
  if (times > 0) row = at_nodes(derivative, false).value.row(static_cast<Index>(element));
  if (times == 2)
    row += half * (s + 1.0) * at_nodes(1, false).value.row(static_cast<Index>(element)).transpose();
  row.segment(first(element), functions_) +=
      std::pow(half, times) * integrals(s, functions_, times);
  return row;
}

namespace {

double local(const LineElement& element, double x) {
  const double length = element.end.value - element.start.value;
  return std::clamp(2.0 * (x - element.start.value) / length - 1.0, -1.0, 1.0);
}

}  // namespace

Vector LineMesh::row(double x, int derivative) const {
  const std::size_t element = element_at(x);
  return row_in(element, local(elements_[element], x), derivative);
}

Vector LineMesh::row_rate(double x, double x_rate) const {
  const std::size_t element = element_at(x);
  const LineElement& at = elements_[element];
  const double s = local(at, x);
  const Rated half = 0.5 * (at.end - at.start);
  const auto e = static_cast<Index>(element);
  const int times = order_;
  Vector rate = at_nodes(0, true).rate.row(e);
  if (times == 2) {
    const RatedRows slope = at_nodes(1, true);
    rate +=
        (s + 1.0) * (half.rate * slope.value.row(e) + half.value * slope.rate.row(e)).transpose();
  }
  const Rated factor = times == 2 ? half * half : half;
  rate.segment(first(element), functions_) += factor.rate * integrals(s, functions_, times);
  // The place moves within its element.
  return rate + (x_rate - at.start.rate - (s + 1.0) * half.rate) * row_in(element, s, 1);
}

}  // namespace graze
