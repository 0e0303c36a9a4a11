#include <fmt/format.h>

#include <iterator>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {
namespace {

std::string cells(const OrbitLocusPoint& point) {
  return fmt::format("{},{},{},{},{},{}", csv_cell(point.value), csv_cell(point.second),
                     csv_cell(point.angle), csv_cell(point.impacts.front().phase),
                     csv_cell(point.impacts.front().speed), point.admissible ? 1 : 0);
}

}  // namespace

std::string loci_csv(const OrbitLoci& traced) {
  std::string text = "locus,label,period,impacts,value,second,angle,phase,speed,admissible\n";
  for (const OrbitLocus& locus : traced.loci)
    for (const OrbitLocusPoint& point : locus.points)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", locus.id, label_of(locus.kind),
                     locus.pattern.period, point.impacts.size(), cells(point));
  return text;
}

std::string special_csv(const LociRecord& record) {
  std::string text = "id,label,locus,value,second,angle,phase,speed,admissible\n";
  for (const OrbitLocus& locus : record.traced.loci)
    for (const OrbitLocusSpecial& special : locus.special)
      fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", special.id, special.label, locus.id,
                     cells(special.at));
  return text;
}

std::string regions_csv(const StableRegions& regions) {
  std::string text = "value,second,area,label\n";
  for (const RegionPlace& place : regions.places)
    if (place.finished)
      fmt::format_to(std::back_inserter(text), "{},{},{},\"{}\"\n", csv_cell(place.value),
                     csv_cell(place.second), place.area + 1, label_of(place.stable));
  return text;
}

}  // namespace graze
