// Who calls a command from within a process, in place of a shell: hears of the work as it goes, may
// stop it, and takes its result as a value.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "graze/motion/run_events.hpp"
#include "graze/record/stored/record_file.hpp"

namespace graze {

class Caller {
 public:
  virtual ~Caller() = default;

  // Set from outside while the work goes on; it then keeps what it finished. Must outlive the work.
  virtual const std::atomic<bool>& interrupted() const = 0;
  // 0 to 1; called by one thread at a time, any.
  virtual void hear_progress(double fraction) = 0;

  // Of a run, as it goes: every event and every sample that it records. A sample comes with the
  // system that it is of.
  virtual void hear(const Event& event) = 0;
  virtual void hear(const Sample& sample) = 0;
  // Before the first of them; `samples`: about how many there will be.
  virtual void begin_run(const System& system, const std::vector<ProbeRow>& probes, bool energy,
                         double samples) = 0;

  // The result, and the scene in force. `document`: that of a result that was read from a folder.
  virtual void take(AnyRecord record, const Scene& scene, std::string document) = 0;
};

}  // namespace graze
