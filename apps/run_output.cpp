#include "run_output.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "caller.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/records.hpp"
#include "graze/record/section.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/json/json.hpp"

namespace graze {
namespace {

// A picture shows the end of a run, this much of it at most.
constexpr std::size_t kPictureEvents = 100'000;
// What is kept for a picture that nobody asked for yet has so many numbers, some megabytes.
constexpr std::size_t kStoredNumbers = 100'000;

}  // namespace

RunOutput::RunOutput(const SimulateCommand& command, const System& system,
                     const std::vector<ProbeRow>& probes, std::optional<RunSection> section,
                     std::optional<StatisticsCollector> statistics, const Rate& rate, double end)
    : system_(system),
      probes_(probes),
      caller_(command.caller),
      records_events_(command.record != "none"),
      records_samples_(command.record == "samples"),
      writes_document_(command.json || !command.out.empty()),
      samples_all_(!command.plot.empty() || records_samples_),
      draws_((!command.plot.empty() || !command.out.empty()) && !section),
      // Beside the results, where room for them is needed anyway.
      events_(command.out.empty() ? Spool() : Spool(command.out)),
      section_(std::move(section)),
      statistics_(std::move(statistics)),
      rate_(rate),
      most_samples_(command.show == RunPicture::kSpectrum ? kSpectrumSamples : kPictureSamples) {
  const auto numbers = static_cast<std::size_t>(2 * system.modes());
  if (command.plot.empty()) most_samples_ = std::min(kPictureSamples, kStoredNumbers / numbers + 1);
  if (draws_ && !samples_all_)
    shown_from_ = std::max(0.0, end - static_cast<double>(most_samples_ - 1) / rate_.rate);
  if (statistics_ && !records_samples_)
    shown_from_ = draws_ ? std::min(shown_from_, statistics_->from()) : statistics_->from();
  if (caller_)
    caller_->begin_run(
        system, probes, command.keeps_balance(),
        records_samples_ ? end * rate.rate / static_cast<double>(rate.stride) + 1.0 : 0.0);
  if (command.out.empty()) return;
  const std::filesystem::path folder = command.out;
  if (records_events_) {
    event_table_.emplace(folder / "events.csv");
    event_table_->append(events_csv_header());
  }
  if (records_samples_ && command.sample_format == "npz") {
    sample_arrays_.emplace(folder / "samples.npz",
                           sample_columns(system, command.keeps_balance(), probes));
  } else if (records_samples_) {
    sample_table_.emplace(folder / "samples.csv");
    sample_table_->append(samples_csv_header(system, command.keeps_balance(), probes));
  }
}

void RunOutput::add(const Event& event) {
  if (section_) section_->add(event);
  if (statistics_) statistics_->add(event);
  if (records_events_) {
    excerpt_.add(event);
    if (caller_) caller_->hear(event);
    if (writes_document_) add_event_json(event, events_);
    if (event_table_) event_table_->append(events_csv_row(event));
  }
  if (draws_ && event.time >= shown_from_) {
    last_events_.push_back(event);
    trim();
  }
}

void RunOutput::add(const Sample& sample) {
  if (section_) section_->add(system_, sample);
  const bool tabled =
      rate_.stride == 1 || std::llround(sample.time * rate_.rate) % rate_.stride == 0;
  if (statistics_ && tabled) statistics_->add(sample);
  if (caller_ && records_samples_ && tabled) caller_->hear(sample);
  if (sample_table_ && tabled) sample_table_->append(samples_csv_row(system_, sample, probes_));
  if (sample_arrays_ && tabled) write_sample_row(system_, sample, probes_, sample_arrays_->add());
  if (draws_) {
    last_samples_.push_back(sample);
    trim();
  }
}

// Events from before the oldest sample would stand outside the picture.
void RunOutput::trim() {
  while (last_samples_.size() > most_samples_) last_samples_.pop_front();
  while (!last_events_.empty() &&
         (last_events_.size() > kPictureEvents ||
          (!last_samples_.empty() && last_events_.front().time < last_samples_.front().time)))
    last_events_.pop_front();
}

std::vector<PendingFile> RunOutput::take_tables() {
  std::vector<PendingFile> tables;
  if (event_table_) tables.push_back(std::move(*event_table_));
  if (sample_table_) tables.push_back(std::move(*sample_table_));
  if (sample_arrays_) tables.push_back(sample_arrays_->finished());
  event_table_.reset();
  sample_table_.reset();
  sample_arrays_.reset();
  return tables;
}

void RunOutput::show_in(SimulationRecord& record) {
  record.section = std::move(section_);
  if (statistics_) record.statistics = statistics_->result();
  record.excerpt = excerpt_;
  record.events.assign(last_events_.begin(), last_events_.end());
  record.samples.assign(last_samples_.begin(), last_samples_.end());
}

}  // namespace graze
