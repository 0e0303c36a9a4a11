// A command in the process of Python: done in a thread of its own while Python's main thread looks
// for Ctrl-C and tells how far the work is.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <vector>

#include "caller.hpp"
#include "command.hpp"
#include "rows.hpp"

namespace graze {

// The result of a command with all that a run recorded.
class FoundResult final : public Caller {
 public:
  const std::atomic<bool>& interrupted() const override { return stop_; }
  void hear_progress(double fraction) override { progress_ = fraction; }
  void hear(const Event& event) override { events_.push_back(event); }
  void hear(const Sample& sample) override;
  void begin_run(const System& system, const std::vector<ProbeRow>& probes, bool energy) override;
  void take(AnyRecord record, const Scene& scene) override;

  void stop() { stop_ = true; }
  double progress() const { return progress_; }

  // Nothing of a command that ended without a record.
  const std::optional<AnyRecord>& record() const { return record_; }
  const Scene& scene() const { return scene_; }
  const std::vector<Event>& events() const { return events_; }
  // Of a run with --record samples.
  const Rows* samples() const { return samples_.get(); }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<double> progress_{0.0};
  std::optional<AnyRecord> record_;
  Scene scene_;
  std::vector<Event> events_;
  std::unique_ptr<Rows> samples_;
  const System* system_ = nullptr;
  const std::vector<ProbeRow>* probes_ = nullptr;
};

// Does the command without the interpreter's lock. `progress`: called with a number from 0 to 1, or
// None. Throws what the command threw; an interrupt raises Python's own exception, with the
// attribute `result` where something was finished.
std::shared_ptr<FoundResult> run_in_process(Command command, const pybind11::object& progress);

}  // namespace graze
