// graze orbit: periodic orbits at the scene's own parameters.
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/bifurcation/bounds/orbits_over_gap.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"
#include "graze/orbit/search/spread_starts.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "option_notes.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {
int run(const OrbitCommand& command) {
  check_plot<OrbitRecord>(command);
  const Scene scene = timed(scene_of(command));
  require_exact_flow(scene, "orbits are solved for");
  require_forcing_and_contact(scene);
  OrbitRecord record{info_of_call(command, scene), assemble(scene), {}, {}, {}, {}, {}};
  record.warnings = system_warnings(scene, record.system);
  warn(command, record.warnings);
  FinderOptions options = finder_options(command);
  // Orbits exist whether or not the scene's own start does.
  const std::optional<State> start = clear_start(scene, record.system);
  options.closure_speed = command.closure_speed;
  if (!options.closure_speed && start)
    options.closure_speed = default_closure_speed(record.system, *start, scene.solver.tolerance);
  OrbitCommand in_force = command;
  in_force.closure_speed = options.closure_speed;
  note_options(in_force, record.info);
  if (!start && options.from_simulation)
    warn(command, {"no start by simulation: the scene's initial state lies beyond the stop"});
  prepare_output(command);
  record.found = search_orbits(record.system, start, options);
  if (options.from_simulation && start)
    add_settled_orbits(record.system, options,
                       record.system.has_compliant_stop() ? kSprungSpreadWork : kSpreadWork,
                       record.found);
  record.places = measured_places(scene, record.system);
  const std::vector<MeasuredRow> rows = rows_of(record.places);
  for (const Orbit& orbit : record.found.orbits)
    record.amplitudes.push_back(orbit_amplitudes(record.system, orbit, rows));
  record.outcome = orbit_outcome(record.found, options, options.stop.reason());
  return conclude(command, record, scene);
}

}  // namespace graze
