#include <cmath>

#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"

namespace graze {
namespace {

void describe_instant(ResultVisitor& v, const OrbitInstant& at) {
  v.field({"period_index", "", "forcing period within the orbit, 0..p-1"}, at.period_index);
  v.field({"phase", "rad", "forcing phase"}, at.phase);
}

void describe_contact(ResultVisitor& v, const OrbitImpact& impact) {
  const OrbitContact& contact = held(impact.contact);
  const auto some = v.where(contact.duration > 0.0, "on compliant stops");
  if (!some) return;
  v.row("contacts", [&] {
    v.field({"duration", "s"}, contact.duration);
    v.field({"peak_force", "N"}, contact.peak_force);
    v.field({"effective_restitution", "", "speed away over speed of approach"},
            contact.speed_after / impact.speed);
    v.field({"energy_change", "J", "minus what the stop took"}, -contact.taken);
  });
}

}  // namespace

void describe_impacts(ResultVisitor& v, const std::vector<OrbitImpact>& impacts) {
  v.list({"at", "", "impacts in time order"}, impacts,
         [&](const OrbitImpact& impact, std::size_t i) {
           v.row("orbits", [&] {
             v.field(Field{"impact", "", "its number"}.in("contacts").tabular(), i + 1);
             v.field(Field{"stop", "", "from 1"}.in("contacts"), impact.stop + 1);
             describe_instant(v, {impact.period_index, impact.phase});
             v.field({"speed", "m/s", "of approach"}, impact.speed);
             describe_contact(v, impact);
           });
         });
}

void describe_multipliers(ResultVisitor& v, const Orbit& orbit) {
  v.values({"multipliers", "", "as [re, im], largest first"}, orbit.multipliers,
           [](const Eigenvalue& multiplier) { return multiplier.value; });
}

void describe_section(ResultVisitor& v, const Orbit& orbit) {
  const auto some =
      v.where(orbit.section.has_value(), "where the orbit sticks, or on compliant stops");
  if (!some) return;
  const OrbitSection& section = held(orbit.section);
  v.part(Field{"section", "", "an instant with the state there, whose motion repeats the orbit"}
             .document(),
         [&] {
           const MotionState<double>* first = entry(section.states, 0);
           describe_instant(v, section.at);
           v.values({"q", "kg^1/2 m"}, first ? first->q : Vector());
           v.values({"qdot", "kg^1/2 m/s"}, first ? first->qdot : Vector());
         });
}

void describe_rubbing(ResultVisitor& v, const Orbit& orbit) {
  const auto some = v.where(!orbit.rubbing.empty(), "with dry friction");
  if (!some) return;
  v.list({"rubbing", "", "its events"}, orbit.rubbing, [&](const OrbitRubbing& event, std::size_t) {
    v.field({"friction", "", "from 1"}, event.friction + 1);
    v.field({"kind", "", "what it does from then on: `forward`, `backward` or `sticks`"},
            event.what == Rubs::kSticks    ? "sticks"
            : event.what == Rubs::kForward ? "forward"
                                           : "backward");
    describe_instant(v, event.at);
  });
}

void describe_sticking(ResultVisitor& v, const Orbit& orbit) {
  const auto some = v.where(orbit.sticks(), "where the orbit sticks");
  if (!some) return;
  v.list({"stuck_phases", "", "of closed stops"}, orbit.sticking,
         [&](const StickingPhase& sticking, std::size_t) {
           v.row("stuck", [&] {
             v.field({"stop", "", "from 1"}, sticking.stop + 1);
             v.part({"from", "", "its begin"}, [&] { describe_instant(v, sticking.from); });
             v.part({"to", "", "its end"}, [&] { describe_instant(v, sticking.to); });
             v.field({"duration", "s"}, sticking.duration);
             v.field({"force", "N", "of contact, at the beginning"}, sticking.force);
             v.field(
                 {"smallest_force", "N", "smallest interior local minimum, null if there is none"},
                 sticking.smallest_force);
           });
         });
  describe_section(v, orbit);
  v.field(Field{"closure_speed", "m/s", "below which the rest of a chatter is computed at once"}
              .document(),
          held(orbit.section).closure_speed);
}

namespace {

void describe_orbit(ResultVisitor& v, const Orbit& orbit, std::size_t number) {
  v.field(Field{"orbit", "", "its number"}.in("orbits stuck contacts").tabular(), number);
  v.field(Field{"period", "", "p"}.in("orbits"), orbit.period);
  v.field(
      Field{"impacts", "", "k; of an orbit that sticks those above `--closure-speed`"}.in("orbits"),
      orbit.impacts.size());
  v.values({"phases", "rad"}, orbit.impacts, [](const OrbitImpact& at) { return at.phase; });
  v.values({"speeds", "m/s"}, orbit.impacts, [](const OrbitImpact& at) { return at.speed; });
  describe_impacts(v, orbit.impacts);
  describe_multipliers(v, orbit);
  v.field(Field{"stable", "", "null: a multiplier is on the unit circle"}.in("orbits"),
          orbit.stable);
  v.field(Field{"admissible", "", "no stop is penetrated"}.in("orbits"), orbit.admissible);
  v.field(
      Field{"clearance", "m", "smallest interior local minimum of a gap between the impacts"}.in(
          "orbits"),
      orbit.clearance);
  v.field(Field{"largest_multiplier", "", "modulus"}.in("orbits").tabular(),
          orbit.multipliers.empty() ? NAN : std::abs(orbit.multipliers.front().value));
  v.field(Field{"residual", "1", "of its equations, scaled"}.in("orbits"), orbit.residual);
  v.field(Field{"stuck", "", "whether it sticks"}.in("orbits"), orbit.sticks());
  if (const auto some = v.where(orbit.lasts.has_value(), "of a self-excited orbit"))
    v.field(Field{"lasts", "s", "its period"}.in("orbits"), orbit.lasts);
  describe_sticking(v, orbit);
  if (!orbit.sticks()) describe_section(v, orbit);
  describe_rubbing(v, orbit);
}

void describe_starts(ResultVisitor& v, const FoundOrbits& found) {
  v.part({"starts", "", "from which orbits were sought"}, [&] {
    const auto count = [&](const char* name, const char* what, const StartCount& starts) {
      v.part({name, "", what}, [&] {
        v.field({"tried"}, starts.tried);
        v.field({"converged"}, starts.converged);
      });
    };
    count("closed_form", "of one impact", found.closed_form);
    count("two_impacts", "their closed form", found.two_impacts);
    count("simulation", "what the motion settles on", found.simulation);
    count("random", "quasi-random phases", found.random);
    count("global", "a global search", found.global);
  });
}

constexpr int kProfileSamplesPerPeriod = 200;

// The motion over one period: one row for each sample, flight by flight from impact to impact with
// the ends of each, so that an impact has a row before and one after it.
void describe_profile(ResultVisitor& v, const OrbitRecord& record, std::size_t k) {
  // Every place is sampled at the same instants.
  std::vector<std::vector<std::vector<CurveSample>>> curves(record.places.size());
  const Orbit* orbit = entry(record.found.orbits, k);
  for (std::size_t i = 0; orbit && !v.sees_all() && i < curves.size(); ++i)
    curves[i] = orbit_curve(record.system, *orbit, record.places[i].seen, kProfileSamplesPerPeriod);
  const auto describe_sample = [&](std::size_t flight, std::size_t i) {
    const auto sample = [&](std::size_t place) {
      return curves[place].empty() ? CurveSample{} : curves[place][flight][i];
    };
    v.row("profiles", [&] {
      const HarmonicForcing& forcing = *record.system.forcing();
      const double theta = curves.empty() ? 0.0 : sample(0).theta;
      v.field({"orbit", "", "its number"}, k + 1);
      v.field({"flight", "", "its number"}, flight + 1);
      v.field({"time", "s"}, (theta - forcing.phase) / forcing.frequency);
      v.field({"phase", "rad", "counted on"}, theta);
      for (std::size_t place = 0; place < curves.size(); ++place) {
        const MeasuredPlace& at = record.places[place];
        const std::string name = at.name('_');
        if (at.seen.of_velocity) {
          v.field({name, at.unit, "of a probe of a velocity"}, sample(place).velocity);
          continue;
        }
        v.field({name, at.unit}, sample(place).displacement);
        v.field({name + "_velocity"}, sample(place).velocity);
      }
    });
  };
  if (v.sees_all()) return describe_sample(0, 0);
  for (std::size_t flight = 0; !curves.empty() && flight < curves[0].size(); ++flight)
    for (std::size_t i = 0; i < curves[0][flight].size(); ++i) describe_sample(flight, i);
}

}  // namespace

void describe(ResultVisitor& v, const OrbitRecord& record) {
  describe_head(v, record.info, record.outcome, record.warnings);
  v.list({"orbits", "", "periodic orbits"}, record.found.orbits,
         [&](const Orbit& orbit, std::size_t i) {
           describe_orbit(v, orbit, i + 1);
           describe_amplitudes(v, record.places, entry(record.amplitudes, i));
           if (v.wants_rows("profiles")) describe_profile(v, record, i);
         });
  describe_starts(v, record.found);
  v.field({"patterns_searched", "", "sequences of impacts"}, record.found.patterns);
  v.field({"left_out_as_inadmissible", "", "solutions that `--virtual` would list"},
          record.found.inadmissible);
  describe_notes(v, record.found.notes, record.found.details);
}

}  // namespace graze
