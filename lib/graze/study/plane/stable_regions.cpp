#include "graze/study/plane/stable_regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/base/progress_counter.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/plane/detail/grid_areas.hpp"

namespace graze {
namespace {

// Part of the reported progress before the rounds, whose number is not known.
constexpr double kOwnPart = 0.7;

class RegionFinder {
 public:
  RegionFinder(const Scene& scene, const std::string& first, const std::string& second,
               const StableRegionsOptions& options)
      : scene_(scene), first_(first), second_(second), options_(options) {
    // Names that the scene does not have are the caller's error, not a place's.
    for (const std::string& name : {first, second}) parameter_direction(scene, name);
    result_.columns = options.columns;
    result_.rows = options.rows;
    result_.period = options.search.period;
    result_.impacts = options.search.impacts;
    result_.cell = std::abs(options.to - options.from) / options.columns;
    result_.second_cell = std::abs(options.second_to - options.second_from) / options.rows;
    for (int row = 0; row < options.rows; ++row)
      for (int column = 0; column < options.columns; ++column) {
        RegionPlace place;
        place.value = middle(options.from, options.to, column, options.columns);
        place.second = middle(options.second_from, options.second_to, row, options.rows);
        result_.places.push_back(std::move(place));
      }
    found_.resize(result_.places.size());
    first_new_.resize(result_.places.size());
  }

  StableRegions find() {
    look_everywhere();
    // Enough rounds across the plane and back, for winding regions.
    const int most = 2 * (options_.columns + options_.rows);
    while (result_.rounds < most && !stopped()) {
      if (!hand_on_once()) {
        result_.settled = true;
        break;
      }
    }
    collect();
    return std::move(result_);
  }

 private:
  static double middle(double from, double to, int i, int count) {
    return from + (to - from) * (i + 0.5) / count;
  }

  bool stopped() const { return options_.search.stop.requested(); }

  // The scene at a place. Both values are set before any of them is judged.
  Scene scene_at(const RegionPlace& place) const {
    Scene scene = scene_;
    set_parameter(scene, first_, place.value);
    return with_parameter(scene, second_, place.second);
  }

  AttractorSearchOptions options_at(const Scene& scene, const System& system,
                                    const std::optional<State>& start) const {
    AttractorSearchOptions search = options_.search;
    const State rest{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
    // By the scene alone, so that it does not depend on handed-on attractors.
    search.closure_speed = options_.closure_speed.value_or(
        default_closure_speed(system, start.value_or(rest), scene.solver.tolerance));
    return search;
  }

  void look_everywhere() {
    ProgressCounter counter([&](double part) { tell(kOwnPart * part); }, result_.places.size());
    for_each_index(result_.places.size(), options_.threads, [&](std::size_t i) {
      if (stopped()) return;
      look(i);
      counter.add();
    });
  }

  void look(std::size_t i) {
    RegionPlace& place = result_.places[i];
    try {
      const Scene scene = scene_at(place);
      const System system = assemble(scene);
      const std::optional<State> start = clear_start(scene, system);
      AttractorSearchOptions search = options_at(scene, system, start);
      search.first_draw = i * static_cast<std::uint64_t>(search.random_starts);
      PlaceAttractors found = find_attractors(system, start, search);
      if (!found.finished) return;
      found_[i] = std::move(found);
    } catch (const InputError& error) {
      place.message = error.what();
    }
    place.finished = true;
  }

  // One round; returns whether anything could be handed on.
  bool hand_on_once() {
    std::vector<std::size_t> takers;
    std::vector<std::vector<const Attractor*>> offers(found_.size());
    for (std::size_t i = 0; i < found_.size(); ++i) {
      offers[i] = offers_to(i);
      if (!offers[i].empty()) takers.push_back(i);
    }
    if (takers.empty()) return false;
    ++result_.rounds;
    std::vector<std::optional<PlaceAttractors>> after(takers.size());
    for_each_index(takers.size(), options_.threads, [&](std::size_t k) {
      if (!stopped()) after[k] = take(takers[k], offers[takers[k]]);
    });
    for (std::size_t i = 0; i < found_.size(); ++i) first_new_[i] = found_[i].list.size();
    for (std::size_t k = 0; k < takers.size(); ++k)
      if (after[k] && after[k]->finished) found_[takers[k]] = std::move(*after[k]);
    tell(1.0 - (1.0 - kOwnPart) / (1.0 + result_.rounds));
    return true;
  }

  // What the neighbours of a place found in the last round.
  std::vector<const Attractor*> offers_to(std::size_t i) const {
    if (!is_open(i)) return {};
    std::vector<const Attractor*> offers;
    const auto columns = static_cast<std::size_t>(options_.columns);
    const std::size_t column = i % columns;
    const auto take_from = [&](std::size_t other) {
      for (std::size_t k = first_new_[other]; k < found_[other].list.size(); ++k)
        offers.push_back(&found_[other].list[k]);
    };
    if (column > 0) take_from(i - 1);
    if (column + 1 < columns) take_from(i + 1);
    if (i >= columns) take_from(i - columns);
    if (i + columns < found_.size()) take_from(i + columns);
    return offers;
  }

  // Whether the scene allows the place, and it was searched.
  bool is_open(std::size_t i) const {
    return result_.places[i].finished && result_.places[i].message.empty();
  }

  PlaceAttractors take(std::size_t i, const std::vector<const Attractor*>& offers) const {
    const Scene scene = scene_at(result_.places[i]);
    const System system = assemble(scene);
    const AttractorSearchOptions search = options_at(scene, system, clear_start(scene, system));
    return hand_on(system, found_[i], offers, search);
  }

  void tell(double fraction) const {
    if (options_.progress) options_.progress(fraction);
  }

  void collect() {
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const PlaceAttractors& found = found_[i];
      RegionPlace& place = result_.places[i];
      result_.finished += place.finished ? 1 : 0;
      for (const Attractor& attractor : found.list) place.stable.push_back(attractor.name);
      std::sort(place.stable.begin(), place.stable.end());
      place.stable.erase(std::unique(place.stable.begin(), place.stable.end()), place.stable.end());
      if (!found.message.empty()) place.message = found.message;
      if (place.finished && place.stable.empty() && place.message.empty())
        place.message = "the motion cannot start as the scene says, and nothing else was found";
      result_.confirmed += found.confirmed;
      result_.undecided += found.undecided;
      result_.searched += found.searched > 0 ? 1 : 0;
      result_.simulated += found.simulated;
      add_at(i, found.refuted, result_.refuted);
      add_at(i, found.missed, result_.missed);
    }
    outline();
    const auto all = static_cast<long long>(result_.places.size());
    if (result_.finished < all || !result_.settled) result_.stopped = options_.search.stop.reason();
  }

  static void add_at(std::size_t place, const std::vector<Orbit>& orbits,
                     std::vector<OrbitAtPlace>& list) {
    for (const Orbit& orbit : orbits)
      list.push_back(
          {place, {AttractorKind::kOrbit, orbit.period, static_cast<int>(orbit.impacts.size())}});
  }

  void outline() {
    std::map<StableNames, int> numbers;
    std::vector<int> keys;
    for (const RegionPlace& place : result_.places) {
      const int next = static_cast<int>(numbers.size());
      keys.push_back(place.finished ? numbers.emplace(place.stable, next).first->second : -1);
    }
    const GridAreas grid = grid_areas(keys, options_.columns);
    for (const GridArea& area : grid.areas)
      result_.areas.push_back({result_.places[area.innermost].stable, area.cells,
                               static_cast<double>(area.cells) / static_cast<double>(keys.size()),
                               area.innermost});
    for (std::size_t i = 0; i < keys.size(); ++i) result_.places[i].area = grid.area_of[i];
  }

  const Scene& scene_;
  const std::string &first_, &second_;
  const StableRegionsOptions& options_;
  StableRegions result_;
  std::vector<PlaceAttractors> found_;  // at each place
  std::vector<std::size_t> first_new_;  // start of the attractors that the last round added to each
                                        // list
};

}  // namespace

std::string label_of(const StableNames& names) {
  std::string label;
  for (const MotionName& name : names) label += (label.empty() ? "" : " + ") + name_of(name);
  return label;
}

StableRegions find_stable_regions(const Scene& scene, const std::string& first,
                                  const std::string& second, const StableRegionsOptions& options) {
  return RegionFinder(scene, first, second, options).find();
}

}  // namespace graze
