// The command simulate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/run_picture.hpp"
#include "graze/record/section.hpp"
#include "options/picture.hpp"
#include "options/shared.hpp"

namespace graze {

struct SimulateCommand : MotionOptions {
  std::optional<double> duration;  // s
  std::optional<long long> periods;
  std::string record = "events";      // none | events | samples
  std::optional<double> sample_rate;  // 1/s
  std::string sample_format = "csv";  // csv | npz
  bool energy = false;                // keep the energy balance
  // A picture of the motion shows the energy balance.
  bool keeps_balance() const { return energy || (!plot.empty() && !section); }
  bool amplitudes = false;  // measure the motion
  bool statistics = false;  // the same and more, from samples and events
  bool measures() const { return amplitudes || statistics; }
  bool samples_in_full() const { return record == "samples" || statistics; }
  std::optional<double> amplitudes_from;  // s
  std::optional<double> psd_segment;      // s
  std::optional<int> force_windows;       // over which the forces of stops are averaged
  std::string resume;                     // file or folder; empty: from the scene's initial state
  std::optional<DiagramSection> section;
  std::optional<long long> transient;  // forcing periods that it leaves out
  RunPicture show = RunPicture::kMotion;
  std::vector<double> shape_times;  // s, of the shapes shown
};

void describe_run(auto& v, SimulateCommand& o) {
  v.heading("Motion");
  v.option("duration", o.duration, "S", "Simulated time, s; needed without forcing",
           at_least("a number of seconds, 0 or more", 0.0), kOfResult);
  v.option("periods", o.periods, "K",
           "Simulated forcing periods, instead of --duration (default 100)",
           whole_number("a whole number, 0 or more", 0.0, kMostCounted), Excludes{{"duration"}},
           kOfResult);
  v.option("record", o.record, "WHAT", "What to keep: none, events or samples",
           Choices{{"none", "events", "samples"}}, kOfResult);
  v.option("sample_rate", o.sample_rate, "RATE",
           "Samples per second with --record samples or --statistics (default: 100 a forcing "
           "period; without forcing, of the slowest mode)",
           above_zero(), kOfResult);
  v.option("sample_format", o.sample_format, "WHAT",
           "With --record samples and --out: samples.csv, or samples.npz with an array for NumPy "
           "of every column",
           Choices{{"csv", "npz"}});
  v.flag("energy", o.energy,
         "Keep the energy balance: the work of every effect, and the error of their sum (--plot "
         "keeps it too)",
         kOfResult);
  v.flag("amplitudes", o.amplitudes,
         "Measure the motion: largest, smallest and root mean square values at the probes and "
         "stops, forces and impulses of the stops");
  v.flag(
      "statistics", o.statistics,
      "What --amplitudes measures, and of every probe and stop the standard deviation, the levels "
      "exceeded for shares of the time and the power spectral density; of every stop speeds, "
      "contacts, work rate and histograms",
      kOfResult);
  v.option("amplitudes_from", o.amplitudes_from, "S",
           "With --amplitudes, --statistics or --forces: time that is measured from, s (default: "
           "0)",
           at_least("a time in s, 0 or more", 0.0), kOfResult);
  v.option(
      "psd_segment", o.psd_segment, "S",
      "Length of the segments of the power spectral density, s (default: whole forcing periods, "
      "64 at most, for eight segments or more)",
      above_zero(), Needs{{"statistics"}}, kOfResult);
  v.option("forces", o.force_windows, "N",
           "Keep the force of every stop over time, of impacts and while it holds, as means over N "
           "equal windows of the run; --out writes them, --show forces draws them",
           whole_number("a whole number from 1 to 100000", 1.0, 1e5), kOfResult);
}

void describe(auto& v, SimulateCommand& o) {
  v.command("simulate", "Follow the motion, every impact certified",
            "simulate data/scenes/02_wagg_momentum.toml --duration 1 --energy");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<SimulationRecord>);
  describe_run(v, o);
  v.heading("Section");
  v.choice("section", o.section, kDiagramSections, "WHAT",
           "Poincare section, which --plot then shows: impact (phase and speed of every impact) or "
           "stroboscopic (displacement and velocity at the stops once a forcing period)",
           former_section_name(), kOfResult);
  v.option(
      "transient", o.transient, "K",
      "Forcing periods at the beginning that the section leaves out (default: a tenth of the run)",
      whole_number("a whole number, 0 or more", 0.0, kMostCounted), Needs{{"section"}}, kOfResult);
  v.heading(kPicturesGroup);
  v.choice("show", o.show, kRunPictures, "WHAT",
           "With --plot: the motion; returns (each impact over the one before, with --section "
           "impact); spectrum (amplitudes over the frequency, of the last 64 forcing periods); psd "
           "(power spectral density, with --statistics); shapes (of the beam, with --shapes-at); "
           "or forces (of every stop over time)",
           Needs{{"plot"}});
  v.option("shapes_at", o.shape_times, "T,..",
           "With --show shapes: times, s, several, separated by commas",
           at_least("a time in s, 0 or more", 0.0), kWithCommas, Needs{{"show"}});
  describe_closure_speed(v, o);
  v.heading("Motion");
  v.option("resume", o.resume, "FILE|DIR",
           "Go on from the run in a folder that --out wrote; the end still counts from t = 0",
           kOfResult);
  describe_limits(v, o);
}

}  // namespace graze
