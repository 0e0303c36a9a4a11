#include "graze/record/shown_quantity.hpp"

#include <complex>
#include <iterator>

namespace graze {
namespace {

using Number = std::optional<double>;

// A number of the motion at a place, in the unit of the place, or of the load on its stop.
struct Description {
  const char *name, *words;  // of --show, of an axis
  Number (*of_place)(const Amplitude&) = nullptr;
  Number (*of_stop)(const StopLoad&, double duration) = nullptr;  // else
  const char* unit = "";                                          // of a load
};

// In the order of ShownQuantity.
constexpr Description kDescriptions[] = {
    {"amplitude", "amplitude", [](const Amplitude& at) { return Number(at.largest()); }},
    {"max", "largest value", [](const Amplitude& at) { return Number(at.highest); }},
    {"min", "smallest value", [](const Amplitude& at) { return Number(at.lowest); }},
    {"half-range", "half range", [](const Amplitude& at) { return Number(at.half_range()); }},
    {"mean", "mean", [](const Amplitude& at) { return Number(at.mean); }},
    {"rms", "root mean square", [](const Amplitude& at) { return Number(at.rms); }},
    {"standard-deviation", "standard deviation",
     [](const Amplitude& at) { return Number(at.standard_deviation()); }},
    {"harmonic", "first harmonic",
     [](const Amplitude& at) { return at.harmonic ? Number(std::abs(*at.harmonic)) : Number(); }},
    {"peak-velocity", "largest velocity", [](const Amplitude& at) { return at.speed; }},
    {"peak-force", "largest force", nullptr,
     [](const StopLoad& load, double) { return load.peak_force; }, "N"},
    {"rms-force", "root mean square force", nullptr,
     [](const StopLoad& load, double) { return load.rms_force; }, "N"},
    {"mean-force", "impulse per time", nullptr,
     [](const StopLoad& load, double duration) { return Number(load.impulse / duration); }, "N"},
    {"impact-rate", "impacts per time", nullptr,
     [](const StopLoad& load, double duration) {
       return Number(static_cast<double>(load.impacts) / duration);
     },
     "1/s"}};
static_assert(std::size(kDescriptions) == std::size(kShownQuantities));

const Description& described(ShownQuantity quantity) {
  return kDescriptions[static_cast<std::size_t>(quantity)];
}

}  // namespace

const char* name_of(ShownQuantity quantity) { return described(quantity).name; }

bool is_of_stop(ShownQuantity quantity) { return described(quantity).of_stop != nullptr; }

bool exists_at(ShownQuantity quantity, const MeasuredPlace& place) {
  if (is_of_stop(quantity)) return place.stop.has_value();
  return quantity != ShownQuantity::kPeakVelocity || !place.unit.ends_with("/s");
}

std::optional<double> shown_value(const Shown& shown, const std::vector<MeasuredPlace>& places,
                                  const Amplitudes& measured) {
  if (measured.rows.size() != places.size()) return {};
  const Description& number = described(shown.quantity);
  if (number.of_place) return number.of_place(measured.rows[shown.place]);
  return number.of_stop(measured.stops[static_cast<std::size_t>(*places[shown.place].stop)],
                        measured.duration);
}

std::string shown_title(const Shown& shown, const std::vector<MeasuredPlace>& places) {
  return std::string(described(shown.quantity).words) + " at " + places[shown.place].name();
}

std::string shown_unit(const Shown& shown, const std::vector<MeasuredPlace>& places) {
  if (is_of_stop(shown.quantity)) return described(shown.quantity).unit;
  const std::string& unit = places[shown.place].unit;
  if (shown.quantity != ShownQuantity::kPeakVelocity) return unit;
  return unit.empty() ? "1/s" : unit + "/s";
}

}  // namespace graze
