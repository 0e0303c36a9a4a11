#include "graze/record/study_records.hpp"

#include <algorithm>
#include <iterator>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/names/motion_names.hpp"

namespace graze {
namespace {

void describe_point(ResultVisitor& v, OrbitLocusKind kind, const OrbitLocusPoint& point) {
  const OrbitImpact* first = entry(point.impacts, 0);
  v.field({"value", "", "of the first parameter"}, point.value);
  v.field({"second", "", "of the second"}, point.second);
  v.field(Field{"angle", "rad", "of the critical multipliers"}.tabular(), point.angle);
  if (const auto some = v.where(kind == OrbitLocusKind::kTorus, "on NS"))
    v.field(Field{"angle", "rad", "of the multipliers"}.document(), point.angle);
  v.field({"phase", "rad", "of the first impact"}, first ? first->phase : 0.0);
  v.field({"speed", "m/s", "of its approach"}, first ? first->speed : 0.0);
  v.field({"admissible"}, point.admissible);
  if (const auto some =
          v.where(point.impacts.size() > 1 && point.sticking.empty(), "with several impacts"))
    describe_impacts(v, point.impacts);
}

void describe_locus(ResultVisitor& v, const OrbitLocus& locus,
                    const std::vector<std::string>& levels) {
  v.field(Field{"id", "", "from 1"}.as("locus").in("loci"), locus.id);
  v.field(Field{"label", "", "`LP`, `PD`, `NS`, `GR`, `CH`, `UZ`, `EX`"}.in("loci"),
          label_of(locus.kind));
  if (!levels.empty())
    v.field(
        Field{"level", "", "on UZ and EX the one that was asked for, `stop.1.speed=0.5`; else null"}
            .in("loci"),
        named_level(levels, is_of_level(locus.kind), locus.level));
  v.field(Field{"period", "", "p"}.in("loci"), locus.pattern.period);
  v.field({"impacts", "", "on GR with the grazing contact; null where the orbits stick"},
          locus.sticks() ? std::nullopt : std::optional(locus.pattern.impacts()));
  v.values({"stops", "", "of the impacts, or of the stuck phases, of its first point"},
           locus.pattern.stops, [](int stop) { return stop + 1; });
  v.field({"stuck"}, locus.sticks());
  v.values({"ends", "", "two"}, locus.ends, [](OrbitLocusEnd end) { return name_of(end); });
  v.list({"points", "", "along the locus"}, locus.points,
         [&](const OrbitLocusPoint& point, std::size_t) {
           v.row("loci", [&] {
             v.field(Field{"impacts"}.tabular(), point.impacts.size());
             describe_point(v, locus.kind, point);
           });
         });
  v.list({"special", "", "where loci meet or change their nature"}, locus.special,
         [&](const OrbitLocusSpecial& special, std::size_t) {
           v.row("special", [&] {
             v.field({"id", "", "`CP-1`, .."}, special.id);
             v.field({"label", "",
                      "`CP`, `R1`.. `R4`, `LPPD`, `LPNS`, `PDPD`, `PDNS`, `NSNS`, `BP`; with "
                      "`--normal-forms` `GPD`, `GNS`; `LPGR`, `PDGR`, `NSGR`, `GRGR`"},
                     special.label);
             v.field(Field{"locus", "", "its id"}.tabular(), locus.id);
             describe_point(v, locus.kind, special.at);
           });
         });
}

void describe_place(ResultVisitor& v, const RegionPlace& place) {
  v.field({"value"}, place.value);
  v.field({"second"}, place.second);
}

void describe_orbits(ResultVisitor& v, const Field& field, const StableRegions& regions,
                     const std::vector<OrbitAtPlace>& orbits) {
  v.list(field, orbits, [&](const OrbitAtPlace& orbit, std::size_t) {
    v.field({"label"}, name_of(orbit.name));
    if (const RegionPlace* place = entry(regions.places, orbit.place)) describe_place(v, *place);
  });
}

void describe_boundaries(ResultVisitor& v, const StableRegions& regions,
                         const std::optional<RegionBoundaries>& boundaries) {
  const Field field = {"boundaries", "", "null unless loci of all kinds are traced"};
  v.maybe_part(field, boundaries.has_value(), [&] {
    v.field({"count", "", "of neighbours between which the (P, K) orbit's stability changes"},
            held(boundaries).count);
    v.list({"without_locus", "", "those without a locus between them"}, held(boundaries).open,
           [&](const std::pair<std::size_t, std::size_t>& pair, std::size_t) {
             const RegionPlace *one = entry(regions.places, pair.first),
                               *other = entry(regions.places, pair.second);
             if (!one || !other) return;
             describe_place(v, *one);
             v.field({"to_value"}, other->value);
             v.field({"to_second"}, other->second);
           });
  });
}

void describe_regions(ResultVisitor& v, const StableRegions& regions,
                      const std::optional<RegionBoundaries>& boundaries) {
  v.field({"columns", "", "N"}, regions.columns);
  v.field({"rows", "", "N"}, regions.rows);
  v.field({"period", "", "asked for"}, regions.period);
  v.field({"impacts", "", "asked for"}, regions.impacts);
  v.list({"areas", "", "adjacent places with one label"}, regions.areas,
         [&](const RegionArea& area, std::size_t i) {
           v.field({"id", "", "from 1, the largest first"}, i + 1);
           v.field({"label"}, label_of(area.stable));
           v.field({"places", "", "how many"}, area.places);
           v.field({"share", "", "of all places"}, area.share);
           // The place furthest from its boundary.
           if (const RegionPlace* inner = entry(regions.places, area.inner))
             describe_place(v, *inner);
         });
  std::vector<RegionPlace> finished;
  std::copy_if(regions.places.begin(), regions.places.end(), std::back_inserter(finished),
               [](const RegionPlace& place) { return place.finished; });
  v.list({"places", "", "middles of cells, row by row from `--second-from`"}, finished,
         [&](const RegionPlace& place, std::size_t) {
           v.row("regions", [&] {
             describe_place(v, place);
             v.field({"area", "", "its id"}, place.area + 1);
             v.field({"label", "", "stable motions, `(1,1) + no impact`; empty: none was found"},
                     label_of(place.stable));
             if (const auto some =
                     v.where(!place.message.empty(), "where a motion could not be followed"))
               v.field(Field{"message"}.document(), place.message);
           });
         });
  describe_orbits(v, {"refuted", "", "orbits that motions beside them left"}, regions,
                  regions.refuted);
  describe_orbits(v, {"missed", "", "that a simulation found and the closed form should have"},
                  regions, regions.missed);
  v.part({"counters", "", "of what was done"}, [&] {
    v.field({"places", "", "finished"}, regions.finished);
    v.field({"closed_form", "", "places at which it held"}, regions.searched);
    v.field({"confirmed", "", "orbits that a motion beside them settled on"}, regions.confirmed);
    v.field({"undecided", "", "approached too slowly to be decided"}, regions.undecided);
    v.field({"refuted", "", "left, and not in the labels"}, regions.refuted.size());
    v.field({"missed", "", "in the labels"}, regions.missed.size());
    v.field({"simulated", "", "motions"}, regions.simulated);
    v.field({"rounds", "", "of exchange between neighbours"}, regions.rounds);
  });
  describe_boundaries(v, regions, boundaries);
}

}  // namespace

void describe_loci(ResultVisitor& v, const OrbitLoci& traced) {
  v.list({"loci", "", "with `--locus`"}, traced.loci,
         [&](const OrbitLocus& locus, std::size_t) { describe_locus(v, locus, traced.levels); });
  v.part({"counters", "", "of what was done"}, [&] {
    v.field({"slices", "", "on which branches were traced"}, traced.slices);
    v.field({"starts", "", "special points of these"}, traced.starts);
    v.field({"starts_lost", "", "that led to no locus"}, traced.lost_starts);
    v.field({"loci_cut_short"}, traced.cut_short);
    v.field({"traces_cut_short", "", "branches"}, traced.traces_cut_short);
    v.field({"shooting_evaluations"}, traced.shooting_evaluations);
  });
}

void describe(ResultVisitor& v, const LociRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"parameter", "", "the first"}, record.traced.first);
  v.field({"second", "", "the second"}, record.traced.second);
  v.unit("value", record.unit);
  v.unit("second", record.second_unit);
  v.list({"branches", "", "none"}, std::vector<OrbitLocus>(),
         [](const OrbitLocus&, std::size_t) {});
  describe_loci(v, record.traced);
  if (record.regions)
    v.part({"regions", "", "with `--regions`"},
           [&] { describe_regions(v, *record.regions, record.boundaries); });
  describe_notes(v, {"a locus that crosses none of the slices and meets no other is not found"});
}

}  // namespace graze
