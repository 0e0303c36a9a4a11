// The lowest 50 modes of an elastic block with 1e5 unknowns, held at one side and free: time and
// memory. Ends with 1 where it took more than 120 s of processor time or 6 GiB. Arguments: nodes a
// side (default 31), modes (50).
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "graze/fem/structural_modes.hpp"
#include "support/elastic_solid.hpp"

int main(int count, char** words) {
  const int side = count > 1 ? std::atoi(words[1]) : 31;
  bool met = true;
  const int modes = count > 2 ? std::atoi(words[2]) : 50;
  for (const bool is_held : {true, false}) {
    const auto structure = graze::solid::block(side, side + 1, side + 2, 1.0 / side, is_held);
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const graze::StructuralModes found = graze::lowest_modes(structure, modes);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double memory = static_cast<double>(usage.ru_maxrss) / 1048576.0;
    const double computed = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    met = met && computed <= 120.0 && memory <= 6.0;
    std::printf(
        "%s: %d unknowns, %d modes (%d rigid), %.5g to %.5g rad/s, residual %.2g, counted: %s, "
        "%.1f s (%.1f s of processor time), at most %.2f GiB so far\n",
        is_held ? "held" : "free", structure.size(), modes, found.rigid, found.omega[0],
        found.omega[modes - 1], found.residuals.maxCoeff(),
        found.counted ? std::to_string(*found.counted).c_str() : found.not_counted.c_str(),
        spent.count(), computed, memory);
  }
  return met ? 0 : 1;
}
