#include "graze/assembly/detail/system_interpolant.hpp"

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// A piece is halved no more often than this: beyond, the numbers are no smooth functions, or the
// scene allows no values there.
constexpr int kMostHalvings = 12;

// All numbers of a system one after the other, with the kind of each.
struct Numbers {
  std::vector<double> values;
  std::vector<int> kinds;

  void add(int kind, double number) {
    values.push_back(number);
    kinds.push_back(kind);
  }
  void add(int kind, const Vector& numbers) {
    for (const double number : numbers) add(kind, number);
  }
};

Numbers numbers_of(const System& system) {
  const Vector none = Vector::Zero(system.modes());
  Numbers numbers;
  numbers.add(0, system.forcing() ? system.forcing()->frequency : 0.0);
  numbers.add(1, system.omega);
  numbers.add(2, system.delta());
  numbers.add(3, system.forcing() ? system.forcing()->amplitude : none);
  numbers.add(4, system.load() ? *system.load() : none);
  int kind = 5;
  for (const Stop& stop : system.stops) {
    numbers.add(kind++, stop.gap);
    numbers.add(kind++, stop.row);
    numbers.add(kind++, stop.direction());
    if (stop.is_compliant()) continue;
    for (const double coefficient : stop.restitution().coefficients())
      numbers.add(kind++, coefficient);
  }
  return numbers;
}

struct Knot {
  std::vector<double> values, rates;
};

std::vector<Vector> cubic(const Knot& from, const Knot& to, double half) {
  const auto n = static_cast<Eigen::Index>(from.values.size());
  const auto vector = [n](const std::vector<double>& list) {
    return Vector(Eigen::Map<const Vector>(list.data(), n));
  };
  const Vector f0 = vector(from.values), f1 = vector(to.values);
  const Vector m0 = half * vector(from.rates), m1 = half * vector(to.rates);
  return {(f0 + f1) / 2.0 + (m0 - m1) / 4.0, (f1 - f0) * 0.75 - (m0 + m1) / 4.0, (m1 - m0) / 4.0,
          (f0 - f1 + m0 + m1) / 4.0};
}

// Whether the cubic's value and rate in the middle of the piece are the system's.
bool agrees(const std::vector<Vector>& powers, const Knot& middle, const std::vector<int>& kinds,
            double half) {
  const int last = *std::max_element(kinds.begin(), kinds.end());
  std::vector<double> size(static_cast<std::size_t>(last) + 1, 0.0), error = size;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto kind = static_cast<std::size_t>(kinds[i]);
    const auto at = static_cast<Eigen::Index>(i);
    size[kind] = std::max(size[kind], std::abs(middle.values[i]) + std::abs(powers[1][at]));
    error[kind] = std::max({error[kind], std::abs(powers[0][at] - middle.values[i]),
                            std::abs(powers[1][at] - half * middle.rates[i])});
  }
  for (std::size_t kind = 0; kind < size.size(); ++kind)
    if (!(error[kind] <= kInterpolantTolerance * size[kind])) return false;
  return true;
}

// Powers that are roundings of the others would only widen every bound.
void drop_roundings(std::vector<Vector>& powers) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  for (Eigen::Index i = 0; i < powers[0].size(); ++i) {
    const double size = std::abs(powers[0][i]) + std::abs(powers[1][i]);
    for (Vector& power : powers)
      if (std::abs(power[i]) <= kRounding * size) power[i] = 0.0;
  }
}

class Pieces {
 public:
  explicit Pieces(const SystemFamily& family) : cursor_(family) {}

  void add(double low, double high) { add(low, knot(low), high, knot(high), 0); }

  std::vector<SystemInterpolant::Piece> pieces;
  std::optional<System> like;
  int systems = 0;

 private:
  std::optional<Knot> knot(double value) {
    const System* system = cursor_.at(value);
    if (system == nullptr) return {};
    ++systems;
    if (!like) like = *system;
    Numbers numbers = numbers_of(*system);
    if (kinds_.empty()) kinds_ = numbers.kinds;
    return Knot{std::move(numbers.values), numbers_of(*cursor_.tangent_at(value)).values};
  }

  void add(double low, const std::optional<Knot>& from, double high, const std::optional<Knot>& to,
           int halvings) {
    const double middle = low + 0.5 * (high - low), half = 0.5 * (high - low);
    const std::optional<Knot> between = knot(middle);
    const bool last = halvings == kMostHalvings;
    if (from && between && to) {
      std::vector<Vector> powers = cubic(*from, *to, half);
      const bool good = agrees(powers, *between, kinds_, half);
      if (last || good) {
        drop_roundings(powers);
        pieces.push_back({low, high, std::move(powers), good});
        return;
      }
    } else if (last) {
      pieces.push_back({low, high, {}});
      return;
    }
    add(low, from, middle, between, halvings + 1);
    add(middle, between, high, to, halvings + 1);
  }

  SystemCursor cursor_;
  std::vector<int> kinds_;
};

}  // namespace

SystemInterpolant::SystemInterpolant(const SystemFamily& family, double low, double high) {
  Pieces all(family);
  all.add(low, high);
  pieces_ = std::move(all.pieces);
  like_ = std::move(all.like);
  systems_ = all.systems;
}

SystemForms SystemInterpolant::over(const Piece& piece, double low, double high) const {
  const double middle = piece.low + 0.5 * (piece.high - piece.low);
  const double half = 0.5 * (piece.high - piece.low);
  const MeanValueForm value = low < high ? MeanValueForm::variable(low, high) : MeanValueForm(low);
  const MeanValueForm t = (value - MeanValueForm(middle)) / MeanValueForm(half);
  Eigen::Index next = 0;
  const auto number = [&] {
    const Eigen::Index i = next++;
    std::size_t degree = piece.powers.size() - 1;
    while (degree > 0 && piece.powers[degree][i] == 0.0) --degree;
    MeanValueForm sum(piece.powers[degree][i]);
    while (degree-- > 0) sum = sum * t + MeanValueForm(piece.powers[degree][i]);
    return sum;
  };
  const auto numbers = [&](Eigen::Index count) {
    std::vector<MeanValueForm> list;
    list.reserve(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) list.push_back(number());
    return list;
  };
  const Eigen::Index n = like_->modes();
  SystemForms forms;
  forms.frequency = number();
  forms.omega = numbers(n);
  forms.delta = numbers(n);
  forms.amplitude = numbers(n);
  forms.load = numbers(n);
  for (const Stop& stop : like_->stops) {
    forms.stops.emplace_back();
    forms.stops.back().gap = number();
    forms.stops.back().row = numbers(n);
    forms.stops.back().direction = numbers(n);
    if (stop.is_compliant()) continue;
    forms.stops.back().restitution =
        numbers(static_cast<Eigen::Index>(stop.restitution().coefficients().size()));
  }
  return forms;
}

}  // namespace graze
