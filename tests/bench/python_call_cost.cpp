// What a simulation of a scene that was read costs in C++, in microseconds a call: by the library
// alone, and as the command that the package calls.
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "apps/caller.hpp"
#include "apps/command.hpp"
#include "apps/program.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/scene/reader.hpp"

namespace {

using namespace graze;
using Clock = std::chrono::steady_clock;

class Taker final : public Caller {
 public:
  const std::atomic<bool>& interrupted() const override { return never_; }
  void hear_progress(double) override {}
  void hear(const Event& event) override { events_.push_back(event); }
  void hear(const Sample&) override {}
  void begin_run(const System&, const std::vector<ProbeRow>&, bool, double) override {}
  void take(AnyRecord, const Scene&, std::string) override {}

 private:
  std::atomic<bool> never_{false};
  std::vector<Event> events_;
};

template <class Work>
double microseconds(int calls, const Work& work) {
  double best = 1e300;  // of blocks: whatever else the machine does adds to it
  for (int block = 0; block < 300; ++block) {
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    const double spent = std::chrono::duration<double>(Clock::now() - begin).count();
    best = std::min(best, 1e6 * spent / calls);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto scene = std::make_shared<const Scene>(read_scene(argv[1]));
  const long long periods = std::atoll(argv[2]);
  const double library = microseconds(10, [&] {
    const System system = assemble(*scene);
    SimulationOptions options;
    options.periods = periods;
    std::vector<Event> events;
    RunListeners listeners;
    listeners.event = [&](const Event& event) { events.push_back(event); };
    simulate(system, initial_state(*scene, system), options, listeners);
  });
  const double command = microseconds(10, [&] {
    Taker taker;
    SimulateCommand wanted;
    wanted.name = "simulate";
    wanted.periods = periods;
    wanted.scene = argv[1];
    wanted.given = scene;
    wanted.caller = &taker;
    run_command(Command(wanted));
  });
  std::printf("%.3f %.3f\n", library, command);
}
