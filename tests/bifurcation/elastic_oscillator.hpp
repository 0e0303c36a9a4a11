// An oscillator with an elastic stop, x'' + 2 delta x' + x + k (x - gap)+ = force cos(w t), flown
// piece by piece in closed form, with its derivative by the start: nothing of the program is in it.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace graze::support {

struct ElasticOscillator {
  double delta, stiffness, gap;  // 1/s, 1/s^2, m

  struct Flown {
    Eigen::Vector2d state;  // x, x'
    Eigen::Matrix2d by_start;
  };

  // Over one period of the forcing, from its phase 0.
  Flown period(double frequency, double force, Eigen::Vector2d state) const {
    const double end = 2.0 * std::numbers::pi / frequency;
    Eigen::Matrix2d slope = Eigen::Matrix2d::Identity();
    bool pressed = state[0] > gap;
    for (double t = 0.0; t < end;) {
      const Piece piece = from(t, state, pressed, frequency, force);
      const double until = leaves(piece, t, end, pressed);
      slope = (piece.transition(until - t) * slope).eval();
      state = piece.at(until);
      t = until;
      pressed = !pressed;
    }
    return {state, slope};
  }

 private:
  // Where x'' + 2 delta x' + w0^2 (x - rest) = force cos(w t), from (x, x') at `start`.
  struct Piece {
    double start, delta, own, rest, frequency;  // own: w0^2
    std::complex<double> response;
    Eigen::Vector2d free;  // what the state at the start differs from the response by

    Eigen::Vector2d forced(double t) const {
      const std::complex<double> turned = response * std::polar(1.0, frequency * t);
      return {rest + turned.real(), -frequency * turned.imag()};
    }
    Eigen::Matrix2d transition(double s) const {
      const double damped = std::sqrt(own - delta * delta), e = std::exp(-delta * s);
      const double c = std::cos(damped * s), n = std::sin(damped * s) / damped;
      return Eigen::Matrix2d{{e * (c + delta * n), e * n}, {-e * own * n, e * (c - delta * n)}};
    }
    Eigen::Vector2d at(double t) const { return forced(t) + transition(t - start) * free; }
  };

  Piece from(double t, const Eigen::Vector2d& state, bool pressed, double frequency,
             double force) const {
    const double own = 1.0 + (pressed ? stiffness : 0.0);
    const std::complex<double> dynamic(own - frequency * frequency, 2.0 * delta * frequency);
    Piece piece{t,
                delta,
                own,
                pressed ? stiffness * gap / own : 0.0,
                frequency,
                force / dynamic,
                Eigen::Vector2d::Zero()};
    piece.free = state - piece.forced(t);
    return piece;
  }

  // When x passes the gap, or the end; samples far closer than an oscillation, and in between the
  // top of an arc that would pass it and come back.
  double leaves(const Piece& piece, double t, double end, bool pressed) const {
    const double sign = pressed ? 1.0 : -1.0, width = 0.02 / std::sqrt(piece.own);
    const auto inside = [&](double s) { return sign * (piece.at(s)[0] - gap) > 0.0; };
    const auto zero = [&](double low, double high, const auto& holds) {
      for (int i = 0; i < 60; ++i) (holds(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
      return 0.5 * (low + high);
    };
    for (double s = t; s < end; s += width) {
      const double next = std::min(s + width, end);
      // The very start lies on the surface and moves away from it.
      const double low = s > t ? s : s + 1e-3 * (next - s);
      if (!inside(next)) return zero(low, next, inside);
      if (sign * piece.at(low)[1] < 0.0 && sign * piece.at(next)[1] > 0.0) {
        const double top = zero(low, next, [&](double m) { return sign * piece.at(m)[1] < 0.0; });
        if (!inside(top)) return zero(low, top, inside);
      }
    }
    return end;
  }
};

}  // namespace graze::support
