#include <fmt/format.h>

#include <cmath>
#include <ranges>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

void describe_final(ResultVisitor& v, const SimulationRecord& record) {
  const System& system = record.system;
  const Simulation& run = record.run;
  const Matrix& coordinates = record.coordinates;
  v.part({"final", "", "the state at the end"}, [&] {
    const bool turns = system.turns();
    const State end = structure_state(system, run.final, run.phase);
    const HubState hub = turns ? hub_state(*system.rotation(), end) : HubState{};
    const State& state = turns ? hub.beam : end;
    v.field({"time", "s"}, run.end_time);
    v.values({"q", "kg^1/2 m", "with a hub of the beam"}, state.q);
    v.values({"qdot", "kg^1/2 m/s"}, state.qdot);
    v.values({"stuck", "", "closed stops"}, run.stuck, [](int stop) { return stop + 1; });
    v.values({"forces", "N", "of each stop, closed or compressed; 0 where open"}, run.forces);
    if (const auto some = v.where(!system.frictions.empty(), "with dry friction"))
      v.list({"frictions", "", "of each"}, run.frictions,
             [&](const AtFriction& friction, std::size_t) {
               v.field({"sticks"}, friction.sticks);
               v.field({"force", "N", "that it exerts against +u"}, friction.force);
             });
    if (const auto own =
            v.where(coordinates.size() > 0, "of masses, or of matrices in the scene")) {
      const bool is_absent = coordinates.size() == 0;
      v.values({"displacement", "m", "of each"},
               is_absent ? Vector() : Vector(coordinates * state.q));
      v.values({"velocity", "m/s"}, is_absent ? Vector() : Vector(coordinates * state.qdot));
    }
    if (const auto probed = v.where(!record.probes.empty(), "with probes"))
      v.values({"probes", "", "the value of each"}, record.probes,
               [&](const ProbeRow& probe) { return probe.value(end); });
    const auto some = v.where(turns, "with a hub");
    if (!some) return;
    v.field({"angle", "rad"}, hub.angle);
    v.field({"rate", "rad/s"}, hub.rate);
  });
}

void describe_totals(ResultVisitor& v, const RunTotals& totals, bool rubs) {
  v.part({"totals", "", "over the run"}, [&] {
    v.field({"impacts"}, totals.impacts);
    v.field({"chatters"}, totals.chatters);
    v.field({"stuck_time", "s"}, totals.stuck_time);
    v.field({"energy_added_by_impacts", "J"}, totals.energy_added);
    v.field({"energy_lost_by_impacts", "J"}, totals.energy_lost);
    v.field({"smallest_gap", "m", "below zero by how deep a spring was compressed"},
            totals.smallest_gap);
    v.field({"undecided_touches", "", "grazings within rounding, passed without impact"},
            totals.undecided_touches);
    v.field({"clamped_restitutions", "", "impacts at which r(v) was clamped"},
            totals.clamped_restitutions);
    const auto some = v.where(rubs, "with dry friction");
    if (!some) return;
    v.field({"slips"}, totals.slips);
    v.field({"reversals"}, totals.reversals);
    v.field({"sticking_time", "s", "of all dry friction at once"}, totals.sticking_time);
  });
}

void describe_energy(ResultVisitor& v, const System& system, const EnergyBalance& balance) {
  const EnergyEntries entries = energy_entries(system, balance);
  v.part(
      {"energy", "J",
       "start + forcing + load + constraint + stops + friction + impacts + contact - dissipation "
       "- end = defect; "
       "null for effects that the scene does not have"},
      [&] {
        v.field({"start", "J"}, balance.start);
        v.field({"forcing", "J"}, entries.forcing);
        v.field({"load", "J"}, entries.load);
        v.field({"constraint", "J"}, entries.constraint);
        v.field({"impacts", "J"}, entries.impacts);
        v.field({"dissipation", "J"}, entries.dissipation);
        v.field({"end", "J"}, balance.now);
        v.field({"defect", "J"}, balance.defect());
        v.field({"relative_defect", "", "to the largest of them"}, relative_defect(balance));
        if (const auto some = v.where(entries.contact.has_value(), "with compliant stops"))
          v.field({"contact", "J", "their work, with the energy that they store"}, entries.contact);
        if (const auto some = v.where(entries.friction.has_value(), "with dry friction"))
          v.field({"friction", "J", "its work"}, entries.friction);
        if (const auto some = v.where(entries.stops.has_value(), "where stops move"))
          v.field({"stops", "J", "work of their motion"}, entries.stops);
      });
}

void describe_forces(ResultVisitor& v, const StopForces& forces) {
  v.part({"forces", "", "mean forces over windows of time, with `--forces`"}, [&] {
    v.field({"from", "s"}, forces.from);
    v.field({"window", "s", "its length"}, forces.length);
    v.lists(
        {"means", "N", "of every stop"},
        forces.means.size(), [&](std::size_t i) -> const auto& { return forces.means[i]; });
    const std::size_t windows = forces.means.empty() ? 0 : forces.means.front().size();
    v.list(Field{"windows"}.tabular(), std::views::iota(std::size_t{0}, windows),
           [&](std::size_t k, std::size_t) {
             v.row("forces", [&] {
               const auto begin = static_cast<double>(k);
               v.field({"from", "s"}, forces.from + begin * forces.length);
               v.field({"to", "s"}, forces.from + (begin + 1) * forces.length);
               for (std::size_t i = 0; i < forces.means.size(); ++i) {
                 const double* mean = entry(forces.means[i], k);
                 v.field({fmt::format("force{}", i + 1), "N"}, mean ? *mean : NAN);
               }
             });
           });
  });
}

void describe_points(ResultVisitor& v, const RunSection& section) {
  const bool of_impacts = section.kind() == DiagramSection::kImpact;
  v.part({"section", "", "with `--section`"}, [&] {
    v.field({"kind"}, name_of(section.kind()));
    v.field({"from", "s"}, section.from());
    // Their number, where documents have the lists elsewhere.
    v.only(Field::Use::kDocument, [&] { v.field({"points"}, section.points().size()); });
    v.field({"left_out", "", "beyond a million"}, section.left_out());
    v.columns({}, section.points(), [&](const SectionPoint& point, std::size_t) {
      v.row("section", [&] {
        v.field({"time", "s"}, point.time);
        v.field({"stop", "", "from 1"}, point.stop + 1);
        if (of_impacts) {
          v.field({"phase", "rad"}, point.across);
          v.field({"speed", "m/s", "of approach"}, point.up);
        } else {
          v.field({"displacement", "m", "towards the stop"}, point.across);
          v.field({"velocity", "m/s"}, point.up);
        }
      });
    });
  });
}

}  // namespace

void describe(ResultVisitor& v, const Event& event) {
  const auto is = [&](auto... kinds) { return ((event.kind == kinds) || ...); };
  const bool impact = is(EventKind::kImpact), chatter = is(EventKind::kChatter);
  const bool parts = is(EventKind::kSeparation), meets = impact || is(EventKind::kContact);
  const bool rubs = event.stop < 0;
  v.field({"kind", "",
           "`impact`, `chatter`, `stick`, `release`, `contact`, `separation`; of dry friction "
           "`slip`, `reversal`, `stick`"},
          name_of(event.kind));
  v.field({"time", "s"}, event.time);
  if (const auto some = v.where(!rubs, "at a stop"))
    v.field({"stop", "", "from 1"}, event.stop + 1);
  if (const auto some = v.where(meets || parts, "at impacts, contacts and separations"))
    v.field({"speed", "m/s", "of approach; of a separation away"}, event.speed);
  if (const auto some = v.where(meets, "at impacts and contacts"))
    v.field({"phase", "rad"}, event.phase);
  if (const auto some = v.where(impact || parts || chatter, "at impacts, chatters and separations"))
    v.field({"energy_change", "J",
             "kinetic; of a chatter by the part below its closure speed; of a separation minus "
             "what the stop took"},
            event.energy_change);
  if (const auto some = v.where(chatter, "of a chatter")) {
    v.field({"impacts"}, event.impacts);
    v.field({"closure_speed", "m/s"}, event.closure_speed);
  }
  if (const auto some =
          v.where(is(EventKind::kStick, EventKind::kFrictionStick), "where it sticks"))
    v.field({"force", "N", "that sets in: of contact; of friction against +u"}, event.force);
  if (const auto some = v.where(parts, "at separations")) {
    v.field({"duration", "s"}, event.duration);
    v.field({"peak_force", "N"}, event.peak_force);
    v.field({"effective_restitution", "",
             "speed away over speed of approach, null where it was entered at rest"},
            event.effective_restitution);
  }
  if (const auto some = v.where(rubs, "of dry friction"))
    v.field({"friction", "", "from 1"}, event.friction + 1);
  if (const auto some =
          v.where(is(EventKind::kSlip, EventKind::kReversal), "where friction slides"))
    v.field({"direction", "", "1 along +u from then on, -1 against it"}, event.direction);
}

void describe(ResultVisitor& v, const std::vector<Event>& events) {
  v.list({"events"}, events,
         [&](const Event& event, std::size_t) { v.row("events", [&] { describe(v, event); }); });
}

void describe(ResultVisitor& v, const SimulationRecord& record) {
  const Simulation& run = record.run;
  describe_head(v, record.info, record.outcome, record.warnings);
  if (const auto some = v.where(!record.notes.empty(), "if there are any"))
    v.values({"notes", "", "sentences"}, record.notes);
  // They are not stored: they come during the run.
  v.only(Field::Use::kDocument, [&] { describe(v, std::vector<Event>()); });
  describe_final(v, record);
  describe_totals(v, run.totals, !record.system.frictions.empty());
  if (run.energy) describe_energy(v, record.system, *run.energy);
  if (run.amplitudes) {
    describe_amplitudes(v, record.places, &*run.amplitudes);
    v.field({"measured_time", "s"}, run.amplitudes->duration);
    if (run.amplitudes->forces) describe_forces(v, *run.amplitudes->forces);
  }
  if (record.statistics) describe_statistics(v, record);
  if (record.section) describe_points(v, *record.section);
  v.unit("gap", "m");
  for (std::size_t i = 0; i < record.probes.size(); ++i)
    v.unit(fmt::format("probe_{}", i + 1), probe_unit(record.probes[i].quantity));
}

}  // namespace graze
