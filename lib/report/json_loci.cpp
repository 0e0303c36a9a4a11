#include "graze/report/json.hpp"
#include "graze/report/json_value.hpp"
#include "graze/report/names.hpp"

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
  if (point.impacts.size() < 2) return json;
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
          {"impacts", locus.pattern.impacts()},
          {"stops", stops},
          {"ends", {name_of(locus.ends[0]), name_of(locus.ends[1])}},
          {"points", points},
          {"special", special}};
}

Json place_json(const RegionPlace& place) {
  return {{"value", json_number(place.value)},
          {"second", json_number(place.second)},
          {"label", label_of(place.stable)}};
}

Json listed_json(const StableRegions& regions, const std::vector<OrbitAtPlace>& orbits) {
  Json list = Json::array();
  for (const OrbitAtPlace& orbit : orbits) {
    const RegionPlace& place = regions.places[orbit.place];
    list.push_back({{"label", name_of(orbit.name)},
                    {"value", json_number(place.value)},
                    {"second", json_number(place.second)}});
  }
  return list;
}

Json borders_json(const StableRegions& regions, const RegionBorders& borders) {
  Json open = Json::array();
  for (const auto& [i, other] : borders.open) {
    const RegionPlace &a = regions.places[i], &b = regions.places[other];
    open.push_back({{"value", json_number(a.value)},
                    {"second", json_number(a.second)},
                    {"to_value", json_number(b.value)},
                    {"to_second", json_number(b.second)}});
  }
  return {{"count", borders.count}, {"without_locus", open}};
}

Json regions_json(const StableRegions& regions) {
  Json areas = Json::array(), places = Json::array();
  for (const RegionArea& area : regions.areas) {
    Json json = {{"id", areas.size() + 1},
                 {"label", label_of(area.stable)},
                 {"places", area.places},
                 {"share", area.share}};
    json["value"] = json_number(regions.places[area.inner].value);
    json["second"] = json_number(regions.places[area.inner].second);
    areas.push_back(json);
  }
  for (const RegionPlace& place : regions.places) {
    if (!place.finished) continue;
    Json json = place_json(place);
    json["area"] = place.area + 1;
    if (!place.message.empty()) json["message"] = place.message;
    places.push_back(json);
  }
  return {{"columns", regions.columns},
          {"rows", regions.rows},
          {"period", regions.period},
          {"impacts", regions.impacts},
          {"areas", areas},
          {"places", places},
          {"refuted", listed_json(regions, regions.refuted)},
          {"missed", listed_json(regions, regions.missed)},
          {"counters",
           {{"places", regions.finished},
            {"closed_form", regions.searched},
            {"confirmed", regions.confirmed},
            {"undecided", regions.undecided},
            {"refuted", regions.refuted.size()},
            {"missed", regions.missed.size()},
            {"simulated", regions.simulated},
            {"rounds", regions.rounds}}}};
}

}  // namespace

std::string to_json(const LociRecord& record) {
  // A document of branches that has none.
  BranchRecord branches;
  branches.info = record.info;
  branches.unit = record.unit;
  branches.traced.parameter = record.traced.first;
  branches.traced.notes = {
      "a locus that crosses none of the slices and meets no other is not found"};
  branches.warnings = record.warnings;
  branches.outcome = record.outcome;
  Json document = Json::parse(to_json(branches));
  document["units"]["second"] = record.second_unit;
  document["units"]["angle"] = "rad";
  Json loci = Json::array();
  for (const OrbitLocus& locus : record.traced.loci) loci.push_back(locus_json(locus));
  document["second"] = record.traced.second;
  document["loci"] = loci;
  document["counters"] = {{"slices", record.traced.slices},
                          {"starts", record.traced.starts},
                          {"starts_lost", record.traced.lost_starts},
                          {"loci_cut_short", record.traced.cut_short},
                          {"traces_cut_short", record.traced.traces_cut_short},
                          {"shooting_evaluations", record.traced.shooting_evaluations}};
  if (record.regions) {
    document["regions"] = regions_json(*record.regions);
    document["regions"]["borders"] =
        record.borders ? borders_json(*record.regions, *record.borders) : Json(nullptr);
  }
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace graze
