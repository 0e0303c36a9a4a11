#include "graze/base/detail/bracketed_zero.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace graze {

std::pair<double, double> bracketed_zero(const std::function<double(double)>& f,
                                         const BracketEnd& a, const BracketEnd& b) {
  // A hundred steps halve any interval down to neighbouring numbers.
  std::uintmax_t iterations = 100;
  return boost::math::tools::toms748_solve(f, a.at, b.at, a.value, b.value,
                                           boost::math::tools::eps_tolerance<double>(), iterations);
}

}  // namespace graze
