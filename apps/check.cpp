// graze check: what a scene means.
#include "graze/report/json.hpp"
#include "graze/report/text.hpp"
#include "graze/scene/reader.hpp"
#include "session.hpp"

namespace graze {

int run_check(const Command& command) {
  const Scene scene = read_scene(command.scene, command.settings);
  CheckRecord record{run_info(command.name, command.scene, scene),
                     scene,
                     assemble(scene),
                     collocation_condition(scene),
                     {},
                     {"checked", ""}};
  initial_state(scene, record.system);  // throws where the motion would start beyond a stop
  record.warnings = system_warnings(scene, record.system);
  warn(command, record.warnings);
  prepare_output(command);
  return conclude(command, record.info, record.outcome, {to_json(record), to_text(record), {}, {}});
}

}  // namespace graze
