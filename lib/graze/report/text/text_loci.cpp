#include <fmt/format.h>

#include <algorithm>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/detail/loci_record.hpp"
#include "graze/report/detail/names.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// "20 .. 120"
std::string span(const OrbitLocus& locus, double OrbitLocusPoint::*of) {
  const auto [low, high] = std::minmax_element(
      locus.points.begin(), locus.points.end(),
      [of](const OrbitLocusPoint& a, const OrbitLocusPoint& b) { return a.*of < b.*of; });
  return fmt::format("{:.7g} .. {:.7g}", (*low).*of, (*high).*of);
}

}  // namespace

std::string to_text(const LociRecord& record) {
  const OrbitLoci& traced = record.traced;
  const std::string first = with_unit(traced.first, record.unit);
  const std::string second = with_unit(traced.second, record.second_unit);
  Table loci({"locus", "kind", "orbit", "points", first, second, "ends"});
  Table special({"point", "locus", first, second});
  for (const OrbitLocus& locus : traced.loci) {
    const bool closed = locus.ends[0] == OrbitLocusEnd::kClosed;
    loci.add(
        {fmt::format("{}", locus.id), label_of(locus.kind),
         locus.sticks() ? fmt::format("({}, stick)", locus.pattern.period)
                        : fmt::format("({}, {})", locus.pattern.period, locus.pattern.impacts()),
         fmt::format("{}", locus.points.size()), span(locus, &OrbitLocusPoint::value),
         span(locus, &OrbitLocusPoint::second),
         closed ? name_of(locus.ends[0]) : name_of(locus.ends[0]) + ", " + name_of(locus.ends[1])});
    for (const OrbitLocusSpecial& s : locus.special)
      special.add({s.id, fmt::format("{}", locus.id), fmt::format("{:.13g}", s.at.value),
                   fmt::format("{:.13g}", s.at.second)});
  }
  std::string text;
  if (!loci.empty()) text += loci.text() + "\n";
  if (!special.empty()) text += special.text() + "\n";
  const std::string counted =
      fmt::format("{} special point{}, {} evaluations of the shooting equations\n", traced.starts,
                  traced.starts == 1 ? "" : "s", traced.shooting_evaluations);
  // Without slices there is one start, given.
  text += traced.slices == 0
              ? counted
              : fmt::format(
                    "{} slices of the plane, {}note: a locus that crosses none of the "
                    "slices and meets no other is not found; --slices looks closer\n",
                    traced.slices, counted);
  if (record.regions && traced.loci.empty()) text += "note: no locus was met\n";
  if (record.regions) text += "\n" + regions_text(record);
  const Outcome& outcome = record.outcome;
  if (!outcome.message.empty()) text += fmt::format("{}: {}\n", outcome.name, outcome.message);
  return text;
}

}  // namespace graze
