#include "graze/bifurcation/bounds/component_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/bifurcation/bounds/detail/admissible_runs.hpp"
#include "graze/bifurcation/bounds/detail/closed_form_survey.hpp"
#include "graze/bifurcation/bounds/detail/speed_survey.hpp"

namespace graze {

void ComponentSearch::add(const ClosedFormSurvey& survey) {
  ++surveys;
  ranges += static_cast<int>(survey.ranges().ranges().size());
  evaluations += survey.ranges().evaluations();
  undecided += survey.ranges().undecided();
  widest = std::max(widest, survey.ranges().widest_undecided());
  samples += survey.samples();
  sample_spacing = std::max(sample_spacing, survey.spacing());
}

void ComponentSearch::add(const RunSearch& search) {
  cells += search.cells;
  undecided_cells += search.undecided;
  widest_cell = std::max(widest_cell, search.widest);
  resolution = std::max(resolution, search.resolution);
  runs_lost += search.lost;
}

void ComponentSearch::add(const SpeedSurvey& survey) {
  ++left_out;
  solved_values += survey.values - survey.unsolved;
  solved_spacing = std::max(solved_spacing, survey.spacing);
  unsolved += survey.unsolved;
}

std::string in_words(const ComponentSearch& search, const std::string& parameter, int period) {
  if (search.stopped)
    return fmt::format(
        "the search for ({}, 1) solutions was stopped before its end: connected branches may be "
        "missing",
        period);
  std::string text;
  if (search.surveys > 0) {
    text = fmt::format("the closed form of ({}, 1) solutions has {} interval{} of {}", period,
                       search.ranges == 0 ? "no" : std::to_string(search.ranges),
                       search.ranges == 1 ? "" : "s", parameter);
    if (search.undecided > 0)
      text += fmt::format(
          ", and {} place{} up to {:.3g} wide where it could not be decided whether there are more",
          search.undecided, search.undecided == 1 ? "" : "s", search.widest);
    else if (search.ranges > 0)
      text += " and no others";
    if (search.lost > 0)
      text += fmt::format("; {} of their starts could not be confirmed", search.lost);
    if (search.cells > 0 && search.undecided_cells == 0)
      text +=
          fmt::format("; along them every interval of orbits wider than {:.3g} was searched for",
                      search.resolution);
    if (search.undecided_cells > 0)
      text += fmt::format(
          "; {} place{} in them up to {:.3g} wide may hold more orbits, as the search budget was "
          "spent",
          search.undecided_cells, search.undecided_cells == 1 ? "" : "s", search.widest_cell);
    if (search.runs_lost > 0)
      text += fmt::format("; {} orbits among them could not be traced", search.runs_lost);
    if (search.samples > 0)
      text += fmt::format(
          "; orbits in them were searched for at values {:.3g} apart; orbits that exist only "
          "between two of these are missed",
          search.sample_spacing);
  }
  if (search.surveys > 0 && search.left_out == 0) return text;
  if (!text.empty()) text += "; ";
  if (search.solved_values > 0) {
    text += fmt::format(
        "where the restitution depends on the speed, ({}, 1) solutions were searched for at values "
        "of {} {:.3g} apart, by the equation for their impact speed; at {} of these values all "
        "were found",
        period, parameter, search.solved_spacing, search.solved_values);
    if (search.unsolved > 0)
      text += fmt::format("; at {} values some may be missing", search.unsolved);
    return text + ": a connected branch that lies between two of these values is missed";
  }
  text += fmt::format("({}, 1) orbits were searched for at {} value{} of {}", period,
                      search.start_values, search.start_values == 1 ? "" : "s", parameter);
  if (search.start_values > 1) text += fmt::format(", {:.3g} apart", search.start_spacing);
  if (search.random_starts > 0)
    text +=
        fmt::format(", from rounds of {} quasi-random phases with deflation", search.random_starts);
  return text + ": a connected branch that lies between two of these values is missed";
}

}  // namespace graze
