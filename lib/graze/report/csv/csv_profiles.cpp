#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/record/records.hpp"
#include "graze/report/csv/csv.hpp"

namespace graze {
namespace {

constexpr int kProfileSamplesPerPeriod = 200;

}  // namespace

ResultTable profiles_table(const OrbitRecord& record) {
  std::string names = "orbit,flight,time,phase";
  for (const MeasuredPlace& place : record.places) {
    names += "," + place.name('_');
    if (!place.seen.of_velocity) names += "," + place.name('_') + "_velocity";
  }
  ResultTable table(names);
  for (std::size_t k = 0; k < record.found.orbits.size(); ++k) {
    // Every place is sampled at the same instants.
    std::vector<std::vector<std::vector<CurveSample>>> curves;
    for (const MeasuredPlace& place : record.places)
      curves.push_back(orbit_curve(record.system, record.found.orbits[k], place.seen.row,
                                   kProfileSamplesPerPeriod));
    for (std::size_t flight = 0; !curves.empty() && flight < curves[0].size(); ++flight)
      for (std::size_t i = 0; i < curves[0][flight].size(); ++i) {
        const double theta = curves[0][flight][i].theta;
        const HarmonicForcing& forcing = *record.system.forcing();
        table.add(k + 1, flight + 1, (theta - forcing.phase) / forcing.frequency, theta);
        for (std::size_t place = 0; place < curves.size(); ++place) {
          const CurveSample& sample = curves[place][flight][i];
          if (!record.places[place].seen.of_velocity) table.add(sample.displacement);
          table.add(sample.velocity);
        }
      }
  }
  return table;
}

}  // namespace graze
