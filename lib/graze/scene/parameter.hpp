// A parameter is a number of the scene, named by its path: "forcing.frequency", "stop.gap" (the
// first stop; "stop.2.gap" the second), "damping.viscous", "modal.frequencies.2". A constant
// restitution is "stop.restitution", the coefficients a0, a1, .. of r(v) are "stop.restitution.1",
// "stop.restitution.2", .. Several numbers may move as one: "stop.*.gap" are the gaps of all stops,
// and "forcing.frequency,hub.rate=2*forcing.frequency" sets the second to twice the first. The one
// place where names meet values, for --set, --parameter and tangents alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"

namespace graze {

// A number of a scene that a parameter sets, to this multiple of its value.
struct TiedNumber {
  double* number;
  double factor;
};

// The numbers that a name stands for, the first with the factor 1. Throws InputError for an unknown
// name. They are valid as long as the scene's lists keep their lengths.
std::vector<TiedNumber> parameter_numbers(Scene& scene, const std::string& name);

// Sets them, and computes anew what the structure makes of its numbers. The scene is not checked.
void set_parameter(Scene& scene, const std::string& name, double value);

// Computes anew what follows from the numbers of a structure whose matrices stand in the scene, as
// its modes. Throws InputError where a number is out of its range, or where there are no modes.
void renew_structure(Scene& scene);

// The number that `path` names, or null when the scene has no such continuous parameter. Asking for
// the forcing frequency in Hz ("forcing.frequency_hz") or in rad/s ("forcing.frequency") makes the
// scene store it in that unit; a const scene has it only in the unit in which it is stored.
double* find_parameter(Scene& scene, const std::string& path);
const double* find_parameter(const Scene& scene, const std::string& path);

// Its value, in the unit of `path`; nullopt when the scene has no such continuous parameter.
std::optional<double> parameter_value(const Scene& scene, const std::string& path);

// All continuous parameters that this scene has, for messages and suggestions.
std::vector<std::string> parameter_names(const Scene& scene);

// The scene with one parameter changed and checked again. Throws InputError for an unknown name or
// a value outside the parameter's range.
Scene with_parameter(const Scene& scene, const std::string& path, double value);

// A scene of the same shape in which every number is zero but the named one, which is one: the
// direction in which structure and system differentiate. Throws InputError for an unknown name.
Scene parameter_direction(const Scene& scene, const std::string& path);

// Whether two names have a number in common: the forcing frequency in rad/s and in Hz, the first
// stop with and without its number.
bool are_same_parameter(const std::string& first, const std::string& second);

// Whether the structure between the stops, its modes and their shapes at the stops, is the same at
// all values: forcing, gravity, gaps and restitutions come on top of it.
bool leaves_structure(const std::string& path);

// "rad/s", "m", .. of a parameter, for tables and axes; "" for a pure number, and for all of
// a scene without units.
std::string parameter_unit(const Scene& scene, const std::string& path);

// A number of the scene with six digits in the unit in which it is written, "15 mm"; nullopt where it
// is written without one.
std::optional<std::string> as_written(const Scene& scene, const std::string& path, double value);

}  // namespace graze
