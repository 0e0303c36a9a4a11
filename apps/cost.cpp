// graze cost: what accuracy costs in time, flow by flow.
#include <cmath>
#include <functional>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/system/scale.hpp"
#include "option_notes.hpp"
#include "session.hpp"

namespace graze {
namespace {

// Of a motion without forcing, in oscillations of its slowest mode; else in forcing periods.
constexpr double kLongest = 100.0;

double longest_span(const System& system) {
  const double seconds = system.repeats() ? system.period() : longest_flight(system);
  return kLongest * (std::isfinite(seconds) ? seconds : 1.0);
}

ContactOrders contact_orders_of(const System& system, const State& start,
                                const FlowCostOptions& options) {
  ContactOrders orders;
  orders.first = first_contact(system, start, options.longest, options.stop);
  if (orders.first.stop >= 0) orders.lines = contact_orders(orders.first.contact, options.stop);
  return orders;
}

}  // namespace

int run(const CostCommand& command) {
  check_plot<CostRecord>(command);
  const Scene scene = scene_of(command);
  if (!scene.frictions.empty())
    throw scene_error(scene, "friction",
                      "steps do not know dry friction, so that their cost is not measured; "
                      "[[friction]] must be left out");
  CostRecord record;
  record.info = info_of_call(command, scene);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  record.warnings = system_warnings(scene, system);
  warn(command, record.warnings);
  FlowCostOptions options;
  options.longest = command.duration.value_or(longest_span(system));
  options.impacts = static_cast<std::size_t>(command.impacts);
  options.tolerance = scene.solver.tolerance;
  options.speed = modal_speed(system, start);
  options.closure_speed =
      command.closure_speed.value_or(default_closure_speed(system, start, scene.solver.tolerance));
  options.max_impacts = command.max_impacts;
  options.stop = stop_signal(command);
  const std::function<void(double)> progress = progress_line(command);
  const auto tell = [&](double part) {
    if (progress) progress(part);
  };
  // The flows take about half of the time.
  options.progress = [&](double part) { tell(0.5 * part); };
  CostCommand in_force = command;
  in_force.duration = options.longest;
  in_force.closure_speed = options.closure_speed;
  note_options(in_force, record.info);
  prepare_output(command);
  record.costs = flow_costs(system, start, options);
  if (!options.stop.requested()) {
    const AccuracyCostOptions others{options.longest, command.closure_speed, command.max_impacts,
                                     options.stop};
    record.modes = mode_costs(scene, others);
    tell(0.8);
    record.closure = closure_costs(system, start, others);
    tell(0.9);
    record.corrector = corrector_costs(scene, others);
    if (record.costs.compliant && !record.costs.turns)
      record.contact = contact_orders_of(system, start, options);
    tell(1.0);
  }
  record.outcome = cost_outcome(record.costs, options.stop.reason());
  return conclude(command, record, scene);
}

}  // namespace graze
