// Single runs over a parameter, and shares of work.
#include <fmt/format.h>

#include <cmath>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/share_record.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

void describe_run_impact(ResultVisitor& v, const RunImpact* impact) {
  v.field({"time", "s"}, impact ? impact->time : NAN);
  v.field({"stop", "", "from 1"}, only_if(impact, impact ? impact->stop + 1 : 0));
  v.field({"speed", "m/s", "of approach"}, impact ? impact->speed : NAN);
}

void describe_run(ResultVisitor& v, const ValueRun& run) {
  v.field({"value", "", "of the parameter"}, run.value);
  v.field({"reached_end"}, run.outcome == RunOutcome::kReachedEnd);
  v.list({"impacts", "", "and contacts"}, run.impacts,
         [&](const RunImpact& impact, std::size_t) { describe_run_impact(v, &impact); });
  v.values({"peaks", "", "of every probe: largest size over the run"}, run.peaks);
  v.values({"ends", "", "its value at the end"}, run.ends);
}

void describe_probes(ResultVisitor& v, const std::vector<Probe>& probes) {
  v.list({"probes"}, probes, [&](const Probe& probe, std::size_t) { describe_probe(v, probe); });
}

// One line for each impact, or one for a value without impacts; and one line for each value.
void describe_lines(ResultVisitor& v, const RunDiagramRecord& record, const ValueRun& run) {
  const std::size_t lines = std::max<std::size_t>(run.impacts.size(), 1);
  for (std::size_t k = 0; k < lines; ++k)
    v.row("sweep", [&] {
      const RunImpact* impact = entry(run.impacts, k);
      v.field({"value", "", "of the parameter"}, run.value);
      v.field({"impact", "", "its number"}, only_if(impact, k + 1));
      describe_run_impact(v, impact);
    });
  v.row("runs", [&] {
    v.field({"value", "", "of the parameter"}, run.value);
    v.field({"reached_end"}, run.outcome == RunOutcome::kReachedEnd);
    v.field({"impacts", "", "how many"}, run.impacts.size());
    for (std::size_t i = 0; i < record.probes.size(); ++i) {
      v.field({fmt::format("peak_{}", i + 1), "", "of a probe"}, number_at(run.peaks, i));
      v.field({fmt::format("end_{}", i + 1), "", "of a probe"}, number_at(run.ends, i));
    }
  });
}

void describe_curve(ResultVisitor& v, const SensitivityRecord& record,
                    const SensitivityCurve& curve) {
  const auto of_run = [](const Matrix& list, std::size_t k) {
    const auto at = static_cast<Eigen::Index>(k);
    return at < list.rows() ? Vector(list.row(at).transpose()) : Vector();
  };
  const double second = record.second.empty() ? NAN : curve.second;
  v.field({"second", "", "of the other parameter, null without one"}, second);
  v.list({"points"}, curve.runs, [&](const ValueRun& run, std::size_t k) {
    const Vector s1 = of_run(curve.s1, k), s2 = of_run(curve.s2, k);
    describe_run(v, run);
    v.values({"s1", "", "of every probe, null where there is none"}, s1);
    v.values({"s2", "", "of every probe, null where there is none"}, s2);
    v.only(Field::Use::kTables, [&] {
      v.row("sensitivity", [&] {
        v.field({"second"}, second);
        v.field({"value", "", "of the parameter"}, run.value);
        v.field({"impacts", "", "how many"}, run.impacts.size());
        for (std::size_t i = 0; i < record.probes.size(); ++i) {
          const auto at = static_cast<Eigen::Index>(i);
          v.field({fmt::format("peak_{}", i + 1), "", "of a probe"}, number_at(run.peaks, i));
          v.field({fmt::format("s1_{}", i + 1)}, number_at(s1, at));
          v.field({fmt::format("end_{}", i + 1), "", "of a probe"}, number_at(run.ends, i));
          v.field({fmt::format("s2_{}", i + 1)}, number_at(s2, at));
        }
      });
    });
  });
  v.part({"reference", "", "the run that s2 compares with"},
         [&] { describe_run(v, curve.reference); });
}

}  // namespace

void describe(ResultVisitor& v, const RunDiagramRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"parameter"}, record.parameter);
  v.field({"unit", "", "of its values"}, record.unit);
  v.field({"duration", "s", "of every run"}, record.duration);
  describe_probes(v, record.probes);
  v.list({"runs", "", "a value each"}, record.runs, [&](const ValueRun& run, std::size_t) {
    describe_run(v, run);
    v.only(Field::Use::kTables, [&] { describe_lines(v, record, run); });
  });
}

void describe(ResultVisitor& v, const SensitivityRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"parameter", "", "what was varied"}, record.parameter);
  v.field({"unit"}, record.unit);
  v.field({"second", "", "null without one"}, named(record.second));
  v.field({"second_unit"},
          record.second.empty() ? std::nullopt : std::optional(record.second_unit));
  v.field({"reference", "", "value that s2 compares with"}, record.reference);
  describe_probes(v, record.probes);
  v.list({"curves", "", "one for each value of `second`"}, record.curves,
         [&](const SensitivityCurve& curve, std::size_t) { describe_curve(v, record, curve); });
}

void describe(ResultVisitor& v, const ShareRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.part({"share", "", "of the work, with `--shard`"}, [&] {
    v.field({"part"}, record.share.part);
    v.field({"of"}, record.share.of);
    v.field({"journal", "", "file"}, record.journal);
    v.field({"piece", "", "`row` or `cell`"}, record.piece);
    v.field({"kept", "", "pieces in the journal"}, record.kept);
    v.field({"due", "", "pieces of the share"}, record.due);
  });
}

}  // namespace graze
