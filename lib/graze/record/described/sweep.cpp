#include <fmt/format.h>

#include <cmath>
#include <ranges>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

constexpr Field::Use kDocument = Field::Use::kDocument, kTables = Field::Use::kTables;

void describe_attractor(ResultVisitor& v, const SweepRow& row) {
  const AttractorClass attractor = attractor_class(row);
  const bool repeats = attractor.period > 0, sticks = attractor.kind == SettledKind::kSticks;
  v.field(Field{"value", "", "of the parameter"}.in("sweep"), row.value);
  v.field(Field{"start", "", "from what: `scene`, `handed on`, .."}.in("sweep"),
          name_of(row.start));
  v.field(Field{"status"}.in("sweep"), name_of(row.status));
  v.field(Field{"attractor", "", "`(2,1)`, `clear`, `chaos`, .."}.document(),
          attractor_label(attractor));
  v.field(Field{"attractor", "", "`impacts`, `sticking`, `clear`, .."}.in("sweep").tabular(),
          attractor_kind(attractor));
  v.field(Field{"period", "", "forcing periods; null where nothing repeats"}.in("sweep"),
          only_if(repeats, attractor.period));
  v.field(Field{"impacts", "", "in a repetition; null where it sticks"}.in("sweep"),
          only_if(repeats && !sticks, attractor.impacts));
  v.field({"sticks"}, row.motion.sticks);
  v.field(Field{"periods", "", "forcing periods run"}.in("sweep"), row.motion.periods);
  v.field(Field{"remaining", "1", "distance to the repetition, relative"}.in("sweep"),
          repeats ? row.motion.remaining : NAN);
  if (const auto some = v.where(!row.message.empty(), "where there is something to say"))
    v.field({"message"}, row.message);
}

void describe_exponents(ResultVisitor& v, const SweepRow& row, Eigen::Index count) {
  const Exponents& known = held(row.exponents);
  if (const auto some = v.where(row.exponents.has_value(), "with `--exponents`")) {
    v.values({"exponents", "1/s", "largest first; null: minus infinity"}, known.values);
    v.values({"exponent_errors", "1/s", "standard errors"}, known.errors);
    v.field({"lost_exponents", "", "how many are minus infinity"}, known.lost);
    if (const auto failed = v.where(!known.failure.empty(), "where they could not be had"))
      v.field({"exponent_message"}, known.failure);
  }
  const auto whole = [&](const char* name, const char* what, long long value) {
    v.field({name, "", what}, only_if(row.exponents.has_value(), value));
  };
  const auto numbers = [&](const char* name, const Vector& list) {
    for (Eigen::Index j = 0; j < count; ++j)
      v.field(Field{fmt::format("{}_{}", name, j + 1), "1/s"}, number_at(list, j));
  };
  v.only(kTables, [&] {
    v.row("exponents", [&] {
      v.field({"value", "", "of the parameter"}, row.value);
      whole("period", "forcing periods; 0 where nothing repeats", row.motion.period);
      whole("periods", "averaged over", known.periods);
      whole("impacts", "in them", known.impacts);
      whole("lost", "how many are minus infinity", known.lost);
      numbers("exponent", known.values);
      numbers("error", known.errors);
    });
  });
}

// A sample as a row of the table; not finite: empty.
struct RowSample {
  std::size_t stop = 0;
  std::optional<long long> period_index{};
  double phase = NAN, speed = NAN, displacement = NAN, velocity = NAN;
};

std::vector<RowSample> samples_of(const SweepRow& row, DiagramSection section) {
  std::vector<RowSample> samples;
  if (section == DiagramSection::kImpact) {
    for (const MetImpact& impact : row.motion.impacts)
      samples.push_back({static_cast<std::size_t>(impact.stop), period_index(row, impact),
                         impact_phase(impact), impact.speed});
    return samples;
  }
  const std::size_t stops = stops_seen(row);
  for (const SweepRow::StopState& state : row.stop_states)
    samples.push_back({static_cast<std::size_t>(state.stop),
                       static_cast<long long>(samples.size() / stops), NAN, NAN, state.displacement,
                       state.velocity});
  return samples;
}

void describe_sample(ResultVisitor& v, const RowSample* sample, std::size_t i) {
  const RowSample& known = sample ? *sample : RowSample{};
  v.field({"sample", "", "its number, from 1"}, only_if(sample, i + 1));
  v.field({"stop", "", "from 1"}, only_if(sample, known.stop + 1));
  v.field({"period_index", "", "forcing period among those shown, from 0"}, known.period_index);
  v.field({"phase", "rad", "of an impact"}, known.phase);
  v.field({"speed", "m/s", "of its approach"}, known.speed);
  v.field({"displacement", "m", "of a stroboscopic section, towards the stop"}, known.displacement);
  v.field({"velocity", "m/s"}, known.velocity);
}

void describe_samples(ResultVisitor& v, const DiagramRecord& record, const SweepRow& row) {
  const std::vector<RowSample> samples = samples_of(row, record.section);
  const bool impacts = record.section == DiagramSection::kImpact;
  v.only(kDocument, [&] {
    const auto list = [&](const Field& field, auto part) {
      v.values(field, samples, [part](const RowSample& sample) { return sample.*part; });
    };
    v.values({"stops", "", "of the samples, from 1"}, samples,
             [](const RowSample& sample) { return sample.stop + 1; });
    if (const auto some = v.where(impacts, "of a section of impacts")) {
      list({"phases", "rad"}, &RowSample::phase);
      list({"speeds", "m/s"}, &RowSample::speed);
    }
    if (const auto some = v.where(!impacts, "of a stroboscopic section")) {
      list({"displacements", "m"}, &RowSample::displacement);
      list({"velocities", "m/s"}, &RowSample::velocity);
    }
  });
  const std::vector<MeasuredPlace>& places = record.branches.amplitudes.places;
  const Amplitudes* measured = row.amplitudes ? &*row.amplitudes : nullptr;
  const auto describe_measured = [&] {
    if (!places.empty()) describe_amplitudes(v, places, measured);
  };
  v.only(kDocument, describe_measured);
  // A value without samples has one line.
  const std::size_t lines = std::max<std::size_t>(samples.size(), 1);
  v.list(Field{"samples"}.tabular(), std::views::iota(std::size_t{0}, lines),
         [&](std::size_t i, std::size_t) {
           v.row("sweep", [&] {
             describe_sample(v, entry(samples, i), i);
             describe_measured();
           });
         });
}

}  // namespace

void describe(ResultVisitor& v, const DiagramRecord& record) {
  describe(v, record.branches);
  const Sweep& swept = record.swept;
  v.part({"sweep", "", "what motions settle on"}, [&] {
    v.field({"section", "", "`impact` or `stroboscopic`"}, name_of(record.section));
    v.field({"direction"}, name_of(swept.options.direction));
    v.field({"nearness", "", "of repetitions, relative"}, swept.options.nearness);
    v.field({"block", "", "values run one after the other"}, Sweep::kBlock);
    v.field({"run_again", "", "runs once more where blocks are joined"}, swept.run_again);
    v.field({"periods", "", "forcing periods run"}, swept.periods);
    v.field({"impacts", "", "met"}, swept.impacts);
    v.list({"ranges", "", "of values with one attractor"}, attractor_ranges(swept.rows),
           [&](const AttractorRange& range, std::size_t) {
             const SweepRow *first = entry(swept.rows, range.first),
                            *last = entry(swept.rows, range.last);
             v.field({"attractor"}, attractor_label(range.attractor));
             v.field({"from"}, first ? first->value : NAN);
             v.field({"to"}, last ? last->value : NAN);
             v.field({"values", "", "how many"}, range.last - range.first + 1);
           });
    const Eigen::Index exponents = 2 * record.branches.system.modes();
    v.list({"rows", "", "a value each"}, swept.rows, [&](const SweepRow& row, std::size_t) {
      describe_attractor(v, row);
      if (swept.options.exponent_periods > 0) describe_exponents(v, row, exponents);
      describe_samples(v, record, row);
    });
  });
}

}  // namespace graze
