// How often values were met, counted in bins of equal width over whatever range turns up.
#pragma once

#include <vector>

namespace graze {

// Counts in equal bins from zero on.
struct BinCounts {
  double width = 0.0;             // of a bin, in the unit of the values
  std::vector<long long> counts;  // bin k: values from k width up to (k + 1) width
};

// Keeps a few thousand bins, however many values there are: where one lies beyond them, all bins
// become twice as wide. Their width is a power of two, so that no count moves over an edge. Values
// that are not finite are left out.
class Histogram {
 public:
  void add(double value);

  long long count() const { return count_; }
  // The value that a share of all values, 0 to 1, exceed, to within a bin, which is at most a
  // thousandth of their range. NaN without values.
  double exceeded(double share) const;
  // Counts in bins from zero to the largest value, at most so many and more than half as many. No
  // value may be negative. No bins without values.
  BinCounts from_zero(int most) const;

 private:
  void widen_to(double value);

  long long count_ = 0;
  double lowest_ = 0.0, highest_ = 0.0;
  double width_ = 0.0;  // 0: all values were equal so far
  double first_ = 0.0;  // index of the first bin, which begins at that times the width
  std::vector<long long> bins_;
};

}  // namespace graze
