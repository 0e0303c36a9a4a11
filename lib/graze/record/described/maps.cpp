#include <algorithm>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/record/names/plane_names.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

constexpr Field::Use kTables = Field::Use::kTables;

void describe_attractors(ResultVisitor& v, const AttractorMap& map) {
  v.list({"attractors", "", "those with the most cells first"}, map.attractors,
         [&](const MapAttractor& one, std::size_t i) {
           const AttractorClass& attractor = one.attractor;
           const bool repeats = attractor.period > 0;
           const bool sticks = attractor.kind == SettledKind::kSticks;
           v.field({"id", "", "from 1"}, i + 1);
           v.field({"attractor", "", "`(1,1)`, or `(1,1) b` of the second that does the same"},
                   i < map.attractors.size() ? attractor_name(map, i) : "");
           v.field({"period", "", "forcing periods; null where nothing repeats"},
                   only_if(repeats, attractor.period));
           v.field({"impacts", "", "in a repetition; null where it sticks"},
                   only_if(repeats && !sticks, attractor.impacts));
           v.field({"sticks"}, sticks);
           v.field({"cells", "", "how many"}, one.cells);
           v.field({"first", "", "cell: its two numbers"},
                   NumberPair(map.options.x_at(one.first), map.options.y_at(one.first)));
         });
}

void describe_cell(ResultVisitor& v, const MapRecord& record, const MapCell& cell,
                   std::size_t index) {
  const AttractorClass& attractor = cell.attractor;
  const bool repeats = attractor.period > 0;
  v.field(Field{"x"}.tabular(), record.map.options.x_at(index));
  v.field(Field{"y"}.tabular(), record.map.options.y_at(index));
  v.field({"status"}, name_of(attractor.status));
  v.field({"attractor", "", "its id"}, only_if(cell.place >= 0, cell.place + 1));
  v.field(Field{"period"}.tabular(), only_if(repeats, attractor.period));
  v.field(Field{"impacts", "", "in a repetition"}.tabular(),
          only_if(repeats && attractor.kind != SettledKind::kSticks, attractor.impacts));
  v.field({"impacts_per_period"}, cell_value(cell, MapQuantity::kImpacts));
  v.field({"peak_speed", "m/s", "of its impacts"}, cell_value(cell, MapQuantity::kSpeed));
  v.field({"stuck_part", "", "of the time"}, cell_value(cell, MapQuantity::kStuck));
  v.field(Field{"exponent", "1/s", "the largest"}.tabular(), cell.exponent);
  if (record.map.options.exponent_periods > 0)
    v.field(Field{"exponent", "1/s", "the largest, with `--exponents`"}.document(), cell.exponent);
  if (!record.places.empty())
    v.only(kTables, [&] {
      describe_amplitudes(v, record.places, cell.amplitudes ? &*cell.amplitudes : nullptr);
    });
}

// For every place the quantities that are shown there, with a list of the cells for each.
void describe_measured(ResultVisitor& v, const MapRecord& record,
                       const std::vector<std::size_t>& known) {
  v.list({"amplitudes", "", "at every place, lists of the cells"}, record.places,
         [&](const MeasuredPlace& place, std::size_t i) {
           v.field({place.stop ? "stop" : "probe", "", "from 1"},
                   place.stop.value_or(place.probe.value_or(0)) + 1);
           for (const ShownQuantity quantity : kShownQuantities) {
             if (is_of_stop(quantity) && !place.stop) continue;
             std::string name = name_of(quantity);
             std::replace(name.begin(), name.end(), '-', '_');
             v.values({name}, known, [&](std::size_t at) -> std::optional<double> {
               const MapCell& cell = record.map.cells[at];
               if (!cell.amplitudes) return {};
               return shown_value({quantity, i}, record.places, *cell.amplitudes);
             });
           }
         });
}

void describe_difference(ResultVisitor& v, const MotionDifference& difference, bool exists) {
  for (const ComparedQuantity quantity : kComparedQuantities) {
    const std::string name = name_of(quantity), what = title_of(quantity);
    const auto value = only_if(exists, compared_value(difference, quantity));
    if (quantity == ComparedQuantity::kAttractor) {
      v.field(Field{name, "", "whether both settle on the same"}.document(),
              only_if(exists, difference.is_same_attractor));
      v.field(Field{name, "", "1: the same"}.tabular(), value);
    } else {
      v.field({name, "", what}, value);
    }
  }
}

void describe_motion(ResultVisitor& v, const std::string& name, const ComparedMotion& motion) {
  v.field(Field{"name", "", "of the scene"}.in("first_impacts"), name);
  v.field(Field{"status"}.document(), name_of(motion.attractor.status));
  v.field(Field{"attractor", "", "that it settles on"}.as("settles_on"),
          attractor_label(motion.attractor));
  v.field(Field{"energy", "J", "its mean"}.as("mean_energy"), motion.energy);
  v.field(Field{"taken", "J", "by the stops in a forcing period"}.as("taken_by_stops"),
          motion.taken);
}

void describe_first(ResultVisitor& v, const ComparedMotion& motion) {
  v.list({"first_impacts", "", "from the start on"}, motion.first,
         [&](const RunImpact& impact, std::size_t k) {
           v.row("first_impacts", [&] {
             v.field(Field{"impact", "", "its number"}.tabular(), k + 1);
             v.field({"time", "s"}, impact.time);
             v.field({"stop", "", "from 1"}, impact.stop + 1);
             v.field({"speed", "m/s", "of approach"}, impact.speed);
           });
         });
  v.field({"message", "", "where there is something to say"}, motion.message);
}

}  // namespace

void describe(ResultVisitor& v, const MapRecord& record) {
  const AttractorMap& map = record.map;
  describe_head(v, record.info, record.outcome, record.warnings);
  describe_axis(v, "x", map.options.x, record.x_unit);
  describe_axis(v, "y", map.options.y, record.y_unit);
  v.field({"nearness", "", "of repetitions, relative"}, map.options.nearness);
  describe_attractors(v, map);
  v.part({"cells", "", "lists of all that were run, row by row"}, [&] {
    const std::vector<std::size_t> known = describe_known(v, map.cells);
    v.columns({}, known, [&](std::size_t i, std::size_t) {
      const MapCell* cell = entry(map.cells, i);
      v.row("map", [&] { describe_cell(v, record, cell ? *cell : MapCell{}, i); });
    });
    if (!record.places.empty()) describe_measured(v, record, known);
  });
  if (record.loci) describe_loci(v, *record.loci);
}

void describe(ResultVisitor& v, const ComparisonRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"within", "", "of a forcing period, of a speed: so near impacts agree"},
          record.options.within);
  v.list({"motions", "", "side by side"}, record.motions,
         [&](const ComparedMotion& motion, std::size_t i) {
           const std::string* name = entry(record.names, i);
           const MotionDifference* from = i > 0 ? entry(record.differences, i - 1) : nullptr;
           v.row("comparison", [&] {
             describe_motion(v, name ? *name : "", motion);
             v.only(kTables,
                    [&] { describe_difference(v, from ? *from : MotionDifference{}, from); });
           });
           describe_first(v, motion);
         });
  v.list({"differences", "", "of each motion but the first from the one before"},
         record.differences, [&](const MotionDifference& difference, std::size_t) {
           v.field({"first", "", "of so many first impacts"}, difference.first);
           describe_difference(v, difference, true);
         });
}

void describe(ResultVisitor& v, const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"one", "", "scene"}, record.one);
  v.field({"other"}, record.other);
  v.field({"within", "", "of a forcing period, of a speed: so near impacts agree"},
          map.options.within);
  describe_axis(v, "x", map.options.x, record.x_unit);
  describe_axis(v, "y", map.options.y, record.y_unit);
  v.part({"cells", "", "lists of all that were run, row by row"}, [&] {
    v.columns({}, describe_known(v, map.cells), [&](std::size_t i, std::size_t) {
      const ComparedCell* at = entry(map.cells, i);
      const ComparedCell& cell = at ? *at : ComparedCell{};
      v.row("comparison", [&] {
        v.field(Field{"x"}.tabular(), map.options.x_at(i));
        v.field(Field{"y"}.tabular(), map.options.y_at(i));
        v.field({"one", "", "what it settles on"}, attractor_label(cell.one));
        v.field({"other"}, attractor_label(cell.other));
        v.field(Field{"message"}.document(), named(cell.message));
        describe_difference(v, cell.difference, is_comparable(cell));
      });
    });
  });
}

}  // namespace graze
