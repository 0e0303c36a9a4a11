#include "graze/record/described/detail/shared_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace graze {

void describe_head(ResultVisitor& v, const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings) {
  v.part({"graze", "", "what made the result"}, [&] {
    v.field({"version"}, info.version);
    v.field({"command"}, info.command);
    v.field({"scene", "", "file"}, info.scene_file);
    v.field({"scene_sha256", "", "of `scene.toml` as `--out` writes it"}, info.scene_sha256);
    v.part({"options", "", "those that were given or used"}, [&] {
      for (const auto& [name, value] : info.options)
        std::visit([&, &key = name](const auto& option) { v.field({key}, option); }, value);
    });
  });
  v.field({"outcome", "", "see above"}, outcome.name);
  if (const auto some = v.where(!outcome.message.empty(), "if something failed"))
    v.field({"message"}, outcome.message);
  if (const auto some = v.where(!warnings.empty(), "if there are any"))
    v.values({"warnings", "", "sentences"}, warnings);
}

void describe_notes(ResultVisitor& v, const std::vector<std::string>& notes,
                    const std::vector<std::string>& details) {
  std::vector<std::string> all = notes;
  all.insert(all.end(), details.begin(), details.end());
  v.values({"notes", "", "sentences"}, all);
}

namespace {

void describe_harmonic(ResultVisitor& v, const std::optional<Complex>& harmonic) {
  v.maybe_part(Field{"harmonic", "", "at the forcing frequency; null without forcing"}.document(),
               harmonic.has_value(), [&] {
                 v.field({"amplitude", "m"}, std::abs(held(harmonic)));
                 v.field({"phase", "rad"}, std::arg(held(harmonic)));
               });
  const auto size = harmonic ? std::optional(std::abs(*harmonic)) : std::nullopt;
  v.field(Field{"harmonic", "", "its amplitude"}.tabular(), size);
}

void describe_amplitude(ResultVisitor& v, const MeasuredPlace& place, const Amplitude& measured) {
  if (place.probe)
    v.field(Field{"probe", "", "from 1, or"}.document(), *place.probe + 1);
  else
    v.field(Field{"stop", "", "from 1"}.document(), place.stop.value_or(0) + 1);
  v.field({"amplitude", "m", "largest size"}, measured.largest());
  v.field({"max", ""}, measured.highest);
  v.field({"min", ""}, measured.lowest);
  v.field({"half_range", "", "half of max - min"}, measured.half_range());
  v.field({"mean", "", "over time"}, measured.mean);
  v.field({"rms", "", "about zero"}, measured.rms);
  describe_harmonic(v, measured.harmonic);
  v.field({"peak_velocity", "m/s", "null of a velocity"}, measured.speed);
}

void describe_load(ResultVisitor& v, std::size_t stop, const StopLoad& load, double duration) {
  const auto each_second = [&](double amount) {
    return duration > 0.0 ? std::optional(amount / duration) : std::nullopt;
  };
  v.field(Field{"stop", "", "from 1"}.document(), stop + 1);
  v.field(Field{"impacts", "", "and contacts begun"}.document(), load.impacts);
  v.field({"impact_rate", "1/s"}, each_second(static_cast<double>(load.impacts)));
  v.field({"impulse", "N s"}, load.impulse);
  v.field(Field{"mean_force", "N"}.document(), each_second(load.impulse));
  v.field(Field{"time_held", "s", "closed"}.document(), load.held);
  v.field({"peak_force", "N", "null where impacts on a rigid stop, which have no force, act"},
          load.peak_force);
  v.field({"rms_force", "N"}, load.rms_force);
}

}  // namespace

void describe_amplitudes(ResultVisitor& v, const std::vector<MeasuredPlace>& places,
                         const Amplitudes* measured) {
  static const Amplitudes kNone;
  const Amplitudes& all = measured ? *measured : kNone;
  const auto some = v.where(measured, "with `--amplitudes`");
  if (!some) return;
  v.spread({"amplitudes", "", "at every place"}, places, all.rows.size() == places.size(),
           [&](const MeasuredPlace& place, std::size_t i) {
             const Amplitude* row = entry(all.rows, i);
             v.prefix(place.name('_') + "_",
                      [&] { describe_amplitude(v, place, row ? *row : Amplitude{}); });
           });
  // Forces are measured without places too.
  const auto of_stops = std::count_if(places.begin(), places.end(), [](const MeasuredPlace& place) {
    return place.stop.has_value();
  });
  const std::vector<StopLoad> loads =
      all.stops.empty() ? std::vector<StopLoad>(static_cast<std::size_t>(of_stops)) : all.stops;
  v.spread({"loads", "", "on every stop"}, loads, !all.stops.empty(),
           [&](const StopLoad& load, std::size_t i) {
             v.prefix(fmt::format("stop_{}_", i + 1),
                      [&] { describe_load(v, i, load, all.duration); });
           });
  if (!places.empty()) v.unit("force", "N");
  for (const MeasuredPlace& place : places)
    if (place.probe) v.unit(place.name('_'), place.unit);
}

void describe_probe(ResultVisitor& v, const Probe& probe) {
  const bool on_beam = probe.shape.empty() && !is_of_hub(probe.quantity);
  v.field({"quantity"}, probe_quantity_name(probe.quantity));
  v.field({"unit", "", "empty of a strain"}, probe_unit(probe.quantity));
  v.field({"position", "", "m, null with `[modal]` and `[matrices]`"},
          on_beam ? std::optional(probe.position) : std::nullopt);
  v.field({"node", "", "of `[matrices]`, else null"}, named(probe.node));
  v.field({"against", "", "of `[matrices]`, else null"}, named(probe.against));
}

void describe_axis(ResultVisitor& v, const char* name, const PlaneAxis& axis,
                   const std::string& unit) {
  v.part({name, "", "of the plane"}, [&] {
    v.field({"parameter"}, axis.name);
    v.field({"unit"}, unit);
    v.field({"from"}, axis.from);
    v.field({"to"}, axis.to);
    v.field({"points", "", "cells"}, axis.points);
  });
}

}  // namespace graze
