#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {
namespace {

void add_point(const OrbitLocusPoint& point, ResultTable& table) {
  table.add(point.value, point.second, point.angle, point.impacts.front().phase,
            point.impacts.front().speed, point.admissible);
}

}  // namespace

ResultTable loci_table(const OrbitLoci& traced) {
  ResultTable table("locus,label,period,impacts,value,second,angle,phase,speed,admissible");
  for (const OrbitLocus& locus : traced.loci)
    for (const OrbitLocusPoint& point : locus.points) {
      table.add(locus.id, label_of(locus.kind), locus.pattern.period, point.impacts.size());
      add_point(point, table);
    }
  return table;
}

ResultTable special_table(const LociRecord& record) {
  ResultTable table("id,label,locus,value,second,angle,phase,speed,admissible");
  for (const OrbitLocus& locus : record.traced.loci)
    for (const OrbitLocusSpecial& special : locus.special) {
      table.add(special.id, special.label, locus.id);
      add_point(special.at, table);
    }
  return table;
}

ResultTable regions_table(const StableRegions& regions) {
  ResultTable table("value,second,area,label");
  for (const RegionPlace& place : regions.places)
    if (place.finished)
      table.add(place.value, place.second, place.area + 1, label_of(place.stable));
  return table;
}

}  // namespace graze
