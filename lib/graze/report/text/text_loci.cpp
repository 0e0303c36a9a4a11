#include <fmt/format.h>

#include <algorithm>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/number_text.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

// "20 .. 120"
std::string span(const OrbitLocus& locus, double OrbitLocusPoint::*of) {
  const auto [low, high] = std::minmax_element(
      locus.points.begin(), locus.points.end(),
      [of](const OrbitLocusPoint& a, const OrbitLocusPoint& b) { return a.*of < b.*of; });
  return fmt::format("{} .. {}", digits_text((*low).*of, 7), digits_text((*high).*of, 7));
}

}  // namespace

std::string to_text(const LociRecord& record, const TextOptions& options) {
  const OrbitLoci& traced = record.traced;
  const std::string first = with_unit(traced.first, record.unit);
  const std::string second = with_unit(traced.second, record.second_unit);
  Table loci({"locus", "kind", "orbit", "points", first, second, "ends"});
  Table special({"point", "locus", first, second});
  const auto kind_text = [&](const OrbitLocus& locus) {
    const bool of_level = is_of_level(locus.kind) && locus.level < traced.levels.size();
    return label_of(locus.kind) + (of_level ? " " + traced.levels[locus.level] : std::string());
  };
  for (const OrbitLocus& locus : traced.loci) {
    const bool closed = locus.ends[0] == OrbitLocusEnd::kClosed;
    loci.add(
        {fmt::format("{}", locus.id), kind_text(locus),
         locus.sticks() ? fmt::format("({}, stick)", locus.pattern.period)
                        : fmt::format("({}, {})", locus.pattern.period, locus.pattern.impacts()),
         fmt::format("{}", locus.points.size()), span(locus, &OrbitLocusPoint::value),
         span(locus, &OrbitLocusPoint::second),
         closed ? name_of(locus.ends[0]) : name_of(locus.ends[0]) + ", " + name_of(locus.ends[1])});
    for (const OrbitLocusSpecial& s : locus.special)
      special.add({s.id, fmt::format("{}", locus.id), digits_text(s.at.value, 13),
                   digits_text(s.at.second, 13)});
  }
  std::string text;
  if (!loci.empty()) text += loci.text(options.width) + "\n";
  if (!special.empty()) text += special.text(options.width) + "\n";
  const auto number = [](int count, const char* of) {
    return fmt::format("{} {}{}", count, of, count == 1 ? "" : "s");
  };
  // Without slices there is one start, given.
  text +=
      (traced.slices == 0 ? "" : fmt::format("{} of the plane, ", number(traced.slices, "slice"))) +
      number(traced.starts, "special point") + " to start from\n";
  if (options.verbose)
    text += fmt::format("{} evaluations of the shooting equations\n", traced.shooting_evaluations);
  if (traced.slices > 0)
    text +=
        "note: a locus that crosses no slice and meets no other locus is not found; more --slices "
        "find more\n";
  if (record.regions && traced.loci.empty()) text += "note: no locus was met\n";
  if (record.regions) text += "\n" + regions_text(record, options);
  return text + ending(record.outcome);
}

}  // namespace graze
