// graze fit: parameters of the scene from measurements.
#include "graze/fit/fit.hpp"

#include <fmt/format.h>

#include "fit_options.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "option_notes.hpp"
#include "session.hpp"

namespace graze {
namespace {

// A million rows of four columns with all their digits.
constexpr std::size_t kLargestData = 128 * 1024 * 1024;

std::string data_text(const std::string& file) {
  std::string text = read_file(file, kLargestData);
  if (text.size() > kLargestData)
    throw InputError({file, 1, 1}, "data",
                     fmt::format("the file is larger than {} MiB", kLargestData >> 20));
  return text;
}

// What a fit knows of motions is how they change with the numbers of harmonics.
void require_harmonic_loads(const Scene& scene) {
  if (scene.forcing && (!scene.repeats() || scene.forcing->signal))
    throw scene_error(scene, "forcing",
                      "a load is a signal or has a frequency of its own; parameters are fitted to "
                      "motions under loads with a common period");
}

// Motions are looked at along the flow that is most careful.
void require_exact(const Scene& scene) {
  const FlowChoice flow = scene.solver.flow;
  if (flow != FlowChoice::kAuto && flow != FlowChoice::kExact && flow != FlowChoice::kBulirschStoer)
    throw scene_error(scene, "solver.flow",
                      fmt::format("parameters are fitted with the {0} flow; take \"auto\" or "
                                  "\"{0}\"",
                                  scene.hub ? "bulirsch-stoer" : "exact"));
}

void note_fit(FitCommand command, const FitOptions& options, RunInfo& info) {
  for (const SoughtParameter& sought : options.parameters)
    info.options.emplace_back("parameter " + sought.name,
                              fmt::format("{}:{}", sought.low, sought.high));
  command.closure_speed = options.closure_speed;
  note_options(command, info);
}

}  // namespace

int run(const FitCommand& command) {
  check_plot<FitRecord>(command);
  const Scene scene = scene_of(command);
  require_exact(scene);
  require_harmonic_loads(scene);
  FitRecord record;
  record.info = info_of_call(command, scene);
  const std::string text = command.given_data ? *command.given_data : data_text(command.data);
  record.data_file = command.data;
  record.data_sha256 = sha256(text);
  const DataTable table(text, command.data);
  const Measurements measurements = read_measurements(table, scene, measurement_options(command));
  record.unused_columns = measurements.unused;
  FitOptions options;
  options.parameters = sought_parameters(command.sought);
  options.global = command.global;
  options.max_evaluations = command.max_evaluations;
  options.closure_speed = command.closure_speed;
  options.max_impacts = command.max_impacts;
  options.stop = stop_signal(command);
  options.progress = progress_line(command);
  note_fit(command, options, record.info);
  record.warnings = system_warnings(scene, assemble(scene));
  options.begins = [&] { prepare_output(command); };
  record.result = fit(scene, measurements, options);
  for (const std::string& warning : record.result.warnings) record.warnings.push_back(warning);
  options.progress = {};
  warn(command, record.warnings);
  record.outcome = fit_outcome(record.result);
  const auto files = [&] {
    NamedFiles list;
    const std::string fitted = fitted_scene_text(record.result);
    if (!fitted.empty()) list.emplace_back("fitted.toml", fitted);
    return list;
  };
  return conclude(command, record, scene, files);
}

}  // namespace graze
