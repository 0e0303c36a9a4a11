// graze compare --sensitivity: what a parameter makes of a motion.
#include <algorithm>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/parameter.hpp"
#include "option_notes.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

SensitivityOptions sensitivity_options(const CompareCommand& command) {
  SensitivityOptions options;
  options.series = series_options(command, command, *command.duration, command.points);
  options.reference = command.reference.value_or(0.5 * (command.from + command.to));
  options.second = command.second;
  options.seconds = command.second_values;
  return options;
}

void require_what_varies(const CompareCommand& command, const Scene& scene) {
  if (command.parameter.empty())
    throw InputError("--parameter: it is missing; give the parameter that is varied");
  if (!command.duration) throw InputError("--duration: it is missing; give the time of a run in s");
  if (command.second.empty() != command.second_values.empty())
    throw InputError("--second and --second-values: give both or neither");
  if (scene.probes.empty())
    throw scene_error(scene, "probe",
                      "there is no [[probe]]; sensitivities are those of what probes see");
}

}  // namespace

int run_sensitivity(const CompareCommand& command) {
  check_plot<SensitivityRecord>(command);
  const Scene scene = scene_of(command);
  require_what_varies(command, scene);
  SensitivityOptions options = sensitivity_options(command);
  options.series.progress = progress_line(command);
  SensitivityRecord record;
  record.info = info_of_call(command, scene);
  record.parameter = command.parameter;
  record.unit = parameter_unit(scene, command.parameter);
  record.second = command.second;
  if (!command.second.empty()) record.second_unit = parameter_unit(scene, command.second);
  record.reference = options.reference;
  record.probes = scene.probes;
  CompareCommand in_force = command;
  in_force.reference = options.reference;
  note_options(in_force, record.info);
  record.warnings = system_warnings(scene, assemble(scene));
  warn(command, record.warnings);
  prepare_output(command);
  record.curves = sensitivities(scene, options);
  options.series.progress = {};
  record.outcome =
      sensitivity_outcome(record.curves, std::max<std::size_t>(options.seconds.size(), 1),
                          options.series.stop.reason());
  return conclude(command, record, scene);
}

}  // namespace graze
