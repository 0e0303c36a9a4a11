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
  kAt,             // s, since the flight began
  kWindow,         // until the period ends
  kLocal,          // start of the flight, since the start of the period
  kPeriod,         // s
  kHalfFrequency,  // of the forcing
  kHalfPhase,      // of the forcing at the period's start
  kCosine,         // of the forcing's phase when the flight began
  kSine,
  kSlowest,     // m/s, slowest impact after which the rest of a chatter is not considered
  kFrom,        // stop that the flight leaves; -1: none
  kHit,         // stop that is approached
  kCorrection,  // last step of Halley's method; infinite before it
  kThird,       // bound on the third derivative where it began
  kLooks,       // evaluations of this flight
  kSpeed,       // approach speed at the contact, m/s
  kForcingTurnRe,
  kForcingTurnIm,  // e^{i W s} - 1 at `at`
  kCount
};

// Rows of a mode.
enum class LaneModeRow {
  kDecay,          // delta, 1/s
  kHalfFrequency,  // of the damped oscillation
  kRate,           // |l|, which is omega
  kPerRate,        // 1/omega
  kPerFrequency,   // 1/(2 kHalfFrequency)
  kResponseRe,     // P
  kResponseIm,
  kOffset,     // c/w^2
  kForce,      // f
  kAmplitude,  // Z, its two parts and its size
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
  kHarmonicRe,  // of the gap: weight of e^{i theta}
  kHarmonicIm,
  kHarmonicSize,
  kForcedRe,  // times e^{i theta} when the flight began
  kForcedIm,
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

class LaneColumns {
 public:
  LaneColumns(int modes, int stops)
      : modes_(static_cast<std::size_t>(modes)),
        stops_(static_cast<std::size_t>(stops)),
        numbers_(new (std::align_val_t{kAlignment}) double[length()]()) {}

  std::size_t modes() const { return modes_; }
  std::size_t stops() const { return stops_; }

  double* row(LaneRow row) const { return at(static_cast<std::size_t>(row)); }
  double* row(LaneModeRow row, std::size_t mode) const {
    return at(kOwn + static_cast<std::size_t>(row) * modes_ + mode);
  }
  double* row(LaneStopRow row, std::size_t stop) const {
    return at(kOwn + kOfMode * modes_ + static_cast<std::size_t>(row) * stops_ + stop);
  }
  double* row(LanePairRow row, std::size_t stop, std::size_t mode) const {
    return at(kOwn + kOfMode * modes_ + kOfStop * stops_ +
              (static_cast<std::size_t>(row) * stops_ + stop) * modes_ + mode);
  }

 private:
  static constexpr std::size_t kAlignment = 64;  // bytes, of the longest vector
  struct Free {
    void operator()(double* numbers) const {
      ::operator delete[](numbers, std::align_val_t{kAlignment});
    }
  };
  static constexpr std::size_t kOwn = static_cast<std::size_t>(LaneRow::kCount),
                               kOfMode = static_cast<std::size_t>(LaneModeRow::kCount),
                               kOfStop = static_cast<std::size_t>(LaneStopRow::kCount),
                               kOfPair = static_cast<std::size_t>(LanePairRow::kCount);
  std::size_t length() const {
    return kLanes * (kOwn + kOfMode * modes_ + kOfStop * stops_ + kOfPair * stops_ * modes_);
  }
  double* at(std::size_t row) const { return numbers_.get() + kLanes * row; }

  std::size_t modes_, stops_;
  std::unique_ptr<double[], Free> numbers_;
};

}  // namespace graze
