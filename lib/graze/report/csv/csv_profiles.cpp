#include <fmt/format.h>

#include <iterator>

#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/record/records.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {
namespace {

constexpr int kSamplesPerPeriod = 200;

}  // namespace

std::string profiles_csv(const OrbitRecord& record) {
  std::string text = "orbit,flight,time,phase";
  for (const MeasuredPlace& place : record.places) {
    text += "," + place.name('_');
    if (!place.seen.of_velocity) text += "," + place.name('_') + "_velocity";
  }
  text += "\n";
  for (std::size_t k = 0; k < record.found.orbits.size(); ++k) {
    // Every place is sampled at the same instants.
    std::vector<std::vector<std::vector<CurveSample>>> curves;
    for (const MeasuredPlace& place : record.places)
      curves.push_back(
          orbit_curve(record.system, record.found.orbits[k], place.seen.row, kSamplesPerPeriod));
    for (std::size_t flight = 0; !curves.empty() && flight < curves[0].size(); ++flight)
      for (std::size_t i = 0; i < curves[0][flight].size(); ++i) {
        const double theta = curves[0][flight][i].theta;
        const HarmonicForcing& forcing = *record.system.forcing();
        fmt::format_to(std::back_inserter(text), "{},{},{},{}", k + 1, flight + 1,
                       csv_cell((theta - forcing.phase) / forcing.frequency), csv_cell(theta));
        for (std::size_t place = 0; place < curves.size(); ++place) {
          const CurveSample& sample = curves[place][flight][i];
          if (!record.places[place].seen.of_velocity) text += "," + csv_cell(sample.displacement);
          text += "," + csv_cell(sample.velocity);
        }
        text += "\n";
      }
  }
  return text;
}

}  // namespace graze
