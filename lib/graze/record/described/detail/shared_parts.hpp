// Private to this room. What several results have in common.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

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

// The same of numbers; not finite beyond its end.
template <class List, class Index>
double number_at(const List& list, Index i) {
  return i < static_cast<Index>(list.size()) ? list[i] : NAN;
}
// What exists under a condition.
template <class T>
std::optional<T> only_if(bool exists, T value) {
  return exists ? std::optional(std::move(value)) : std::nullopt;
}

// How it was made and how it ended.
void describe_head(ResultVisitor& v, const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings);
// Notes of both kinds, which a document does not tell apart.
void describe_notes(ResultVisitor& v, const std::vector<std::string>& notes,
                    const std::vector<std::string>& details = {});

// What is told of impacts, multipliers and stuck phases wherever orbits are listed. The impacts are
// rows of the table "orbits", their contacts rows of "contacts".
void describe_impacts(ResultVisitor& v, const std::vector<OrbitImpact>& impacts);
void describe_multipliers(ResultVisitor& v, const Orbit& orbit);
void describe_sticking(ResultVisitor& v, const Orbit& orbit);
void describe_section(ResultVisitor& v, const Orbit& orbit);

// How large a motion is at the places and stops; null: not measured.
void describe_amplitudes(ResultVisitor& v, const std::vector<MeasuredPlace>& places,
                         const Amplitudes* measured);

// Of places and runs over parameters.
void describe_probe(ResultVisitor& v, const Probe& probe);
void describe_axis(ResultVisitor& v, const char* name, const PlaneAxis& axis,
                   const std::string& unit);
// The cells of a plane that were run, by their index; which they are where not all were.
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
