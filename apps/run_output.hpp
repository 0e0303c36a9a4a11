// Where the events and samples of a run go while it runs.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "command.hpp"
#include "graze/record/file/files.hpp"
#include "graze/record/file/numpy_archive.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/record/records.hpp"

namespace graze {

// The end of a run that pictures show: 12 forcing periods, and of spectra 64.
inline constexpr std::size_t kPictureSamples = 12 * 400, kSpectrumSamples = 64 * 400;

// Takes what the run hands out: rows of the tables in the output folder, the events of the
// document, and the few that the printed table and the picture show. Memory stays bounded however
// long the run is. Throws FileError where something cannot be written.
class RunOutput {
 public:
  // How often it is handed a sample, 1/s, and every how many of them stands in the table and counts
  // in the statistics: a picture wants more than a table may hold.
  struct Rate {
    double rate = 0.0;
    long long stride = 1;
  };
  // `system` and `probes` must outlive it. `end` of the run, s.
  RunOutput(const SimulateCommand& command, const System& system,
            const std::vector<ProbeRow>& probes, std::optional<RunSection> section,
            std::optional<StatisticsCollector> statistics, const Rate& rate, double end);

  void add(const Event& event);
  void add(const Sample& sample);

  // s: from when on samples are wanted.
  double samples_from() const { return shown_from_; }

  bool wants_events() const {
    return records_events_ || draws_ || statistics_ || is_seen(DiagramSection::kImpact);
  }
  bool wants_samples() const {
    return records_samples_ || draws_ || statistics_ || is_seen(DiagramSection::kStroboscopic);
  }

  // The document's events; empty unless a document is wanted.
  Spool& events() { return events_; }
  // The tables, complete. Empties this.
  std::vector<PendingFile> take_tables();
  // Fills in what the record shows of events and samples, the section and the statistics.
  void show_in(SimulationRecord& record);

 private:
  void trim();
  bool is_seen(DiagramSection by) const { return section_ && section_->kind() == by; }

  const System& system_;
  const std::vector<ProbeRow>& probes_;
  Caller* caller_;  // null: none
  // Draws: now, or later from the folder.
  bool records_events_, records_samples_, writes_document_, samples_all_, draws_;
  double shown_from_ = 0.0;  // s
  std::optional<PendingFile> event_table_, sample_table_;
  std::optional<NumpyArchive> sample_arrays_;  // in place of a table
  Spool events_;
  EventExcerpt excerpt_;
  std::deque<Event> last_events_;
  std::deque<Sample> last_samples_;
  std::optional<RunSection> section_;
  std::optional<StatisticsCollector> statistics_;
  Rate rate_;
  std::size_t most_samples_;
};

}  // namespace graze
