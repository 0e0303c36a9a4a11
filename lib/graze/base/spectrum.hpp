// Amplitudes and power over the frequency, from evenly spaced samples, under Hann's window.
#pragma once

#include <cstddef>
#include <vector>

namespace graze {

struct Spectrum {
  std::vector<double> frequency;  // 1/s, above zero and below half the sampling rate
  std::vector<double> amplitude;  // of the sinusoid there, in the unit of the values
};

// `rate`: samples a second. Under Hann's window: a sinusoid with a whole number of periods in the
// span has its amplitude at its frequency and half of it on either side. Empty for fewer than four
// samples.
Spectrum amplitude_spectrum(const std::vector<double>& values, double rate);

// The one-sided power spectral density of a signal by Welch's method: the mean over segments that
// overlap by half, each without its mean and under Hann's window. Its sum over the frequencies
// times their step is the variance of the signal. Keeps one segment, however long the signal is.
//
// P. D. Welch, IEEE Transactions on Audio and Electroacoustics 15 (1967) 70-73.
class PowerSpectrum {
 public:
  // `segment`: samples of a segment, even and at least 4; `rate`: samples a second.
  PowerSpectrum(std::size_t segment, double rate);

  void add(double value);

  long long segments() const { return segments_; }
  // At the frequencies k rate/segment, k = 0 .. segment/2, in the unit of the values squared per
  // Hz. Empty before a segment is complete.
  std::vector<double> density() const;

 private:
  std::size_t segment_;
  double rate_;
  std::vector<double> values_;  // of the segment that is being filled
  std::vector<double> power_;   // sums over segments
  long long segments_ = 0;
};

// An even number of samples, at most `most` and close to it, whose transform is fast; at least 4.
std::size_t segment_length(double most);

}  // namespace graze
