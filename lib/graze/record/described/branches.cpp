#include <algorithm>

#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/names/motion_names.hpp"

namespace graze {
namespace {

// The shortest contact that has a duration, s.
std::optional<double> shortest_contact(const Orbit& orbit) {
  std::optional<double> shortest;
  for (const OrbitImpact& impact : orbit.impacts) {
    const double duration = held(impact.contact).duration;
    if (duration > 0.0) shortest = std::min(duration, shortest.value_or(duration));
  }
  return shortest;
}

void describe_point(ResultVisitor& v, const OrbitBranchPoint& point, bool compliant) {
  const Orbit& orbit = point.orbit;
  // An orbit at rest on its stop has none.
  const OrbitImpact* first = entry(orbit.impacts, 0);
  v.field(Field{"impacts", "", "resolved"}.tabular(), orbit.impacts.size());
  v.field({"value", "", "of the parameter"}, point.value);
  v.field({"phase", "rad", "of the first impact"},
          first ? std::optional(first->phase) : std::nullopt);
  v.field({"speed", "m/s", "of its approach"}, first ? std::optional(first->speed) : std::nullopt);
  v.field({"stable", "", "null: a multiplier is on the unit circle"}, orbit.stable);
  v.field({"admissible", "", "no stop is penetrated"}, orbit.admissible);
  v.field({"unstable_multipliers", "", "how many outside the unit circle"},
          point.unstable_multipliers);
  v.field({"clearance", "m", "smallest interior local minimum of a gap between the impacts"},
          orbit.clearance);
  if (orbit.lasts) v.field({"lasts", "s", "period of a self-excited orbit"}, orbit.lasts);
  if (compliant)
    v.field({"shortest_contact", "s", "of its contacts, on compliant stops"},
            shortest_contact(orbit));
  if (const auto some = v.where(orbit.impacts.size() > 1, "with several impacts"))
    describe_impacts(v, orbit.impacts);
  v.field({"stuck", "", "whether the orbit sticks"}, orbit.sticks());
  const auto some = v.where(orbit.sticks(), "where the orbit sticks");
  if (!some) return;
  v.field(Field{"impacts", "", "resolved"}.document(), orbit.impacts.size());
  describe_multipliers(v, orbit);
  describe_sticking(v, orbit);
}

const char* way_of_grazing(const SpecialPoint& special) {
  if (special.by_push) return "departure is pushed back";
  return special.by_speed ? "impact speed vanishes" : "interior approach touches";
}

void describe_special(ResultVisitor& v, const SpecialPoint& special, int branch,
                      const OrbitBranches& traced) {
  const std::vector<std::string>& levels = traced.levels;
  const std::optional<SpecialPoint::Impact> impact = special.impact();
  v.field({"id", "", "`LP1`, .."}, special.id);
  v.field({"label", "", "`LP`, `GR`, .."}, label_of(special.kind));
  v.field(Field{"branch", "", "its id"}.tabular(), branch);
  v.field({"value", "", "of the parameter"}, special.at.value);
  v.field({"phase", "rad", "of the first impact"},
          impact ? std::optional(impact->phase) : std::nullopt);
  v.field({"speed", "m/s", "of its approach"},
          impact ? std::optional(impact->speed) : std::nullopt);
  v.field(Field{"multiplier", "", "the critical one, as [re, im]; null at GR"}.as(
              "multiplier_re,multiplier_im"),
          special.multiplier);
  if (!levels.empty())
    v.field({"level", "", "at UZ and EX the one that was asked for, `stop.1.speed=0.5`; else null"},
            named_level(levels, is_of_level(special.kind), special.level));
  if (traced.has_normal_forms) {
    v.field({"coefficient", "",
             "of the normal form at LP, PD and NS; supercritical at PD > 0, at NS < 0"},
            special.normal ? std::optional(special.normal->coefficient) : std::nullopt);
    v.field({"opening", "",
             "the orbits beside it (PD: the doubled ones, NS: the torus) lie at `value` + "
             "`opening` x^2, "
             "x along the critical eigenvector"},
            special.normal ? std::optional(special.normal->opening) : std::nullopt);
    const std::string words = words_beyond(special);
    v.field({"beyond", "", "the same in words"}, named(words));
  }
  v.field(Field{"admissible"}.document(), special.at.orbit.admissible);
  const std::optional<Bracket>& bracket = special.solution.bracket;
  if (const auto some = v.where(bracket.has_value(), "where it was enclosed")) {
    v.field(Field{"bracket", "", "two values between which it lies"}.as("bracket_from,bracket_to"),
            NumberPair(held(bracket).from, held(bracket).to));
    v.field({"converged", "",
             "solved for, or enclosed, to the last digits; else the bracket is all that is known"},
            held(bracket).converged);
  }
  if (const auto some = v.where(special.at.orbit.impacts.size() > 1, "with several impacts"))
    describe_impacts(v, special.at.orbit.impacts);
  describe_sticking(v, special.at.orbit);
  if (const auto some = v.where(special.kind == SpecialKind::kChatterCompletes, "at CH"))
    v.field(Field{"chatter", "", "`completes at its release` or `a stuck phase is cut in two`"}
                .document(),
            special.interrupted ? "a stuck phase is cut in two" : "completes at its release");
  if (const auto some = v.where(special.kind == SpecialKind::kGrazing, "at GR"))
    v.field(Field{"grazing", "",
                  "`impact speed vanishes`, `interior approach touches` or `departure is pushed "
                  "back`"}
                .document(),
            way_of_grazing(special));
}

using Measured = BranchAmplitudes::Measured;

void describe_branch(ResultVisitor& v, const OrbitBranch& branch, const BranchRecord& record,
                     const Measured* measured) {
  v.field(Field{"id", "", "from 1"}.as("branch").in("branches"), branch.id);
  v.field(Field{"component", "", "number of the connected branch"}.in("branches"),
          branch.component);
  v.field(Field{"period", "", "p"}.in("branches"), branch.pattern.period);
  v.field({"impacts", "", "k; null of orbits that stick"},
          branch.sticks() ? std::nullopt : std::optional(branch.pattern.impacts()));
  v.values({"stops", "", "of the impacts, or those that are closed, in order"},
           branch.sticks() ? branch.sticking : branch.pattern.stops,
           [](int stop) { return stop + 1; });
  v.field({"stuck"}, branch.sticks());
  v.field({"origin", "", "special point at which it was reached by switching; null of a first one"},
          named(branch.origin));
  v.values({"ends", "", "two"}, branch.ends, [](OrbitBranchEnd end) { return name_of(end); });
  // Without requested amplitudes a record has no places.
  const std::vector<MeasuredPlace>& places = record.amplitudes.places;
  const auto describe_size = [&](const std::vector<Amplitudes>* of, std::size_t i) {
    if (!places.empty()) describe_amplitudes(v, places, of ? entry(*of, i) : nullptr);
  };
  const std::vector<Stop>& stops = record.system.stops;
  const bool compliant =
      std::any_of(stops.begin(), stops.end(), [](const Stop& stop) { return stop.is_compliant(); });
  v.list({"points", "", "along the branch"}, branch.points,
         [&](const OrbitBranchPoint& point, std::size_t i) {
           v.row("branches", [&] {
             describe_point(v, point, compliant);
             describe_size(measured ? &measured->points : nullptr, i);
           });
         });
  v.list({"special", "", "special points"}, branch.special,
         [&](const SpecialPoint& special, std::size_t i) {
           v.row("special", [&] { describe_special(v, special, branch.id, record.traced); });
           describe_size(measured ? &measured->special : nullptr, i);
         });
}

void describe_counters(ResultVisitor& v, const OrbitBranches& traced) {
  v.part({"counters", "", "of what was done"}, [&] {
    v.field({"starts"}, traced.starts);
    v.field({"virtual_starts", "", "among them, not traced"}, traced.virtual_starts);
    v.field({"surveyed_values", "", "at or around which the closed form was evaluated"},
            traced.sought.evaluations + traced.sought.samples);
    v.field({"traces", "", "begun"}, traced.traced);
    v.field({"traces_cut_short", "", "not followed to an end"}, traced.cut_short);
    v.field({"shooting_evaluations"}, traced.shooting_evaluations);
    v.field({"rejected_steps"}, traced.rejected_steps);
    v.field({"switched", "", "special points switched at"}, traced.switched);
    v.field({"left_open", "", "special points beyond the depth"}, traced.left_open);
  });
}

void describe_search(ResultVisitor& v, const ComponentSearch& search) {
  const auto width = [](double size) { return size > 0.0 ? std::optional(size) : std::nullopt; };
  v.part(
      {"search", "",
       "how connected branches of (p, 1) solutions were searched for; widths in the parameter"},
      [&] {
        v.field({"complete", "", "none was missed that is wider than `resolution`"},
                search.complete());
        v.field({"intervals", "", "with solutions of the closed form"},
                search.surveys > 0 ? std::optional(search.ranges) : std::nullopt);
        v.field({"evaluations", "", "of its fold function"}, search.evaluations);
        v.field({"undecided", "", "places where a budget was spent"}, search.undecided);
        v.field({"widest_undecided"}, width(search.widest));
        v.field({"starts_lost", "", "that Newton's method did not confirm"}, search.lost);
        v.field({"cells", "", "examined for intervals of orbits"}, search.cells);
        v.field({"undecided_cells"}, search.undecided_cells);
        v.field({"widest_undecided_cell"}, width(search.widest_cell));
        v.field({"resolution"}, width(search.resolution));
        v.field({"runs_lost", "", "that could not be traced"}, search.runs_lost);
        v.field({"judged_values", "", "where bounds do not hold"}, search.samples);
        v.field({"judged_spacing"}, width(search.sample_spacing));
        v.field({"solved_values", "", "at which every solution is known"}, search.solved_values);
        v.field({"solved_spacing"}, width(search.solved_spacing));
        v.field({"unsolved_values", "", "at which some may be missing"}, search.unsolved);
        v.field({"start_values", "", "at which the finder looked for orbits"}, search.start_values);
        v.field({"start_spacing"}, width(search.start_spacing));
        v.field({"random_starts", "", "in each of its rounds"}, search.random_starts);
      });
}

}  // namespace

void describe(ResultVisitor& v, const BranchRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"parameter", "", "its name; the unit of its values is `units.value`"},
          record.traced.parameter);
  v.unit("value", record.unit);
  const BranchAmplitudes& measured = record.amplitudes;
  v.list({"branches", "", "of orbits"}, record.traced.branches,
         [&](const OrbitBranch& branch, std::size_t i) {
           describe_branch(v, branch, record, entry(measured.branches, i));
         });
  v.list({"loci", "", "with `--locus`"}, std::vector<OrbitBranch>(),
         [](const OrbitBranch&, std::size_t) {});
  describe_counters(v, record.traced);
  describe_search(v, record.traced.sought);
  describe_notes(v, record.traced.notes, record.traced.details);
}

}  // namespace graze
