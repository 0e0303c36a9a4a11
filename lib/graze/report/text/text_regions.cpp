#include <fmt/format.h>

#include <algorithm>

#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/folding.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostListed = 5;

std::string table_of(const LociRecord& record, const TextOptions& options) {
  const StableRegions& regions = *record.regions;
  Table table({"region", "stable", "places", "share", with_unit(record.traced.first, record.unit),
               with_unit(record.traced.second, record.second_unit)});
  std::vector<std::size_t> sizes;
  for (const RegionArea& area : regions.areas) sizes.push_back(area.places);
  const std::size_t all = regions.places.size();
  const std::vector<bool> is_folded = folded_groups(sizes, all);
  Folded folded;
  for (std::size_t i = 0; i < regions.areas.size(); ++i) {
    const RegionArea& area = regions.areas[i];
    if (is_folded[i]) {
      folded.add(area.places);
      continue;
    }
    const RegionPlace& inner = regions.places[area.inner];
    const std::string label = label_of(area.stable);
    table.add({fmt::format("{}", i + 1), label.empty() ? "-" : label,
               fmt::format("{}", area.places), share_text(area.places, all),
               digits_text(inner.value, 7), digits_text(inner.second, 7)});
  }
  return table.empty() ? "" : table.text(options.width) + folded.text(all);
}

std::string list_of(const LociRecord& record, const std::vector<OrbitAtPlace>& orbits,
                    const std::string& what) {
  std::string text;
  const std::size_t shown = std::min(orbits.size(), kMostListed);
  for (std::size_t i = 0; i < shown; ++i) {
    const RegionPlace& place = record.regions->places[orbits[i].place];
    text += fmt::format("note: {} at ({:.9g}, {:.9g}) {}\n", name_of(orbits[i].name), place.value,
                        place.second, what);
  }
  if (shown < orbits.size())
    text += fmt::format("note: the same at {} more places\n", orbits.size() - shown);
  return text;
}

std::string boundaries_text(const LociRecord& record) {
  const StableRegions& regions = *record.regions;
  const RegionBoundaries& boundaries = *record.boundaries;
  std::string text = fmt::format(
      "between {} pairs of places side by side the ({},{}) orbit begins or ceases to be stable; a "
      "locus passes between {} of them\n",
      boundaries.count, regions.period, regions.impacts,
      boundaries.count - static_cast<int>(boundaries.open.size()));
  const std::size_t shown = std::min(boundaries.open.size(), kMostListed);
  for (std::size_t i = 0; i < shown; ++i) {
    const RegionPlace& a = regions.places[boundaries.open[i].first];
    const RegionPlace& b = regions.places[boundaries.open[i].second];
    text += fmt::format("note: no locus passes between ({:.9g}, {:.9g}) and ({:.9g}, {:.9g})\n",
                        a.value, a.second, b.value, b.second);
  }
  if (shown < boundaries.open.size())
    text += fmt::format("note: the same for {} more pairs\n", boundaries.open.size() - shown);
  return text;
}

}  // namespace

std::string regions_text(const LociRecord& record, const TextOptions& options) {
  const StableRegions& regions = *record.regions;
  std::string text = table_of(record, options) + "\n";
  text += fmt::format(
      "{} by {} places; regions smaller than {} by {} may be missed, and so may orbits that "
      "neither the closed form nor a simulation leads to\n",
      regions.columns, regions.rows, quantity_text(regions.cell, 4, record.unit),
      quantity_text(regions.second_cell, 4, record.second_unit));
  if (options.verbose)
    text += fmt::format(
        "{} motions were simulated; {} rounds of exchange between neighbouring places\n",
        regions.simulated, regions.rounds);
  text += fmt::format(
      "{} stable orbits tested by a motion started beside them: {} settled on the orbit, {} "
      "approached too slowly to decide, {} left it\n",
      regions.confirmed + regions.undecided + static_cast<long long>(regions.refuted.size()),
      regions.confirmed, regions.undecided, regions.refuted.size());
  if (regions.searched > 0)
    text += fmt::format(
        "{} of the motions that settled on a ({},{}) orbit are on one that the closed form had not "
        "given\n",
        regions.missed.size(), regions.period, regions.impacts);
  if (record.boundaries) text += boundaries_text(record);
  text += list_of(record, regions.refuted,
                  "is stable by its multipliers, but a motion started beside it left it");
  text += list_of(record, regions.missed, "was found by simulation, not by the closed form");
  return text;
}

}  // namespace graze
