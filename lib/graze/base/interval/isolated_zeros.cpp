#include "graze/base/interval/detail/isolated_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/detail/bracketed_zero.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

struct ZeroCell {
  double low = 0.0, high = 0.0;
  int sign = 0;       // that the function has all over it; 0 where only the signs at its ends say
  bool left = false;  // it may hold more zeros than these signs show
};

class Isolation {
 public:
  explicit Isolation(const BoundedFunction& f) : f_(f) {}

  IsolatedZeros over(double low, double high, long long most_cells) {
    std::vector<ZeroCell> open{{low, high}};
    long long looked_at = 0;
    // Narrower cells are one point within the rounding of the range: next to 0 there are many.
    const double finest = std::numeric_limits<double>::epsilon() * (high - low);
    while (!open.empty()) {
      std::vector<ZeroCell> halves;
      const bool affordable =
          looked_at + static_cast<long long>(open.size()) <= std::max(most_cells, 1LL);
      for (const ZeroCell& cell : open) {
        const double middle = cell.low + 0.5 * (cell.high - cell.low);
        if (affordable && goes_on() && settles(cell)) continue;
        if (affordable && !stopped_ && middle > cell.low && middle < cell.high &&
            cell.high - cell.low > finest) {
          halves.push_back({cell.low, middle});
          halves.push_back({middle, cell.high});
        } else {
          leave(cell);
        }
      }
      if (affordable) looked_at += static_cast<long long>(open.size());
      open = std::move(halves);
    }
    collect();
    return std::move(found_);
  }

 private:
  // Once it was asked to stop all that is open is left so.
  bool goes_on() {
    stopped_ = stopped_ || StopScope::is_over();
    return !stopped_;
  }

  // Whether the cell needs no halving.
  bool settles(const ZeroCell& cell) {
    ++found_.evaluations;
    const std::optional<MeanValueForm> form = f_(cell.low, cell.high);
    if (!form) return false;
    const int sign = form->value.low > 0.0 ? 1 : form->value.high < 0.0 ? -1 : 0;
    if (sign == 0 && !(form->slope.low > 0.0) && !(form->slope.high < 0.0)) return false;
    cells_.push_back({cell.low, cell.high, sign});
    return true;
  }

  void leave(ZeroCell cell) {
    count_undecided(cell);
    cell.left = true;
    cells_.push_back(cell);
  }

  void count_undecided(const ZeroCell& cell) {
    ++found_.undecided;
    found_.widest = std::max(found_.widest, cell.high - cell.low);
  }

  double at(double value) {
    ++found_.evaluations;
    const std::optional<MeanValueForm> form = f_(value, value);
    return form ? form->middle.middle() : std::numeric_limits<double>::quiet_NaN();
  }

  static int sign_of(double number) { return number > 0.0 ? 1 : number < 0.0 ? -1 : 0; }

  void collect() {
    std::sort(cells_.begin(), cells_.end(),
              [](const ZeroCell& a, const ZeroCell& b) { return a.low < b.low; });
    int sign = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const ZeroCell& cell = cells_[i];
      double from = 0.0, to = 0.0;
      int before = cell.sign, after = cell.sign;
      if (cell.sign == 0) {
        // Neighbours say the same of the point between them.
        if (goes_on()) {
          from = at(cell.low);
          to = at(cell.high);
        } else if (!cell.left) {
          count_undecided(cell);
        }
        before = i > 0 && sign != 0 ? sign : sign_of(from);
        after = sign_of(to);
        if (after == 0 && i + 1 < cells_.size()) after = cells_[i + 1].sign;
      }
      if (found_.first_sign == 0 && found_.zeros.empty())
        found_.first_sign = before != 0 ? before : after;
      if (sign != 0 && before != 0 && sign != before) found_.zeros.push_back(cell.low);
      if (before != 0 && after != 0 && before != after)
        found_.zeros.push_back(zero_within(cell, from, to));
      if (after != 0) sign = after;
    }
  }

  double zero_within(const ZeroCell& cell, double from, double to) {
    if (!(sign_of(from) * sign_of(to) < 0)) return sign_of(to) == 0 ? cell.high : cell.low;
    const auto [low, high] = bracketed_zero([this](double value) { return at(value); },
                                            {cell.low, from}, {cell.high, to});
    return low + 0.5 * (high - low);
  }

  const BoundedFunction& f_;
  std::vector<ZeroCell> cells_;
  IsolatedZeros found_;
  bool stopped_ = false;
};

}  // namespace

IsolatedZeros isolated_zeros(const BoundedFunction& f, double low, double high,
                             long long most_cells) {
  return Isolation(f).over(low, high, most_cells);
}

}  // namespace graze
