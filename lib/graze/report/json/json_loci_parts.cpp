#include "graze/report/detail/names.hpp"
#include "graze/report/json/detail/json_loci.hpp"

namespace graze {
namespace {

Json place_json(const OrbitLocusPoint& point) {
  return {{"value", json_number(point.value)}, {"second", json_number(point.second)}};
}

Json point_json(OrbitLocusKind kind, const OrbitLocusPoint& point) {
  Json json = place_json(point);
  json["phase"] = json_number(point.impacts.front().phase);
  json["speed"] = json_number(point.impacts.front().speed);
  if (kind == OrbitLocusKind::kTorus) json["angle"] = json_number(point.angle);
  json["admissible"] = point.admissible;
  if (point.impacts.size() < 2 || !point.sticking.empty()) return json;
  Json at = Json::array();
  for (const OrbitImpact& impact : point.impacts)
    at.push_back({{"stop", impact.stop + 1},
                  {"period_index", impact.period_index},
                  {"phase", json_number(impact.phase)},
                  {"speed", json_number(impact.speed)}});
  json["at"] = at;
  return json;
}

Json locus_json(const OrbitLocus& locus) {
  Json stops = Json::array(), points = Json::array(), special = Json::array();
  for (const int stop : locus.pattern.stops) stops.push_back(stop + 1);
  for (const OrbitLocusPoint& point : locus.points) points.push_back(point_json(locus.kind, point));
  for (const OrbitLocusSpecial& s : locus.special) {
    Json json = {{"id", s.id}, {"label", s.label}};
    json.update(point_json(locus.kind, s.at));
    special.push_back(json);
  }
  return {{"id", locus.id},
          {"label", label_of(locus.kind)},
          {"period", locus.pattern.period},
          {"impacts", locus.sticks() ? Json(nullptr) : Json(locus.pattern.impacts())},
          {"stops", stops},
          {"stuck", locus.sticks()},
          {"ends", {name_of(locus.ends[0]), name_of(locus.ends[1])}},
          {"points", points},
          {"special", special}};
}

}  // namespace

Json loci_json(const OrbitLoci& traced) {
  Json loci = Json::array();
  for (const OrbitLocus& locus : traced.loci) loci.push_back(locus_json(locus));
  return loci;
}

Json loci_counters_json(const OrbitLoci& traced) {
  return {{"slices", traced.slices},
          {"starts", traced.starts},
          {"starts_lost", traced.lost_starts},
          {"loci_cut_short", traced.cut_short},
          {"traces_cut_short", traced.traces_cut_short},
          {"shooting_evaluations", traced.shooting_evaluations}};
}

}  // namespace graze
