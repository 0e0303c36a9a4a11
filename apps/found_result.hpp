// The result of a command that was called within a process, with all that its run recorded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "caller.hpp"
#include "graze/report/csv/result_table.hpp"
#include "rows.hpp"

namespace graze {

class FoundResult final : public Caller {
 public:
  const std::atomic<bool>& interrupted() const override { return stop_; }
  void hear_progress(double fraction) override { progress_ = fraction; }
  void hear(const Event& event) override { events_.push_back(event); }
  void hear(const Sample& sample) override;
  void begin_run(const System& system, const std::vector<ProbeRow>& probes, bool energy,
                 double samples) override;
  void take(AnyRecord record, const Scene& scene, std::string document) override;

  void stop() { stop_ = true; }
  double progress() const { return progress_; }

  // Nothing of a command that ended without a record.
  const std::optional<AnyRecord>& record() const { return record_; }
  const Scene& scene() const { return scene_; }
  // Of a result that was read from a folder; empty: of one that was computed.
  const std::string& stored_document() const { return document_; }
  const std::vector<Event>& events() const { return events_; }
  // Of a run with --record samples.
  const Rows* samples() const { return samples_.get(); }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<double> progress_{0.0};
  std::optional<AnyRecord> record_;
  Scene scene_;
  std::string document_;
  std::vector<Event> events_;
  std::unique_ptr<Rows> samples_;
  const System* system_ = nullptr;
  const std::vector<ProbeRow>* probes_ = nullptr;
};

// What follows needs a result with a record.
const Outcome& outcome_of(const FoundResult& result);
// What --json prints.
std::string document_of(const FoundResult& result);
// The files of --out without their endings: "events", "samples", "branches", ..
std::vector<std::string> table_names(const FoundResult& result);
// One of them, other than samples; nullopt if there is no such table.
std::optional<ResultTable> table_of(const FoundResult& result, const std::string& name);

}  // namespace graze
