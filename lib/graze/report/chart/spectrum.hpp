// Amplitudes over the frequency, from evenly spaced samples.
#pragma once

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

}  // namespace graze
