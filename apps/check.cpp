// graze check: what a scene means.
#include <fmt/format.h>

#include <algorithm>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/record/records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "session.hpp"

namespace graze {
namespace {

// One in a line, its name first.
void print_parameters(const Scene& scene) {
  const std::vector<std::string> names = parameter_names(scene);
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  print([&](const TextSink& out) {
    for (const std::string& name : names) {
      const std::string unit = parameter_unit(scene, name);
      out(fmt::format("{:<{}}   {}{}{}\n", name, width, parameter_value(scene, name).value(),
                      unit.empty() ? "" : " ", unit));
    }
  });
}

}  // namespace

int run(const CheckCommand& command) {
  check_plot<CheckRecord>(command);
  const Scene scene = scene_of(command);
  if (command.parameters) {
    print_parameters(scene);
    return 0;
  }
  const ModalModel model = modal_model(scene);
  CheckRecord record{info_of_call(command, scene),
                     scene,
                     model,
                     assemble(scene, model),
                     collocation_condition(model),
                     {},
                     {},
                     {},
                     {"checked", ""}};
  // Throws where the motion would start beyond a stop.
  const State start = initial_state(scene, record.system);
  if (!scene.stops.empty())
    record.closure_speed = default_closure_speed(record.system, start, scene.solver.tolerance);
  record.steps = step_choice(scene, record.system, start);
  record.warnings = system_warnings(scene, record.system);
  for (const std::string& warning : unstable_stops(record.system))
    record.warnings.push_back(warning);
  warn(command, record.warnings);
  prepare_output(command);
  return conclude(command, record, scene);
}

}  // namespace graze
