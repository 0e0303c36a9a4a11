// The numbers of motions that are flown side by side, one motion to a lane of the vector unit: each
// row holds one number of every lane.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace graze {

// Several vectors of the longest kind, so that the processor is busy while one waits.
inline constexpr std::size_t kLanes = 16;

// The stage of a lane, as a number.
enum class LaneStage {
  kIdle,     // no motion, or one that is followed elsewhere
  kBegin,    // at the start of a forcing period, in the state kEnd, kAfterRate
  kSearch,   // for a first contact, from `at` on
  kFinish,   // by Halley's method, inside the ball in which it is certain to converge
  kContact,  // there, at `at`
  kEnd       // of the forcing period, at `at`
};

// Rows of a lane as a whole. Times in s, angles in rad; phases and frequencies halved.
enum class LaneRow {
  kStage,
  kAt,          // s, since the flight began
  kWindow,      // until the period ends
  kLocal,       // start of the flight, since the start of the period
  kPeriod,      // s
  kSlowest,     // m/s, slowest impact after which the rest of a chatter is not considered
  kFrom,        // stop that the flight leaves; -1: none
  kHit,         // stop that is approached
  kCorrection,  // last step of Halley's method; infinite before it
  kThird,       // bound on the third derivative where it began
  kLooks,       // evaluations of this flight
  kSpeed,       // approach speed at the contact, m/s
  kCount
};

// Rows of a harmonic of the forcing.
enum class LaneHarmonicRow {
  kHalfFrequency,
  kHalfPhase,  // at the period's start
  kCosine,     // of its phase when the flight began
  kSine,
  kEndCosine,  // and where it ends
  kEndSine,
  kTurnRe,  // e^{i W s} - 1 at `at`
  kTurnIm,
  kCount
};

// Rows of a mode.
enum class LaneModeRow {
  kDecay,          // delta, 1/s
  kHalfFrequency,  // of the damped oscillation
  kRate,           // |l|, which is omega
  kPerRate,        // 1/omega
  kPerFrequency,   // 1/(2 kHalfFrequency)
  kOffset,         // c/w^2
  kForce,          // largest possible |f|
  kAmplitude,      // Z, its two parts and its size
  kAmplitudeIm,
  kSize,
  kStart,  // displacement and velocity when the flight began
  kStartRate,
  kEnd,  // at `at`, before an impact
  kEndRate,
  kAfterRate,  // velocity after the impact
  kTurnRe,     // e^{l s} - 1 at `at`
  kTurnIm,
  kTurnDecay,  // e^{-delta s}
  kShare,      // of an offset that settles a contact, and what it is formed from
  kCount
};

// Rows of a stop.
enum class LaneStopRow {
  kGap,
  kRestitution,
  kNorm,        // what an impulse is divided by: |b|^2 where it acts along the row, else 1
  kStartValue,  // of the gap; 0 where the flight leaves the stop
  kStartNoise,
  kClearUntil,  // s, it is open for certain
  kBall,        // within which it is certainly met, s; infinite: not known
  kValue,       // of the gap at `at`, and its derivatives
  kSlope,
  kCurvature,
  kThird,
  kBound,  // see CurvePoint
  kNoise,
  kForcedSlope,  // the forcing's part
  kForcedCurvature,
  kForcedThird,
  kDoubtful,  // 1 where the gap is within its rounding
  kCount
};

// Rows of a stop and a mode.
enum class LanePairRow {
  kRow,         // b
  kDirection,   // d; b where it is b/|b|^2, so that rounding has no bias
  kFormedFrom,  // see ArcCurve
  kFall,        // largest possible fall from here on
  kSlowSlope,   // sums over the forcing and the modes up to this one
  kSlowCurvature,
  kSlowThird,
  kCount
};

// Rows of a mode and a harmonic.
enum class LaneAnswerRow {
  kRe,  // P
  kIm,
  kCount
};

// Rows of a stop and a harmonic.
enum class LaneGapRow {
  kRe,  // of the gap: weight of e^{i theta}
  kIm,
  kSize,
  kForcedRe,  // times e^{i theta} when the flight began
  kForcedIm,
  kCount
};

class LaneColumns {
 public:
  LaneColumns(std::size_t modes, std::size_t stops, std::size_t harmonics)
      : modes_(modes),
        stops_(stops),
        harmonics_(harmonics),
        numbers_(new (std::align_val_t{kAlignment}) double[kLanes * first(7)]()) {}

  std::size_t modes() const { return modes_; }
  std::size_t stops() const { return stops_; }
  std::size_t harmonics() const { return harmonics_; }

  double* row(LaneRow row) const { return at(0, row, 0, 1); }
  double* row(LaneModeRow row, std::size_t mode) const { return at(first(1), row, mode, modes_); }
  double* row(LaneStopRow row, std::size_t stop) const { return at(first(2), row, stop, stops_); }
  double* row(LanePairRow row, std::size_t stop, std::size_t mode) const {
    return at(first(3), row, stop * modes_ + mode, stops_ * modes_);
  }
  double* row(LaneHarmonicRow row, std::size_t harmonic) const {
    return at(first(4), row, harmonic, harmonics_);
  }
  double* row(LaneAnswerRow row, std::size_t mode, std::size_t harmonic) const {
    return at(first(5), row, mode * harmonics_ + harmonic, modes_ * harmonics_);
  }
  double* row(LaneGapRow row, std::size_t stop, std::size_t harmonic) const {
    return at(first(6), row, stop * harmonics_ + harmonic, stops_ * harmonics_);
  }

 private:
  static constexpr std::size_t kAlignment = 64;  // bytes, of the longest vector
  struct Free {
    void operator()(double* numbers) const {
      ::operator delete[](numbers, std::align_val_t{kAlignment});
    }
  };
  // Of the kinds of rows, in this order, the first of a kind; `kind` 7: their number.
  std::size_t first(int kind) const {
    const std::size_t lengths[] = {
        static_cast<std::size_t>(LaneRow::kCount),
        static_cast<std::size_t>(LaneModeRow::kCount) * modes_,
        static_cast<std::size_t>(LaneStopRow::kCount) * stops_,
        static_cast<std::size_t>(LanePairRow::kCount) * stops_ * modes_,
        static_cast<std::size_t>(LaneHarmonicRow::kCount) * harmonics_,
        static_cast<std::size_t>(LaneAnswerRow::kCount) * modes_ * harmonics_,
        static_cast<std::size_t>(LaneGapRow::kCount) * stops_ * harmonics_};
    std::size_t sum = 0;
    for (int k = 0; k < kind; ++k) sum += lengths[k];
    return sum;
  }
  template <class Row>
  double* at(std::size_t first, Row row, std::size_t place, std::size_t places) const {
    return numbers_.get() + kLanes * (first + static_cast<std::size_t>(row) * places + place);
  }

  std::size_t modes_, stops_, harmonics_;
  std::unique_ptr<double[], Free> numbers_;
};

}  // namespace graze
