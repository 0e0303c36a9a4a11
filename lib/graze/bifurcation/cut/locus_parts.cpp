#include "graze/bifurcation/cut/detail/locus_parts.hpp"

#include <algorithm>
#include <utility>

#include "graze/bifurcation/cut/detail/open_sequence.hpp"

namespace graze {
namespace {

// Used when no boundary could be located.
OrbitLocusEnd end_at(const LocusPlace& place) {
  if (!place.boundary) return OrbitLocusEnd::kNotConverged;
  return place.boundary == LocusMargin::kFlight ? OrbitLocusEnd::kImpactsMeet
                                                : OrbitLocusEnd::kGrazing;
}

// A trace that could be followed only up to a grazing ends on it.
OrbitLocusEnd end_of_trace(const OrbitLocus& frame, const std::vector<LocusPlace>& places,
                           std::size_t side) {
  const LocusPlace& last = side == 0 ? places.front() : places.back();
  const bool stuck = frame.ends[side] == OrbitLocusEnd::kNotConverged;
  return stuck && last.boundary ? end_at(last) : frame.ends[side];
}

bool is_outside(const LocusPlace& place) { return !place.at.admissible && !place.boundary; }

class Parts {
 public:
  Parts(const LocusTrace& trace, bool keep_virtual)
      : frame_(trace.frame), places_(trace.places), keep_virtual_(keep_virtual) {}

  std::vector<OrbitLocus> divide() {
    if (frame_.ends[1] == OrbitLocusEnd::kClosed && !keep_virtual_)
      open_outside(places_, is_outside);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      LocusPlace& place = places_[i];
      const bool boundary = place.boundary.has_value(), last = i + 1 == places_.size();
      // On the boundary it grazes and does not cross; the side on which the last bit falls has no
      // meaning.
      if (boundary) place.at.admissible = true;
      const bool kept = keep_virtual_ || place.at.admissible;
      if (kept && !open_) begin(i == 0 ? end_of_trace(frame_, places_, 0) : end_at(place));
      if (kept) add(place, boundary);
      if (!kept && open_) end(OrbitLocusEnd::kNotConverged);
      // Beyond a boundary within the part, or at its far end.
      if (open_ && boundary && !keep_virtual_ && parts_.back().points.size() > 1)
        end(end_at(place));
      if (open_ && last) end(end_of_trace(frame_, places_, 1));
    }
    std::erase_if(parts_, [](const OrbitLocus& part) { return part.points.size() < 2; });
    return std::move(parts_);
  }

 private:
  void begin(OrbitLocusEnd how) {
    parts_.push_back(frame_);
    parts_.back().ends[0] = how;
    open_ = true;
  }

  void end(OrbitLocusEnd how) {
    parts_.back().ends[1] = how;
    open_ = false;
  }

  void add(const LocusPlace& place, bool boundary) {
    parts_.back().points.push_back(place.at);
    std::string label = place.label;
    if (boundary && place.boundary != LocusMargin::kFlight)
      label = std::string(label_of(frame_.kind)) + "GR";
    if (!label.empty()) parts_.back().special.push_back({label, "", place.at, place.other_angle});
  }

  const OrbitLocus& frame_;
  std::vector<LocusPlace> places_;
  bool keep_virtual_;
  bool open_ = false;
  std::vector<OrbitLocus> parts_;
};

}  // namespace

bool is_cut_short(const OrbitLocus& locus) {
  return std::any_of(locus.ends.begin(), locus.ends.end(), [](OrbitLocusEnd end) {
    return end == OrbitLocusEnd::kNotConverged || end == OrbitLocusEnd::kStepLimit;
  });
}

std::vector<OrbitLocus> locus_parts(const LocusTrace& trace, bool keep_virtual) {
  return Parts(trace, keep_virtual).divide();
}

}  // namespace graze
