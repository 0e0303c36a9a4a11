// One contact of one body by every law of damping: the tables and the picture of
// docs/contact_laws.md. Run from the project's root:
//
//   example_contact_laws                    prints the tables
//   example_contact_laws PICTURE.svg        draws effective over requested restitution
//   example_contact_laws --curve            the numbers of that picture
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/detail/motion.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/report/picture/pictures.hpp"
#include "graze/scene/reader.hpp"

using namespace graze;

namespace {

constexpr const char* kScene = "data/scenes/11_body_meets_stop.toml";
constexpr double kMass = 0.1, kGap = 1e-3;      // kg and m, of that scene
constexpr double kSpeed = 0.1;                  // m/s, for which restitutions are asked
constexpr double kSpeeds[] = {0.01, 0.1, 1.0};  // m/s, at which the stop is met
constexpr const char* kLinear = "stiffness=1e7,exponent=1";
constexpr const char* kHertz = "stiffness=3e9,exponent=1.5";

struct Law {
  std::string name, spring, release, asked;
  std::string damping{};  // TOML; empty: none
};

// A damping asked for e at kSpeed.
std::string asking(const std::string& model, double e) {
  char text[160];
  const char* form = "model=\"%s\",restitution=%.17g,speed=0.1";
  if (model == "kelvin-voigt") form = "model=\"%s\",restitution=%.17g,mass=0.1";
  if (model == "jankowski") form = "model=\"%s\",restitution=%.17g,mass=0.1";
  if (model == "lee-wang-2") form = "model=\"%s\",restitution=%.17g,mass=0.1,onset=5e-6";
  if (model == "lee-wang-1") form = "model=\"%s\",alpha=%.17g";
  const double number = model == "lee-wang-1" ? (1.0 - e) / kSpeed : e;
  std::snprintf(text, sizeof text, form, model.c_str(), number);
  return text;
}

std::vector<Law> laws() {
  const std::string exact = ",inversion=\"exact\"";
  // C as Yigit, Ulsoy and Scott, J. Sound Vib. 137 (1990) 183-203, print them for two steel balls.
  const std::string depth = "model=\"lee-wang-1\",coefficient=1.92e8";
  const std::string onset = "model=\"lee-wang-2\",coefficient=800,onset=5e-6";
  const std::string step = "model=\"adams\",coefficient=800,onset=5e-6";
  const std::string constant = "model=\"kelvin-voigt\",coefficient=800";
  return {{"none", "linear", "force", "1", ""},
          {"none", "Hertz", "force", "1", ""},
          {"kelvin-voigt", "linear", "force", "0.5", asking("kelvin-voigt", 0.5)},
          {"kelvin-voigt", "linear", "position", "0.5", asking("kelvin-voigt", 0.5)},
          {"kelvin-voigt, exact", "linear", "force", "0.5", asking("kelvin-voigt", 0.5) + exact},
          {"kelvin-voigt", "Hertz", "force", "-", constant},
          {"kelvin-voigt", "Hertz", "position", "-", constant},
          {"lee-wang-1", "linear", "force", "0.5", asking("lee-wang-1", 0.5)},
          {"lee-wang-1", "Hertz", "force", "-", depth},
          {"lee-wang-1", "Hertz", "position", "-", depth},
          {"lee-wang-2", "linear", "position", "0.5", asking("lee-wang-2", 0.5)},
          {"lee-wang-2", "Hertz", "position", "-", onset},
          {"hunt-crossley", "linear", "force", "0.5", asking("hunt-crossley", 0.5)},
          {"hunt-crossley", "Hertz", "force", "0.5", asking("hunt-crossley", 0.5)},
          {"hunt-crossley, exact", "Hertz", "force", "0.5", asking("hunt-crossley", 0.5) + exact},
          {"lankarani-nikravesh", "linear", "force", "0.5", asking("lankarani-nikravesh", 0.5)},
          {"lankarani-nikravesh", "Hertz", "force", "0.5", asking("lankarani-nikravesh", 0.5)},
          {"flores", "linear", "force", "0.5", asking("flores", 0.5)},
          {"flores", "Hertz", "force", "0.5", asking("flores", 0.5)},
          {"adams", "linear", "position", "-", step},
          {"jankowski", "Hertz", "force", "0.5", asking("jankowski", 0.5)},
          {"elasto-gap", "linear", "force", "-", "model=\"elasto-gap\",coefficient=800"}};
}

Scene scene_of(const Law& law, double speed) {
  std::string spring = std::string("stop.spring={") + (law.spring == "linear" ? kLinear : kHertz) +
                       ",release=\"" + law.release + "\"";
  if (!law.damping.empty()) spring += ",damping={" + law.damping + "}";
  char start[80];
  std::snprintf(start, sizeof start, "initial.qdot=[%.17g]", std::sqrt(kMass) * speed);
  return read_scene(kScene, {spring + "}", start});
}

struct Cost {
  long long evaluations = 0;  // of the right-hand side
  double seconds = 0.0;
};

bool fly_to(Motion<double>& motion, ArrivalKind kind, double until) {
  while (motion.instant().local < until)
    if (motion.fly(until).kind == kind) return true;
  return false;
}

// From the entry to the separation; the least time of several.
Cost cost_of(const System& system, const State& start, double until) {
  using Clock = std::chrono::steady_clock;
  Cost cost{0, std::numeric_limits<double>::infinity()};
  for (int pass = 0; pass < 20; ++pass) {
    Motion<double> motion(system, {}, start.q, start.qdot);
    fly_to(motion, ArrivalKind::kEntry, until);
    const auto before = Clock::now();
    fly_to(motion, ArrivalKind::kSeparation, until);
    const std::chrono::duration<double> taken = Clock::now() - before;
    cost = {motion.step_evaluations(), std::fmin(cost.seconds, taken.count())};
  }
  return cost;
}

// Nothing where the body creeps out for ever.
std::optional<Event> separation_of(const System& system, const State& start, double until) {
  SimulationOptions options;
  options.duration = until;
  std::optional<Event> found;
  RunListeners listeners;
  listeners.event = [&found](const Event& event) {
    if (event.kind == EventKind::kSeparation) found = event;
  };
  simulate(system, start, options, listeners);
  return found;
}

// Until the contact is certainly over.
double end_of(double speed) { return 2.0 * kGap / speed; }

double effective(const Law& law, double speed) {
  const Scene scene = scene_of(law, speed);
  const System system = assemble(scene);
  const auto event = separation_of(system, initial_state(scene, system), end_of(speed));
  return event->effective_restitution.value();
}

// A table's row as it grows; a contact that does not end has no numbers.
struct Row {
  std::string text;
  template <class Number>
  void add(const char* form, bool is_known, Number number) {
    char cell[40] = "-";
    if (is_known) std::snprintf(cell, sizeof cell, form, number);
    text += std::string(" ") + cell + " |";
  }
};

void print_tables() {
  std::string restitutions, forces, costs;
  for (const Law& law : laws()) {
    const std::string name = "| " + law.name + " | " + law.spring + " | " + law.release + " |";
    Row e{name + " " + law.asked + " |"}, force{name}, duration, evaluations{name}, time;
    for (const double speed : kSpeeds) {
      const Scene scene = scene_of(law, speed);
      const System system = assemble(scene);
      const State start = initial_state(scene, system);
      const auto event = separation_of(system, start, end_of(speed));
      const bool ends = event.has_value();
      const Cost cost = ends ? cost_of(system, start, end_of(speed)) : Cost{};
      e.add("%.6f", ends, ends ? event->effective_restitution.value() : 0.0);
      force.add("%.5g", ends, ends ? event->peak_force : 0.0);
      duration.add("%.5g", ends, ends ? 1e6 * event->duration : 0.0);
      evaluations.add("%lld", ends, cost.evaluations);
      time.add("%.0f", ends, 1e6 * cost.seconds);
    }
    restitutions += e.text + "\n";
    forces += force.text + duration.text + "\n";
    costs += evaluations.text + time.text + "\n";
  }
  std::printf(
      "| law | spring | ends at | asked for | at 0.01 m/s | at 0.1 m/s | at 1 m/s |\n"
      "|---|---|---|---|---|---|---|\n%s\n",
      restitutions.c_str());
  std::printf(
      "| law | spring | ends at | force at 0.01 m/s (N) | 0.1 | 1 | duration at 0.01 m/s (µs) "
      "| 0.1 | 1 |\n|---|---|---|---|---|---|---|---|---|\n%s\n",
      forces.c_str());
  std::printf(
      "| law | spring | ends at | evaluations at 0.01 m/s | 0.1 | 1 | time at 0.01 m/s (µs) "
      "| 0.1 | 1 |\n|---|---|---|---|---|---|---|---|---|\n%s",
      costs.c_str());
}

struct Curve {
  std::string model, spring, title;
};
const Curve kCurves[] = {{"lankarani-nikravesh", "Hertz", "Lankarani and Nikravesh"},
                         {"lee-wang-1", "linear", "Lee and Wang 1"},
                         {"hunt-crossley", "Hertz", "Hunt and Crossley"},
                         {"kelvin-voigt", "linear", "Kelvin-Voigt, to zero force"},
                         {"flores", "Hertz", "Flores et al."}};

// Over the restitution asked for, that of the contact.
ChartSeries series_of(const Curve& curve, std::size_t i) {
  ChartSeries series;
  series.title = curve.title;
  series.look = curve_look(i);
  for (int n = 1; n <= 50; ++n) {
    const double asked = 0.02 * n;
    const Law law{"", curve.spring, "force", "", asking(curve.model, asked)};
    series.x.push_back(asked);
    series.y.push_back(effective(law, kSpeed));
  }
  return series;
}

void print_curves() {
  for (const Curve& curve : kCurves) {
    const ChartSeries series = series_of(curve, 0);
    for (std::size_t i = 0; i < series.x.size(); ++i)
      std::printf("%s %.17g %.17g\n", curve.model.c_str(), series.x[i], series.y[i]);
  }
}

void draw(const std::string& file) {
  ChartPanel panel{.x = {.name = "restitution asked for", .range = {0.0, 1.0}},
                   .y = {.name = "restitution of the contact", .range = {0.0, 1.0}},
                   .height = 9.0};
  for (const Curve& curve : kCurves) panel.series.push_back(series_of(curve, panel.series.size()));
  panel.series.push_back({.title = "inversion = \"exact\"",
                          .look = {.colour = kBlack, .width = 1.2},
                          .x = {0.0, 1.0},
                          .y = {0.0, 1.0}});
  draw_chart(file, RunInfo{}, {"", {{std::move(panel)}}});
}

}  // namespace

int main(int count, char** words) try {
  const std::string word = count > 1 ? words[1] : "";
  if (word.empty())
    print_tables();
  else if (word == "--curve")
    print_curves();
  else
    draw(word);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
