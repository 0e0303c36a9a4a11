#include "graze/report/json/detail/json_loci.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/json/json.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {
namespace {

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

Json boundaries_json(const StableRegions& regions, const RegionBoundaries& boundaries) {
  Json open = Json::array();
  for (const auto& [i, other] : boundaries.open) {
    const RegionPlace &a = regions.places[i], &b = regions.places[other];
    open.push_back({{"value", json_number(a.value)},
                    {"second", json_number(a.second)},
                    {"to_value", json_number(b.value)},
                    {"to_second", json_number(b.second)}});
  }
  return {{"count", boundaries.count}, {"without_locus", open}};
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
  Json document = parsed(to_json(branches));
  document["units"]["second"] = record.second_unit;
  document["units"]["angle"] = "rad";
  document["second"] = record.traced.second;
  document["loci"] = loci_json(record.traced);
  document["counters"] = loci_counters_json(record.traced);
  if (record.regions) {
    document["regions"] = regions_json(*record.regions);
    document["regions"]["boundaries"] =
        record.boundaries ? boundaries_json(*record.regions, *record.boundaries) : Json(nullptr);
  }
  return document_text(std::move(document), record.info);
}

}  // namespace graze
