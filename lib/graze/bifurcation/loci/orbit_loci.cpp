#include "graze/bifurcation/loci/orbit_loci.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <memory>
#include <utility>

#include "graze/base/parallel.hpp"
#include "graze/bifurcation/loci/detail/grazing_places.hpp"

#include "graze/bifurcation/loci/detail/locus_tracer.hpp"
#include "graze/bifurcation/problem/option_faults.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

std::optional<OrbitLocusKind> locus_kind(SpecialKind kind) {
  switch (kind) {
    case SpecialKind::kFold:
      return OrbitLocusKind::kFold;
    case SpecialKind::kPeriodDoubling:
      return OrbitLocusKind::kPeriodDoubling;
    case SpecialKind::kTorus:
      return OrbitLocusKind::kTorus;
    case SpecialKind::kGrazing:
      return OrbitLocusKind::kGrazing;
    case SpecialKind::kChatterCompletes:
      return OrbitLocusKind::kChatterCompletes;
    case SpecialKind::kLevel:
      return OrbitLocusKind::kLevel;
    case SpecialKind::kExtreme:
      return OrbitLocusKind::kExtreme;
    case SpecialKind::kBranchPoint:
    case SpecialKind::kLiftOff:
    case SpecialKind::kGrazingSliding:
    case SpecialKind::kCrossingSliding:
    case SpecialKind::kSwitchingSliding:
    case SpecialKind::kAddingSliding:
      break;
  }
  return {};
}

// Places in the plane nearer than this, in ranges of the parameters, are the same: where loci meet,
// their equations are singular and solutions have errors of about the square root of rounding.
constexpr double kOnePlace = 1e-7;

LocusOptions options_of(const LociOptions& options) {
  LocusOptions range;
  range.first_from = options.branches.from;
  range.first_to = options.branches.to;
  range.second_from = options.second_from;
  range.second_to = options.second_to;
  if (options.branches.max_step > 0.0)
    range.max_step = options.branches.max_step / first_range(range);
  range.stop = options.branches.stop;
  return range;
}

class LociTracer {
 public:
  LociTracer(const Scene& scene, const std::string& first, const std::string& second,
             const LociOptions& options)
      : scene_(scene),
        options_(options),
        own_(scene, first),
        other_(scene, second),
        systems_(scene, {first, second}),
        range_(options_of(options)),
        segment_{0.0, options.branches.finder.max_impacts, options.branches.stop},
        tracer_(scene, first, second, range_, segment_, options.branches) {
    if (are_same_parameter(first, second))
      throw InputError(first + ": a locus takes two parameters that differ from one another");
    if (const auto fault = fault_in(options.branches)) throw InputError(fault->text());
    if (options.second_from == options.second_to)
      throw InputError("second_from, second_to: the range must not be empty");
    result_.first = first;
    result_.second = second;
    result_.levels = names_of(options.branches.levels);
  }

  OrbitLoci trace() {
    if (options_.start)
      begin(*options_.start);
    else
      trace_slices();
    number();
    result_.stopped = options_.branches.stop.reason();
    return std::move(result_);
  }

 private:
  void trace_slices() {
    const std::vector<double> seconds =
        values(other_.value(), options_.second_from, options_.second_to);
    const std::vector<double> firsts =
        values(own_.value(), options_.branches.from, options_.branches.to);
    const double all = static_cast<double>(seconds.size() + firsts.size());
    for (const double second : seconds) {
      tell(all);
      slice(result_.second, second, result_.first, options_.branches.from, options_.branches.to);
    }
    for (const double first : firsts) {
      tell(all);
      slice(result_.first, first, result_.second, options_.second_from, options_.second_to);
    }
  }

  // The scene's own value where it is in the range, and the midpoints of equal parts of the range.
  std::vector<double> values(double own, double from, double to) const {
    std::vector<double> list;
    if (own >= std::min(from, to) && own <= std::max(from, to)) list.push_back(own);
    for (int i = 0; i < options_.slices; ++i)
      list.push_back(from + (to - from) * (i + 0.5) / options_.slices);
    return list;
  }

  // Numbers loci, and the special points of each kind, from 1.
  void number() {
    std::map<std::string, int> counts;
    int id = 0;
    for (OrbitLocus& locus : result_.loci) {
      locus.id = ++id;
      for (OrbitLocusSpecial& special : locus.special)
        special.id = special.label + "-" + std::to_string(++counts[special.label]);
    }
  }

  void tell(double all) {
    if (options_.branches.progress) options_.branches.progress(result_.slices / all);
  }

  // Starts loci from the branches over one parameter at a fixed value of the other.
  void slice(const std::string& fixed, double value, const std::string& parameter, double from,
             double to) {
    if (options_.branches.stop.requested()) return;
    std::optional<SystemFamily> family;
    try {
      family.emplace(with_parameter(scene_, fixed, value), parameter);
    } catch (const InputError&) {
      return;  // the scene does not allow it
    }
    BranchOptions branches = options_.branches;
    branches.normal_forms = false;
    branches.from = from;
    branches.to = to;
    if (parameter != result_.first) branches.max_step = 0.0;
    branches.progress = nullptr;
    // Random guesses cost more than all else: they are made on the first slice only, at the scene's
    // own value where that is in the ranges.
    branches.finder.from_random = branches.finder.from_random && result_.slices == 0;
    ++result_.slices;
    const OrbitBranches traced = trace_orbits(*family, branches);
    result_.shooting_evaluations += traced.shooting_evaluations;
    result_.traces_cut_short += traced.cut_short;
    for (const OrbitBranch& branch : traced.branches)
      for (const SpecialPoint& special : branch.special)
        if (const auto start = start_of(*family, special, value)) begin(*start);
  }

  std::optional<OrbitLocusStart> start_of(const SystemFamily& family, const SpecialPoint& special,
                                          double fixed) const {
    const std::optional<OrbitLocusKind> kind = locus_kind(special.kind);
    if (!kind || special.by_push || special.interrupted || !wants(*kind)) return {};
    const double moved = special.at.value;
    const bool over_first = family.parameter() == result_.first;
    const LocusStartPlace place{over_first ? moved : fixed, over_first ? fixed : moved,
                                special.multiplier.value_or(1.0)};
    const Orbit& orbit = special.at.orbit;
    // Along a branch over the second parameter other orbits are extreme.
    if (*kind == OrbitLocusKind::kExtreme && !over_first) return {};
    if (!orbit.meets_stops())
      return OrbitLocusStart{*kind, {}, place.first, place.second, 1.0, {}, special.level};
    if (orbit.section)
      return OrbitLocusStart{*kind, {},           place.first, place.second, place.multiplier,
                             orbit, special.level};
    std::optional<OrbitLocusStart> start = locus_start(
        *family.at(moved), *kind, {orbit.pattern(), orbit.points(), 0}, special.by_speed, place);
    if (start) start->level = special.level;
    return start;
  }

  bool wants(OrbitLocusKind kind) const {
    return std::find(options_.kinds.begin(), options_.kinds.end(), kind) != options_.kinds.end();
  }

  // Traces the locus of a start, and those that meet it. Loci of several starts in a row are traced
  // at once; a trace that an earlier one has made superfluous is dropped, so that the number of
  // threads does not change the result.
  void begin(const OrbitLocusStart& start) {
    std::deque<OrbitLocusStart> starts{start};
    while (!starts.empty() && !options_.branches.stop.requested()) {
      const std::vector<OrbitLocusStart> some = next_unknown(starts);
      std::vector<LocusAnswer> answers = trace_at_once(some);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (i > 0 && tracer_.knows(some[i])) continue;
        const std::size_t known = result_.loci.size();
        add(some[i], std::move(answers[i]));
        for (std::size_t k = known; k < result_.loci.size(); ++k)
          for (const OrbitLocusSpecial& special : result_.loci[k].special)
            add_continuations(result_.loci[k], special, starts);
      }
    }
  }

  // Takes starts from the front until as many of them as there are threads lead to no known locus.
  std::vector<OrbitLocusStart> next_unknown(std::deque<OrbitLocusStart>& starts) {
    std::vector<OrbitLocusStart> some;
    const auto most = static_cast<std::size_t>(thread_count(options_.branches.finder.threads));
    while (!starts.empty() && some.size() < most && !options_.branches.stop.requested()) {
      ++result_.starts;
      if (!tracer_.knows(starts.front())) some.push_back(std::move(starts.front()));
      starts.pop_front();
    }
    return some;
  }

  std::vector<LocusAnswer> trace_at_once(const std::vector<OrbitLocusStart>& starts) {
    std::vector<LocusAnswer> answers(starts.size());
    while (beside_.size() + 1 < starts.size())
      beside_.emplace_back(scene_, result_.first, result_.second, range_, segment_,
                           options_.branches);
    for_each_index(starts.size(), options_.branches.finder.threads, [&](std::size_t i) {
      LocusTracer& tracer = i == 0 ? tracer_ : beside_[i - 1];
      if (i > 0) tracer.set_closure_speed(tracer_.closure_speed());
      answers[i] = tracer.trace(starts[i]);
    });
    return answers;
  }

  void add_continuations(const OrbitLocus& locus, const OrbitLocusSpecial& special,
                         std::deque<OrbitLocusStart>& starts) {
    // Continuations are not implemented for orbits that are followed.
    if (special.at.section || (!special.at.admissible && !options_.branches.keep_virtual)) return;
    const System* system = systems_.at(std::array{special.at.value, special.at.second});
    if (!system) return;
    for (OrbitLocusStart& start : continuations_from(*system, locus, special, tracer_.speed_unit()))
      if (wants(start.kind)) starts.push_back(std::move(start));
  }

  void add(const OrbitLocusStart& start, LocusAnswer answer) {
    result_.shooting_evaluations += answer.evaluations;
    if (!answer.trace || answer.trace->places.empty()) {
      ++result_.lost_starts;
      return tracer_.know(start, std::move(answer));
    }
    for (OrbitLocus& part : locus_parts(*answer.trace, options_.branches.keep_virtual)) {
      if (is_a_point(part)) continue;
      if (is_cut_short(part)) ++result_.cut_short;
      result_.loci.push_back(std::move(part));
    }
    tracer_.know(start, std::move(answer));
  }

  // A trace started where several loci meet may stay near that point; one that was stopped may have
  // only begun.
  bool is_a_point(const OrbitLocus& locus) const {
    const OrbitLocusPoint& first = locus.points.front();
    if (std::ranges::any_of(locus.ends, [](OrbitLocusEnd end) {
          return end == OrbitLocusEnd::kOutOfTime || end == OrbitLocusEnd::kStopped;
        }))
      return false;
    return std::all_of(locus.points.begin(), locus.points.end(), [&](const OrbitLocusPoint& point) {
      return distance(point, first, range_) <= kOnePlace;
    });
  }

  const Scene& scene_;
  const LociOptions& options_;
  SystemFamily own_, other_;
  SystemCursor systems_;
  LocusOptions range_;
  SegmentOptions segment_;
  LocusTracer tracer_;              // knows what has been traced
  std::deque<LocusTracer> beside_;  // each traces on a thread of its own
  OrbitLoci result_;
};

}  // namespace

OrbitLoci trace_loci(const Scene& scene, const std::string& first, const std::string& second,
                     const LociOptions& options) {
  return LociTracer(scene, first, second, options).trace();
}

}  // namespace graze
