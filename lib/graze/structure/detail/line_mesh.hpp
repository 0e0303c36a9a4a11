// Elements along a line. The unknowns are not the field but its strain, u' or u'', as a series of
// Legendre polynomials P_n on every element, and the motion of the left end:
//
//   y = (u(0), [u'(0),] c_1, c_2, ..),   u^(d) = sum c_en P_n(s) on element e, -1 <= s <= 1.
//
// The field follows by integration, d times, from the left. Beside the nodal unknowns of the usual
// hierarchical elements, of which these are another basis (a nodal function is the integral of P_0
// or P_1, the functions within an element those of P_d, P_d+1, ..), nothing cancels: the elastic
// energy is a sum over the elements however short, thin or stiff they are, and a rigid motion has
// none at all, not even by rounding.
//
// Reference: B. Szabo, I. Babuska, Finite Element Analysis (Wiley 1991), chapter 3.
#pragma once

#include <vector>

#include "graze/structure/detail/line.hpp"

namespace graze {

struct LineElement {
  Rated start, end;  // m
  std::size_t piece = 0;
};

// How fine: functions of the strain on every element, and elements.
struct Fineness {
  int functions = 0;
  int modes = 0;            // that are to be resolved
  double half_waves = 5.0;  // of the highest of them, on an element
  int halvings = 0;         // of all elements
};

// Rows that give a quantity from the unknowns y, and their rates at fixed y; one column an unknown.
struct RatedRows {
  Matrix value, rate;
};

class LineMesh {
 public:
  LineMesh(const Line& line, const Fineness& fineness);

  int order() const { return order_; }
  const Fineness& fineness() const { return fineness_; }
  int functions() const { return functions_; }
  const std::vector<LineElement>& elements() const { return elements_; }
  Eigen::Index unknowns() const;
  // First unknown of an element.
  Eigen::Index first(std::size_t element) const;
  // The node (end of an element, from 0) at which a support, a spring or a mass sits.
  std::size_t node(double x) const;
  // True where two things sit at one place and the direction moves only one of them: derivatives do
  // not exist then.
  bool is_torn() const { return torn_; }

  // Rows of the field and of its first derivative at every node.
  RatedRows values_at_nodes(bool rates) const;
  RatedRows slopes_at_nodes(bool rates) const;
  // The same at the points of the quadrature, element by element.
  RatedRows values_inside(bool rates) const;
  RatedRows slopes_inside(bool rates) const;  // d = 2 only
  // Stiffness, mass per length and 1 at these points, times the length that each stands for.
  struct Weights {
    Vector stiffness, mass, length;
    Vector stiffness_rate, mass_rate, length_rate;
  };
  Weights weights(const Line& line) const;
  // P_n at the points of one element, points by functions.
  const Matrix& strains() const { return strains_; }

  // At any x: derivative `derivative` (0, 1, 2) of the field.
  Vector row(double x, int derivative) const;
  // Rate of the field's value at a place that moves, at fixed y.
  Vector row_rate(double x, double x_rate) const;

 private:
  void place_elements(const Line& line, const Fineness& fineness);
  std::size_t element_at(double x) const;
  Vector row_in(std::size_t element, double s, int derivative) const;
  RatedRows at_nodes(int derivative, bool rates) const;
  RatedRows inside(int derivative, bool rates) const;

  int order_ = 2, functions_ = 0;
  Fineness fineness_;
  bool torn_ = false;
  std::vector<LineElement> elements_;
  Matrix strains_;       // P_n at the points
  Matrix once_, twice_;  // its integrals from -1
};

}  // namespace graze
