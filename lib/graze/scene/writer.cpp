#include <fmt/format.h>

#include <string_view>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

std::string list_text(const std::vector<double>& values) {
  std::string entries;
  for (const double value : values) {
    entries += (entries.empty() ? "" : ", ") + real_text(value);
  }
  return "[" + entries + "]";
}

// Collects "key = value" lines.
class Writer {
 public:
  void table(std::string_view header) {
    text_ += fmt::format("{}{}\n", text_.empty() ? "" : "\n", header);
  }
  void verbatim(std::string_view key, std::string_view value) {
    text_ += fmt::format("{} = {}\n", key, value);
  }
  void word(std::string_view key, const std::string& value) { verbatim(key, quoted(value)); }
  void number(std::string_view key, double value) { verbatim(key, real_text(value)); }
  void list(std::string_view key, const std::vector<double>& values) {
    verbatim(key, list_text(values));
  }
  void list_if_any(std::string_view key, const std::vector<double>& values) {
    if (!values.empty()) {
      list(key, values);
    }
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void write(Writer& out, const Beam& beam) {
  out.table("[beam]");
  out.number("length", beam.length);
  out.number("youngs_modulus", beam.youngs_modulus);
  out.number("second_moment", beam.second_moment);
  out.number("density", beam.density);
  out.number("area", beam.area);
  if (beam.thickness) out.number("thickness", *beam.thickness);
  out.verbatim("modes", std::to_string(beam.modes));
  out.word("discretisation",
           beam.discretisation == Projection::kGalerkin ? "galerkin" : "collocation");
  out.list_if_any("points", beam.points);
}

// A table stands in the text, so that the scene needs no other file.
std::string torque_text(const Torque& torque) {
  if (const auto* pulse = std::get_if<TorquePulse>(&torque)) {
    return fmt::format("{{ kind = \"pulse\", amplitude = {}, duration = {} }}",
                       real_text(pulse->amplitude), real_text(pulse->duration));
  }
  const auto& table = std::get<TorqueTable>(torque);
  return fmt::format("{{ kind = \"table\", times = {}, values = {} }}", list_text(table.times),
                     list_text(table.values));
}

void write(Writer& out, const Hub& hub) {
  out.table("[hub]");
  out.number("radius", hub.radius);
  out.number("inertia", hub.inertia);
  if (hub.torque) out.verbatim("torque", torque_text(*hub.torque));
  out.word("equations", hub.equations == HubEquations::kConsistent ? "consistent" : "paper");
  out.verbatim("centrifugal", hub.centrifugal ? "true" : "false");
  if (hub.friction) {
    out.verbatim("friction", fmt::format("{{ coulomb = {} }}", real_text(*hub.friction)));
  }
}

void write(Writer& out, const ModalStructure& modal) {
  out.table("[modal]");
  out.list("frequencies", modal.frequencies);
  out.list_if_any("damping_ratios", modal.damping_ratios);
  out.list_if_any("participation", modal.participation);
  out.list_if_any("inertia", modal.inertia);
}

void write(Writer& out, const Damping& damping) {
  out.table("[damping]");
  if (const auto* viscous = std::get_if<ViscousDamping>(&damping)) {
    out.number("viscous", viscous->coefficient);
  } else if (const auto* ratios = std::get_if<DampingRatios>(&damping)) {
    out.list("ratios", ratios->ratios);
  } else {
    const auto& rayleigh = std::get<RayleighDamping>(damping);
    out.verbatim("rayleigh", fmt::format("{{ mass = {}, stiffness = {} }}",
                                         real_text(rayleigh.mass), real_text(rayleigh.stiffness)));
  }
}

std::string kind_name(ForcingKind kind) {
  switch (kind) {
    case ForcingKind::kBase:
      return "base";
    case ForcingKind::kDistributed:
      return "distributed";
    case ForcingKind::kModal:
      break;
  }
  return "modal";
}

void write(Writer& out, const Forcing& forcing) {
  out.table("[forcing]");
  out.word("kind", kind_name(forcing.kind));
  out.number("amplitude", forcing.amplitude);
  out.number("frequency", forcing.frequency);
  out.number("phase", forcing.phase);
}

void write(Writer& out, const Gravity& gravity) {
  out.table("[gravity]");
  out.number("acceleration", gravity.acceleration);
}

void write(Writer& out, const SpringGeometry& geometry) {
  std::vector<double> radii, moduli, poisson;
  for (const ElasticBody& body : geometry.bodies) {
    radii.insert(radii.end(), body.radii.begin(), body.radii.end());
    moduli.push_back(body.modulus);
    poisson.push_back(body.poisson_ratio);
  }
  out.list("radii", radii);
  out.list("moduli", moduli);
  out.list("poisson", poisson);
  out.number("angle", geometry.angle);
}

std::string damping_text(const SpringDamping& damping) {
  std::string text = "model = " + quoted(contact_model_name(damping.model));
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) {
      text += fmt::format(", {} = {}", key, real_text(*value));
    }
  };
  add("coefficient", damping.coefficient);
  add("ratio", damping.ratio);
  add("alpha", damping.alpha);
  add("restitution", damping.restitution);
  add("speed", damping.speed);
  add("mass", damping.mass);
  add("onset", damping.onset);
  add("sharpness", damping.sharpness);
  if (damping.exact) {
    text += ", inversion = \"exact\"";
  }
  return "{ " + text + " }";
}

void write(Writer& out, const Spring& spring) {
  out.table("[stop.spring]");
  if (spring.geometry) {
    write(out, *spring.geometry);
  } else {
    out.number("stiffness", spring.stiffness);
    out.number("exponent", spring.exponent);
  }
  if (spring.damping) {
    out.verbatim("damping", damping_text(*spring.damping));
  }
  out.word("release", spring.release == Separation::kAtZeroForce ? "force" : "position");
}

void write(Writer& out, const SceneStop& stop, bool modal) {
  out.table("[[stop]]");
  if (modal) {
    out.list("shape", stop.shape);
  } else {
    out.number("position", stop.position);
  }
  out.number("gap", stop.gap);
  out.word("side", stop.side == Side::kAbove ? "above" : "below");
  if (stop.spring) {
    write(out, *stop.spring);
    return;
  }
  if (stop.restitution.size() == 1) {
    out.number("restitution", stop.restitution.front());
  } else {
    out.list("restitution", stop.restitution);
  }
  out.word("impulse", stop.impulse == Impulse::kMomentum ? "momentum" : "collocation");
}

void write(Writer& out, const Probe& probe, bool modal) {
  out.table("[[probe]]");
  if (is_of_hub(probe.quantity)) {
    out.word("quantity", probe_quantity_name(probe.quantity));
    return;
  }
  if (modal) {
    out.list("shape", probe.shape);
  } else {
    out.number("position", probe.position);
  }
  out.word("quantity", probe_quantity_name(probe.quantity));
}

}  // namespace

std::string write_scene(const Scene& scene) {
  Writer out;
  if (!scene.title.empty()) {
    out.word("title", scene.title);
  }
  std::visit([&](const auto& structure) { write(out, structure); }, scene.structure);
  if (scene.hub) {
    write(out, *scene.hub);
  }
  if (scene.damping) {
    write(out, *scene.damping);
  }
  if (scene.forcing) {
    write(out, *scene.forcing);
  }
  if (scene.gravity) {
    write(out, *scene.gravity);
  }
  for (const SceneStop& stop : scene.stops) {
    write(out, stop, scene.modal() != nullptr);
  }
  for (const Probe& probe : scene.probes) {
    write(out, probe, scene.modal() != nullptr);
  }
  if (scene.initial) {
    out.table("[initial]");
    out.list("q", scene.initial->q);
    out.list("qdot", scene.initial->qdot);
    if (scene.hub) {
      out.number("angle", scene.initial->angle);
      out.number("rate", scene.initial->rate);
    }
  }
  // The numerics that apply are no part of the structure, but another default would change results.
  out.table("[solver]");
  out.word("flow", flow_name(scene.solver.flow));
  out.number("tolerance", scene.solver.tolerance);
  if (scene.solver.step) out.number("step", *scene.solver.step);
  return std::move(out).text();
}

}  // namespace graze
