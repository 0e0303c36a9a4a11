#include "graze/structure/detail/span_modes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "graze/scene/closed_modes.hpp"
#include "graze/structure/detail/cantilever.hpp"

namespace graze {

CantileverModes::CantileverModes(const Beam& beam, const Beam* rate)
    : count_(beam.modes),
      length_{beam.length, rate ? rate->length : 0.0},
      modulus_{beam.youngs_modulus, rate ? rate->youngs_modulus : 0.0},
      density_{beam.density, rate ? rate->density : 0.0},
      section_(even_section(beam, rate)) {}

double CantileverModes::scale() const {
  return 1.0 / std::sqrt(density_.value * section_.area.value * length_.value);
}

double CantileverModes::scale_rate() const {
  return -0.5 * (density_.rate / density_.value + section_.area.rate / section_.area.value +
                 length_.rate / length_.value);
}

Vector CantileverModes::omega() const {
  const double unit = std::sqrt(modulus_.value * section_.second_moment.value /
                                (density_.value * section_.area.value)) /
                      (length_.value * length_.value);
  Vector omega(count_);
  for (int j = 0; j < count_; ++j) {
    const double b = cantilever_wave_number(j + 1);
    omega[j] = b * b * unit;
  }
  return omega;
}

Vector CantileverModes::omega_rate() const {
  return omega() *
         (0.5 * (modulus_.rate / modulus_.value +
                 section_.second_moment.rate / section_.second_moment.value -
                 density_.rate / density_.value - section_.area.rate / section_.area.value) -
          2.0 * length_.rate / length_.value);
}

Vector CantileverModes::shapes(double x) const {
  Vector phi(count_);
  for (int j = 0; j < count_; ++j) phi[j] = scale() * cantilever_shape(j + 1, x / length_.value);
  return phi;
}

Vector CantileverModes::shape_rates(double x, double x_rate) const {
  const double xi_rate = (x_rate - x * length_.rate / length_.value) / length_.value;
  Vector rate = scale_rate() * shapes(x);
  for (int j = 0; j < count_; ++j)
    rate[j] += scale() * cantilever_slope(j + 1, x / length_.value) * xi_rate;
  return rate;
}

Vector CantileverModes::strains(double x, double factor) const {
  const double of_shape = factor * scale() / (length_.value * length_.value);
  Vector strain(count_);
  for (int j = 0; j < count_; ++j)
    strain[j] = of_shape * cantilever_curvature(j + 1, x / length_.value);
  return strain;
}

Vector CantileverModes::inertia() const {
  Vector g(count_);
  for (int j = 0; j < count_; ++j) g[j] = cantilever_mean(j + 1) / scale();
  return g;
}

Vector CantileverModes::inertia_rate() const { return -scale_rate() * inertia(); }

Vector CantileverModes::load() const { return inertia() / (density_.value * section_.area.value); }

Vector CantileverModes::load_rate() const {
  const Vector g = load();
  Vector rate = -scale_rate() * g;
  rate -= g * (density_.rate / density_.value + section_.area.rate / section_.area.value);
  return rate;
}

namespace {

Vector vector_of(const std::vector<double>* list) {
  return list ? Vector(Eigen::Map<const Vector>(list->data(), std::ssize(*list))) : Vector();
}

}  // namespace

UniformLineModes::UniformLineModes(const Line& line, const Span& span,
                                   const std::vector<double>* frequencies,
                                   const std::vector<double>* frequency_rates)
    : count_(span.modes),
      left_(span.ends[0] == Hold::kPinned),
      right_(span.ends[1] == Hold::kPinned),
      length_(line.length),
      stiffness_(line.pieces.front().stiffness.front()),
      mass_(line.pieces.front().mass.front()),
      given_(vector_of(frequencies)),
      given_rate_(vector_of(frequency_rates)) {}

double UniformLineModes::wave(int j) const {
  return (j - (left_ && right_ ? 0.0 : left_ || right_ ? 0.5 : 1.0)) * std::numbers::pi;
}

double UniformLineModes::amplitude(int j) const {
  const bool rigid = wave(j) == 0.0;
  return std::sqrt((rigid ? 1.0 : 2.0) / (mass_.value * length_.value));
}

double UniformLineModes::amplitude_rate() const {
  return -0.5 * (mass_.rate / mass_.value + length_.rate / length_.value);
}

Vector UniformLineModes::omega() const {
  if (given_.size() > 0) return given_;
  const double unit = std::sqrt(stiffness_.value / mass_.value) / length_.value;
  Vector omega(count_);
  for (int j = 0; j < count_; ++j) omega[j] = wave(j + 1) * unit;
  return omega;
}

Vector UniformLineModes::omega_rate() const {
  if (given_.size() > 0) return given_rate_;
  return omega() * (0.5 * (stiffness_.rate / stiffness_.value - mass_.rate / mass_.value) -
                    length_.rate / length_.value);
}

Vector UniformLineModes::shapes(double x) const {
  Vector phi(count_);
  for (int j = 1; j <= count_; ++j) {
    const double angle = wave(j) * (x / length_.value);
    phi[j - 1] = amplitude(j) * (left_ ? std::sin(angle) : std::cos(angle));
  }
  return phi;
}

Vector UniformLineModes::strains(double x, double factor) const {
  Vector strain(count_);
  for (int j = 1; j <= count_; ++j) {
    const double angle = wave(j) * (x / length_.value);
    strain[j - 1] = factor * amplitude(j) * wave(j) / length_.value *
                    (left_ ? std::cos(angle) : -std::sin(angle));
  }
  return strain;
}

Vector UniformLineModes::shape_rates(double x, double x_rate) const {
  return amplitude_rate() * shapes(x) +
         (x_rate - x * length_.rate / length_.value) * strains(x, 1.0);
}

// Integrals of sin(w x) and cos(w x) whose waves end where the right end lets them.
Vector UniformLineModes::load() const {
  Vector load(count_);
  for (int j = 1; j <= count_; ++j) {
    const bool odd = j % 2 == 1;
    double sum = odd ? 1.0 : -1.0;  // of sin(w) at a right end that is held
    if (left_) sum = right_ ? (odd ? 2.0 : 0.0) : 1.0;
    if (!left_ && !right_) sum = 0.0;
    load[j - 1] = wave(j) == 0.0 ? amplitude(j) * length_.value
                                 : amplitude(j) * length_.value * sum / wave(j);
  }
  return load;
}

Vector UniformLineModes::load_rate() const {
  return load() * (amplitude_rate() + length_.rate / length_.value);
}

Vector UniformLineModes::inertia() const { return mass_.value * load(); }

Vector UniformLineModes::inertia_rate() const {
  return mass_.rate * load() + mass_.value * load_rate();
}

namespace {

// All numbers that modes depend on.
std::vector<double> numbers_of(const Line& line, int asked) {
  std::vector<double> numbers{double(line.order), line.length.value, line.tension.value,
                              double(asked)};
  const auto add = [&](std::initializer_list<double> more) { numbers.insert(numbers.end(), more); };
  for (const LinePiece& piece : line.pieces) {
    add({piece.start.value, piece.end.value});
    for (std::size_t k = 0; k < piece.mass.size(); ++k)
      add({piece.stiffness[k].value, piece.mass[k].value});
  }
  for (const LineSupport& support : line.supports)
    add({1.0, support.x.value, double(support.holds_value), double(support.holds_slope)});
  for (const LineSpring& spring : line.springs)
    add({2.0, spring.x.value, spring.stiffness.value, double(spring.on_slope)});
  for (const LineMass& mass : line.masses)
    add({3.0, mass.x.value, mass.mass.value, mass.inertia.value});
  return numbers;
}

// The modes of one scene are asked for several times in a row: for the system, its rates, probes.
std::shared_ptr<const LineModes> modes_of(const Scene& scene, const Line& line) {
  struct Last {
    std::vector<double> numbers;
    std::shared_ptr<const LineModes> modes;
  };
  thread_local Last last;
  const int asked = scene.modes();
  std::vector<double> numbers = numbers_of(line, asked);
  if (last.modes && last.numbers == numbers) return last.modes;
  LineSolution found = line_modes(line, asked);
  if (const auto critical = found.fault.critical_compression)
    throw scene_error(scene, "beam.tension",
                      *critical > 0.0
                          ? fmt::format("the beam buckles under a compression of {:.6g}, {} is not "
                                        "allowed, it must be greater than {:.6g}",
                                        *critical, line.tension.value, -*critical)
                          : "nothing keeps the beam from turning under compression, it must not "
                            "be negative");
  if (found.fault.unresolved)
    throw scene_error(scene, fmt::format("{}.modes", scene.structure_name()),
                      fmt::format("no elements that could be afforded resolve {} modes of this "
                                  "structure, it must be fewer",
                                  asked));
  last = {std::move(numbers), std::make_shared<const LineModes>(std::move(*found.modes))};
  return last.modes;
}

}  // namespace

ElementModes::ElementModes(const Scene& scene, const Scene* direction) {
  const Line line = line_of(scene, direction);
  modes_ = modes_of(scene, line);
  if (direction) {
    LineRatesOrNot found = line_rates(line, *modes_);
    if (found.fault.torn)
      throw scene_error(scene, scene.structure_name(),
                        "there is no derivative: two of its pieces, supports and masses meet at "
                        "one place, of which the parameter moves only one; they must be a little "
                        "apart");
    if (found.fault.first > 0)
      throw scene_error(scene, scene.structure_name(),
                        fmt::format("there is no derivative: modes {} and {} have the same "
                                    "frequency, and the parameter turns them into each other; it "
                                    "must have other values",
                                    found.fault.first, found.fault.second));
    rates_ = std::move(found.rates);
    mesh_.emplace(line, modes_->mesh.fineness());
  }
  loads_ = line_loads(line, *modes_, rates_ ? &*rates_ : nullptr);
}

Vector ElementModes::shape_rates(double x, double x_rate) const {
  return rates_->unknowns.transpose() * mesh_->row(x, 0) +
         modes_->unknowns.leftCols(modes_->asked).transpose() * mesh_->row_rate(x, x_rate);
}

ElementAccuracy ElementModes::accuracy() const {
  return {static_cast<int>(modes_->mesh.elements().size()),
          modes_->mesh.functions() + modes_->mesh.order() - 1, modes_->rigid, modes_->change,
          modes_->change_beyond};
}

SpanModes span_modes(const Scene& scene, const Scene* direction) {
  if (!has_closed_modes(scene)) return ElementModes(scene, direction);
  if (const Beam* beam = scene.beam())
    return CantileverModes(*beam, direction ? direction->beam() : nullptr);
  const TautString* string = scene.string();
  if (string == nullptr || string->frequencies.empty())
    return UniformLineModes(line_of(scene, direction), *scene.span());
  return UniformLineModes(line_of(scene, direction), *string, &string->frequencies,
                          direction ? &direction->string()->frequencies : nullptr);
}

}  // namespace graze
