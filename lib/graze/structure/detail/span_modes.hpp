// Modes of a beam, a string or a bar as functions of the place, mass-normalised, by whichever way
// gives them best: closed forms of the uniform clamped-free beam and of uniform strings and bars,
// elements of all others. Rates are along the direction that the modes were made with.
//
// Sign: the first quantity that is free at the left end is positive there, the value at a free or
// sliding end, the slope at a pinned or fixed one, the curvature at a clamp. At the free end of the
// clamped-free beam that is phi_j(L) = 2 (-1)^(j+1)/sqrt(rho A L). For a mode that leaves the left
// end at rest the largest value is positive.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "graze/structure/detail/line_modes.hpp"
#include "graze/structure/element_accuracy.hpp"

namespace graze {

class CantileverModes {
 public:
  CantileverModes(const Beam& beam, const Beam* rate);

  Vector omega() const;
  Vector omega_rate() const;
  Vector shapes(double x) const;
  Vector shape_rates(double x, double x_rate) const;
  Vector strains(double x, double factor) const;  // factor times u'' or u'
  Vector inertia() const;                         // integral of mass times shape
  Vector inertia_rate() const;
  Vector load() const;  // integral of the shape
  Vector load_rate() const;

 private:
  double scale() const;       // phi_j(x) = shape(x/L) scale
  double scale_rate() const;  // of its logarithm
  Rated per_length() const { return density_ * section_.area; }

  int count_;
  Rated length_, modulus_, density_;
  SectionNumbers<Rated> section_;
};

class UniformLineModes {
 public:
  // Of a string whose frequencies are given, these and their rates (null: none asked for).
  UniformLineModes(const Line& line, const Span& span,
                   const std::vector<double>* frequencies = nullptr,
                   const std::vector<double>* frequency_rates = nullptr);

  Vector omega() const;
  Vector omega_rate() const;
  Vector shapes(double x) const;
  Vector shape_rates(double x, double x_rate) const;
  Vector strains(double x, double factor) const;
  Vector inertia() const;
  Vector inertia_rate() const;
  Vector load() const;
  Vector load_rate() const;

 private:
  double wave(int j) const;       // of mode j = 1.., times the length
  double amplitude(int j) const;  // of the shape
  double amplitude_rate() const;  // of its logarithm
  Vector slopes(double x) const;

  int count_;
  bool left_, right_;  // held
  Rated length_, stiffness_, mass_;
  Vector given_, given_rate_;  // frequencies; empty where they follow from the stiffness
};

class ElementModes {
 public:
  // Throws InputError where a beam buckles, or the modes cannot be resolved; `direction` may be
  // null, else throws where there are no rates along it.
  ElementModes(const Scene& scene, const Scene* direction);

  Vector omega() const { return modes_->omega.head(modes_->asked); }
  Vector omega_rate() const { return rates_->omega; }
  Vector shapes(double x) const { return modes_->row(x, 0); }
  Vector shape_rates(double x, double x_rate) const;
  Vector strains(double x, double factor) const {
    return factor * modes_->row(x, modes_->mesh.order());
  }
  Vector slopes(double x) const { return modes_->row(x, 1); }
  Vector inertia() const { return loads_.inertia; }
  Vector inertia_rate() const { return loads_.inertia_rate; }
  Vector load() const { return loads_.length; }
  Vector load_rate() const { return loads_.length_rate; }
  ElementAccuracy accuracy() const;

 private:
  std::shared_ptr<const LineModes> modes_;
  std::optional<LineMesh> mesh_;  // with rates
  std::optional<LineRates> rates_;
  LineLoads loads_;
};

using SpanModes = std::variant<CantileverModes, UniformLineModes, ElementModes>;

// The modes of a checked scene with a beam, a string or a bar; `direction`: as in line_of.
SpanModes span_modes(const Scene& scene, const Scene* direction = nullptr);

}  // namespace graze
