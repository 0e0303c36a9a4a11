// Statistics of a run: of every place and every stop, and tables over shares of time, frequencies
// and bins.
#include <cmath>
#include <iterator>

#include "graze/record/described/detail/shared_parts.hpp"

namespace graze {
namespace {

void describe_place(ResultVisitor& v, const MeasuredPlace& place, const Amplitude& measured,
                    const PlaceStatistics& statistics) {
  v.row("statistics", [&] {
    v.field(Field{"place", "", "as `probe_1` or `stop_1`"}, place.name('_'));
    v.field({"mean", "", "over time"}, measured.mean);
    v.field({"rms", "", "about zero"}, measured.rms);
    v.field({"standard_deviation", "", "rms about the mean"}, measured.standard_deviation());
    v.field({"max", ""}, measured.highest);
    v.field({"min", ""}, measured.lowest);
  });
  v.values({"levels", "", "exceeded for the `shares` of time"}, statistics.levels);
  v.values({"psd", "", "power spectral density at the `frequencies`, unit^2/Hz"},
           statistics.density);
}

void describe_bins(ResultVisitor& v, const char* name, const Field& width, const char* what,
                   const BinCounts& bins, std::size_t stop) {
  v.part({name, "", what}, [&] {
    v.field(width, bins.width);
    v.values({"counts", "", "the first from zero on"}, bins.counts);
    v.list(Field{"bins"}.tabular(), bins.counts, [&](long long count, std::size_t k) {
      v.row("histograms", [&] {
        v.field({"stop"}, stop + 1);
        v.field({"of"}, std::string_view(name));
        v.field({"low"}, static_cast<double>(k) * bins.width);
        v.field({"high"}, static_cast<double>(k + 1) * bins.width);
        v.field({"count"}, count);
      });
    });
  });
}

void describe_stop(ResultVisitor& v, std::size_t i, const StopLoad& load, double duration,
                   const StopStatistics& statistics) {
  const auto each_second = [&](double amount) {
    return only_if(duration > 0.0, amount / duration);
  };
  const bool met = load.impacts > 0, touched = statistics.contacts > 0;
  v.row("stop_statistics", [&] {
    v.field({"stop", "", "from 1"}, i + 1);
    v.field({"impacts", "", "and contacts begun"}, load.impacts);
    v.field({"impact_rate", "1/s"}, each_second(static_cast<double>(load.impacts)));
    v.field({"mean_speed", "m/s", "of approach"}, only_if(met, statistics.mean_speed));
    v.field({"largest_speed", "m/s"}, only_if(met, statistics.largest_speed));
    v.field({"impulse", "N s", "in total"}, load.impulse);
    v.field({"mean_impulse", "N s", "for each impact"},
            only_if(met, load.impulse / static_cast<double>(load.impacts)));
    v.field({"mean_force", "N"}, each_second(load.impulse));
    v.field({"rms_force", "N", "null where impacts on a rigid stop, which have no force, act"},
            load.rms_force);
    v.field({"peak_force", "N"}, load.peak_force);
    v.field({"contacts", "", "ended: with a spring, or held by a rigid stop"}, statistics.contacts);
    v.field({"mean_contact", "s"}, only_if(touched, statistics.mean_contact));
    v.field({"longest_contact", "s"}, only_if(touched, statistics.longest_contact));
    v.field({"energy_lost", "J", "at the stop"}, statistics.energy_lost);
    v.field({"work_rate", "W", "energy lost per time"}, each_second(statistics.energy_lost));
  });
  describe_bins(v, "speeds", {"speed_width", "m/s", "of a bin"},
                "of approach, how many in each bin", statistics.speeds, i);
  describe_bins(v, "durations", {"duration_width", "s", "of a bin"},
                "of contacts, how many in each bin", statistics.durations, i);
}

// A table with a column for every place: `numbers` of one of them, beside those of `key`.
template <class Numbers>
void describe_columns(ResultVisitor& v, const char* table, const Field& key,
                      const std::vector<double>& keys, const SimulationRecord& record,
                      const Numbers& numbers) {
  v.list(Field{table}.tabular(), keys, [&](double at_key, std::size_t k) {
    v.row(table, [&] {
      v.field(key, at_key);
      for (std::size_t i = 0; i < record.places.size(); ++i) {
        const PlaceStatistics* at = entry(record.statistics->places, i);
        v.field({record.places[i].name('_')}, at ? number_at(numbers(*at), k) : NAN);
      }
    });
  });
}

}  // namespace

void describe_statistics(ResultVisitor& v, const SimulationRecord& record) {
  const RunStatistics& all = *record.statistics;
  const Amplitudes& measured = held(record.run.amplitudes);
  const std::vector<double> shares(std::begin(kExceededShares), std::end(kExceededShares));
  const std::vector<double> frequencies = all.frequencies();
  v.part({"statistics", "", "with `--statistics`"}, [&] {
    v.field({"measured_time", "s"}, measured.duration);
    v.field({"sample_rate", "1/s", "of the samples behind levels and densities"}, all.sample_rate);
    v.field({"samples"}, all.samples);
    v.field({"segment", "s", "of the power spectral density"}, all.segment);
    v.field({"segments", "", "that it is the mean of"}, all.segments);
    v.values({"shares", "", "of time"}, shares);
    v.values({"frequencies", "Hz"}, frequencies);
    v.list({"places", "", "at every probe and stop"}, record.places,
           [&](const MeasuredPlace& place, std::size_t i) {
             const Amplitude* row = entry(measured.rows, i);
             const PlaceStatistics* at = entry(all.places, i);
             describe_place(v, place, row ? *row : Amplitude{}, at ? *at : PlaceStatistics{});
           });
    v.list({"stops", "", "of every stop"}, measured.stops,
           [&](const StopLoad& load, std::size_t i) {
             const StopStatistics* at = entry(all.stops, i);
             describe_stop(v, i, load, measured.duration, at ? *at : StopStatistics{});
           });
    describe_columns(
        v, "exceedance", {"share", "", "of time"}, shares, record,
        [](const PlaceStatistics& at) -> const auto& { return at.levels; });
    describe_columns(
        v, "psd", {"frequency", "Hz"}, frequencies, record,
        [](const PlaceStatistics& at) -> const auto& { return at.density; });
  });
}

}  // namespace graze
