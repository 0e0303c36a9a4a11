// Private to this room: parts that several results have in common.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graze/motion/amplitudes.hpp"
#include "graze/record/described/detail/result_visitor.hpp"
#include "graze/record/records.hpp"
#include "graze/study/plane/plane.hpp"

namespace graze {

struct OrbitLoci;

// An entry of a list that may be shorter; null beyond its end.
template <class List>
auto entry(const List& list, std::size_t i) -> decltype(&list[i]) {
  return i < list.size() ? &list[i] : nullptr;
}

// The name of a level, where there is one.
inline std::optional<std::string_view> named_level(const std::vector<std::string>& levels,
                                                   bool is_level, std::size_t which) {
  return is_level && which < levels.size() ? named(levels[which]) : std::nullopt;
}

// The same of numbers; not finite beyond its end.
template <class List, class Index>
double number_at(const List& list, Index i) {
  return i < static_cast<Index>(list.size()) ? list[i] : NAN;
}
// A value that exists under a condition.
template <class T>
std::optional<T> only_if(bool exists, T value) {
  return exists ? std::optional(std::move(value)) : std::nullopt;
}

// How the result was made and how it ended.
void describe_head(ResultVisitor& v, const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings);
// Notes of both kinds, which a document puts into one list.
void describe_notes(ResultVisitor& v, const std::vector<std::string>& notes,
                    const std::vector<std::string>& details = {});

// Impacts, multipliers and stuck phases of orbits, wherever these are listed. The impacts are rows
// of the table "orbits", their contacts rows of "contacts".
void describe_impacts(ResultVisitor& v, const std::vector<OrbitImpact>& impacts);
void describe_multipliers(ResultVisitor& v, const Orbit& orbit);
void describe_sticking(ResultVisitor& v, const Orbit& orbit);
void describe_section(ResultVisitor& v, const Orbit& orbit);

// Amplitudes of a motion at the places and stops; null: not measured.
void describe_amplitudes(ResultVisitor& v, const std::vector<MeasuredPlace>& places,
                         const Amplitudes* measured);

// Statistics of a run that has them.
void describe_statistics(ResultVisitor& v, const SimulationRecord& record);

// Probes, and axes of maps.
void describe_probe(ResultVisitor& v, const Probe& probe);
void describe_axis(ResultVisitor& v, const char* name, const PlaneAxis& axis,
                   const std::string& unit);
// The cells of a plane that were run, by their index; describes which they are unless all were run.
template <class Cell>
std::vector<std::size_t> describe_known(ResultVisitor& v, const std::vector<Cell>& cells) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i].is_known) known.push_back(i);
  if (const auto some = v.where(known.size() < cells.size(), "where not all were run"))
    v.values({"index", "", "from 0, row by row"}, known);
  return known;
}
void describe_loci(ResultVisitor& v, const OrbitLoci& traced);

}  // namespace graze
