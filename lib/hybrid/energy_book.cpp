#include "graze/hybrid/energy_book.hpp"

namespace graze {

double mechanical_energy(const System& system, const Vector& q, const Vector& qdot) {
  return 0.5 * (qdot.squaredNorm() + system.omega.cwiseProduct(q).squaredNorm());
}

Work operator+(const Work& a, const Work& b) {
  return {a.forcing + b.forcing, a.load + b.load, a.constraint + b.constraint,
          a.dissipation + b.dissipation};
}

}  // namespace graze
