// The simulated structure, and its natural modes.
#include <cmath>
#include <ranges>

#include "graze/assembly/detail/requested_restitution.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/assembly/mode_table.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/study_records.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

std::views::all_t<std::ranges::iota_view<Eigen::Index, Eigen::Index>> up_to(Eigen::Index count) {
  return std::views::iota(Eigen::Index{0}, count);
}

void describe_modes(ResultVisitor& v, const System& system) {
  const Vector decay = decay_rates(system);
  const std::optional<Vector> forces = modal_forces(system);
  v.list({"modes"}, up_to(system.omega.size()), [&](Eigen::Index j, std::size_t) {
    v.field({"mode", "", "from 1"}, j + 1);
    v.field({"frequency", "rad/s", "w_j"}, number_at(system.omega, j));
    v.field({"decay_rate", "1/s", "delta_j"}, number_at(decay, j));
    v.field({"force", "kg^1/2 m/s^2", "f_j, of several loads the sum of sizes; null without"},
            forces ? number_at(*forces, j) : NAN);
    v.field({"load", "kg^1/2 m/s^2", "c_j, null without gravity"},
            system.load() ? number_at(*system.load(), j) : NAN);
  });
}

void describe_elements(ResultVisitor& v, const std::optional<ElementAccuracy>& found) {
  v.maybe_part({"elements", "", "of a beam whose modes have no closed form, else null"},
               found.has_value(), [&] {
                 const ElementAccuracy& known = held(found);
                 v.field({"elements", "", "how many"}, known.elements);
                 v.field({"order", "", "degree of their shapes"}, known.order);
                 v.field({"rigid_motions"}, known.rigid);
                 v.field({"change", "", "of a frequency by the last refinement, modes 1 to 32"},
                         known.change);
                 v.field({"change_beyond", "", "of those beyond"}, known.change_beyond);
               });
}

void describe_requested(ResultVisitor& v, const Spring& spring) {
  const std::optional<RequestedRestitution> asked = requested_restitution(spring);
  v.maybe_part({"restitution", "", "that was asked for, else null"}, asked.has_value(), [&] {
    const RequestedRestitution& known = held(asked);
    v.field({"requested"}, known.requested);
    v.field({"speed", "m/s"}, known.speed);
    v.field({"mass", "kg"}, known.mass);
    v.field({"effective"}, known.effective);
    v.field({"exact_coefficient", "", "that gives it"}, known.exact_coefficient);
  });
}

void describe_law(ResultVisitor& v, const Stop& stop, const std::optional<Spring>& spring) {
  // A number, or the list a0, a1, .. of one that depends on the speed.
  if (stop.is_compliant() || stop.restitution().is_constant())
    v.field({"restitution", "", "a number, or the list a0, a1, ..; null of a compliant stop"},
            stop.is_compliant() ? std::nullopt : std::optional(stop.restitution().at_rest()));
  else
    v.values({"restitution"}, stop.restitution().coefficients());
  v.maybe_part({"spring", "", "of a compliant stop, else null"}, stop.is_compliant() && spring,
               [&] {
                 const ContactForce law = stop.is_compliant() ? stop.force() : ContactForce{};
                 v.field({"stiffness", "", "N/m^n"}, law.stiffness);
                 v.field({"exponent"}, law.exponent);
                 v.field({"coefficient"}, law.coefficient);
                 v.field({"residual", "", "1/k is what the modes left out give way"},
                         held(spring).is_residual);
                 describe_requested(v, as_given(held(spring), law.stiffness));
               });
}

void describe_flexibility(ResultVisitor& v, const StopFlexibility& at) {
  v.field({"flexibility", "m/N",
           "static, of a free structure relative to its rigid motions; null where only modes are "
           "known"},
          at.whole);
  v.field({"flexibility_of_modes", "m/N"}, at.kept);
}

void describe_stops(ResultVisitor& v, const CheckRecord& record) {
  const auto flexibilities = v.sees_all() ? std::vector<StopFlexibility>()
                                          : stop_flexibilities(record.scene, record.model);
  v.list({"stops"}, record.system.stops, [&](const Stop& stop, std::size_t i) {
    const SceneStop* from = entry(record.scene.stops, i);
    v.field({"gap", "m"}, stop.gap);
    v.field({"gap_shift", "m", "of it: by what modes left out make of a constant load"},
            from ? stop.gap - from->gap : 0.0);
    describe_law(v, stop, from ? from->spring : std::nullopt);
    v.values({"row", "kg^-1/2", "b"}, stop.row);
    v.values({"direction", "kg^1/2", "d"}, stop.direction());
    v.field({"effective_mass", "kg", "that it meets"}, 1.0 / stop.row.squaredNorm());
    const StopFlexibility* at = entry(flexibilities, i);
    describe_flexibility(v, at ? *at : StopFlexibility{});
  });
}

void describe_torque(ResultVisitor& v, const std::optional<Torque>& torque) {
  v.maybe_part({"torque", "", "null without one"}, torque.has_value(), [&] {
    const Torque& known = held(torque);
    const auto* pulse = std::get_if<TorquePulse>(&known);
    const auto* table = std::get_if<TorqueTable>(&known);
    v.field({"kind", "", "`pulse` or `table`"}, pulse ? "pulse" : "table");
    if (const auto some = v.where(pulse, "of a pulse")) {
      v.field({"amplitude", "N m"}, pulse ? pulse->amplitude : 0.0);
      v.field({"duration", "s"}, pulse ? pulse->duration : 0.0);
    }
    if (const auto some = v.where(table, "of a table")) {
      v.values({"times", "s"}, table ? table->times : std::vector<double>());
      v.values({"values", "N m"}, table ? table->values : std::vector<double>());
    }
  });
}

void describe_hub(ResultVisitor& v, const std::optional<Hub>& hub) {
  v.maybe_part({"hub", "", "null without one"}, hub.has_value(), [&] {
    const Hub& known = held(hub);
    v.field({"radius", "m"}, known.radius);
    v.field({"inertia", "kg m^2"}, known.inertia);
    describe_torque(v, known.torque);
    v.field({"equations"}, known.equations == HubEquations::kConsistent ? "consistent" : "paper");
    v.field({"centrifugal"}, known.centrifugal);
    v.field({"friction", "N m", "null without"}, known.friction);
  });
}

}  // namespace

void describe(ResultVisitor& v, const CheckRecord& record) {
  const System& system = record.system;
  const Scene& scene = record.scene;
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"title", "", "of the scene"}, scene.title);
  describe_modes(v, system);
  describe_elements(v, record.model.elements);
  v.field({"forcing_period", "s", "T"}, system.repeats() ? system.period() : NAN);
  v.field({"gravity", "m/s^2"},
          scene.gravity ? std::optional(scene.gravity->acceleration) : std::nullopt);
  describe_stops(v, record);
  const auto rows = v.sees_all() ? std::vector<ProbeRow>() : probe_rows(scene, system);
  v.list({"probes"}, scene.probes, [&](const Probe& probe, std::size_t i) {
    describe_probe(v, probe);
    const ProbeRow* row = entry(rows, i);
    v.values({"row", "", "the quantity is row.q, or row.q' of a velocity"},
             row ? row->row : Vector());
  });
  describe_hub(v, scene.hub);
  v.field({"collocation_condition", "", "of the collocation matrix, null where none is used"},
          record.collocation_condition > 0.0 ? record.collocation_condition : NAN);
  v.field({"closure_speed", "m/s", "default of `--closure-speed`; null without stops"},
          record.closure_speed);
  const FlowDecision decision = flow_decision(scene);
  v.field({"flow", "", "in use"}, flow_name(decision.flow));
  v.field({"flow_reason", "", "why"}, decision.reason);
  v.field({"step", "s", "null where there is none"}, scene.solver.step);
  v.field({"longest_stable_step", "s", "null with `exact`"},
          record.steps ? record.steps->longest : NAN);
}

void describe(ResultVisitor& v, const ModesRecord& record) {
  const ModeTable& table = record.table;
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"title", "", "of the scene"}, record.info.scene_title);
  v.field({"rigid", "", "how many modes have the frequency 0"}, table.rigid);
  v.list({"modes"}, up_to(table.omega.size()), [&](Eigen::Index j, std::size_t) {
    v.field({"mode", "", "from 1"}, j + 1);
    v.field({"frequency", "rad/s"}, number_at(table.omega, j));
    v.field({"decay_rate", "1/s"}, number_at(table.decay, j));
    v.field({"residual", "1", "relative, of modes of matrices, else null"},
            number_at(table.residuals, j));
  });
  v.list({"directions"}, table.directions, [&](const DirectionShare& share, std::size_t) {
    v.field({"direction", "", "1, 2, 3; 0: along u, or of all degrees of freedom"},
            share.direction);
    v.values({"inertia", "kg^1/2", "modal forces of a unit acceleration"}, share.inertia);
    v.values({"effective_masses", "kg"}, Vector(share.inertia.cwiseAbs2()));
    v.field({"total_mass", "kg", "which those of all modes add up to"}, share.total_mass);
  });
  v.list({"stops"}, table.flexibilities,
         [&](const StopFlexibility& at, std::size_t) { describe_flexibility(v, at); });
  describe_notes(v, table.notes);
  v.maybe_part({"mac", "", "modal assurance, with `--mac`, else null"}, record.mac.has_value(),
               [&] {
                 const ModalAssurance& mac = held(record.mac);
                 v.field({"against"}, record.mac_file);
                 v.field({"places", "", "that both have"}, mac.common);
                 v.lists({"values", "", "modes by those of the other"},
                         static_cast<std::size_t>(mac.values.rows()), [&](std::size_t i) {
                           return Vector(mac.values.row(static_cast<Eigen::Index>(i)).transpose());
                         });
               });
}

}  // namespace graze
