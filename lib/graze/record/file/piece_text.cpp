#include "graze/record/file/detail/piece_text.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vector>

namespace graze {
namespace {

using Json = nlohmann::json;

// JSON has no word for these.
constexpr const char *kInfinite = "inf", *kMinusInfinite = "-inf", *kNoNumber = "nan";

// The fields of a value, one after the other, go to `archive` and come from it alike.
template <class Archive, class Value>
void visit(Archive& archive, Value& value);

class Writer {
 public:
  static constexpr bool kReads = false;

  void operator()(double value) {
    if (std::isfinite(value))
      array_.push_back(value);
    else
      array_.push_back(std::isnan(value) ? kNoNumber : value > 0.0 ? kInfinite : kMinusInfinite);
  }
  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      array_.push_back(static_cast<int>(value));
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      array_.push_back(value);
    } else {
      Writer inner;
      visit(inner, value);
      array_.push_back(std::move(inner.array_));
    }
  }
  std::string take() const { return array_.dump(-1, ' ', false, Json::error_handler_t::replace); }

 private:
  Json array_ = Json::array();
};

// Throws Json::exception where the text holds something else.
class Reader {
 public:
  static constexpr bool kReads = true;

  explicit Reader(const Json& array) : array_(array) {}

  void operator()(double& value) {
    const Json& json = next();
    if (!json.is_string()) {
      value = json.get<double>();
      return;
    }
    const double infinity = std::numeric_limits<double>::infinity();
    value = json == kInfinite        ? infinity
            : json == kMinusInfinite ? -infinity
                                     : std::numeric_limits<double>::quiet_NaN();
  }
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(next().get<int>());
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      value = next().get<T>();
    } else {
      Reader inner(next());
      visit(inner, value);
    }
  }
  std::size_t size() const { return array_.size(); }

 private:
  const Json& next() { return array_.at(i_++); }

  const Json& array_;
  std::size_t i_ = 0;
};

template <class Archive, class T>
void fields(Archive& archive, std::vector<T>& values) {
  if constexpr (Archive::kReads) values.resize(archive.size());
  for (T& value : values) archive(value);
}
template <class Archive, class T>
void fields(Archive& archive, std::optional<T>& value) {
  if constexpr (Archive::kReads)
    if (archive.size() > 0) value.emplace();
  if (value) archive(*value);
}
template <class Archive>
void fields(Archive& archive, Vector& values) {
  if constexpr (Archive::kReads) values.resize(static_cast<Eigen::Index>(archive.size()));
  for (double& value : values) archive(value);
}
template <class Archive>
void fields(Archive& archive, State& state) {
  archive(state.q), archive(state.qdot);
}
template <class Archive>
void fields(Archive& archive, MetImpact& impact) {
  archive(impact.period), archive(impact.stop), archive(impact.phase), archive(impact.speed);
}
template <class Archive>
void fields(Archive& archive, SweepRow::StopState& state) {
  archive(state.stop), archive(state.displacement), archive(state.velocity);
}
template <class Archive>
void fields(Archive& archive, SettledMotion& motion) {
  archive(motion.kind), archive(motion.period), archive(motion.near), archive(motion.remaining);
  archive(motion.sticks), archive(motion.at_start), archive(motion.at_end);
  archive(motion.periods), archive(motion.impacts_met), archive(motion.impacts);
  archive(motion.period_states), archive(motion.classification);
}
template <class Archive>
void fields(Archive& archive, Exponents& exponents) {
  archive(exponents.values), archive(exponents.errors), archive(exponents.lost);
  archive(exponents.periods), archive(exponents.impacts), archive(exponents.failure);
  archive(exponents.end);
}
template <class Archive>
void fields(Archive& archive, Complex& number) {
  double re = number.real(), im = number.imag();
  archive(re), archive(im);
  number = {re, im};
}
template <class Archive>
void fields(Archive& archive, Amplitude& row) {
  archive(row.highest), archive(row.lowest), archive(row.mean), archive(row.rms);
  archive(row.speed), archive(row.harmonic);
}
template <class Archive>
void fields(Archive& archive, StopLoad& load) {
  archive(load.impacts), archive(load.impulse), archive(load.peak_force), archive(load.rms_force);
}
template <class Archive>
void fields(Archive& archive, Amplitudes& amplitudes) {
  archive(amplitudes.duration), archive(amplitudes.rows), archive(amplitudes.stops);
}
template <class Archive>
void fields(Archive& archive, SweepRow& row) {
  archive(row.value), archive(row.status), archive(row.start), archive(row.motion);
  archive(row.stop_states), archive(row.exponents), archive(row.amplitudes), archive(row.message);
}
template <class Archive>
void fields(Archive& archive, AttractorClass& attractor) {
  archive(attractor.status), archive(attractor.kind);
  archive(attractor.period), archive(attractor.impacts);
}
template <class Archive>
void fields(Archive& archive, MapCell& cell) {
  archive(cell.is_known), archive(cell.attractor), archive(cell.place);
  archive(cell.impacts_per_period), archive(cell.peak_speed), archive(cell.stuck_part);
  archive(cell.exponent), archive(cell.amplitudes), archive(cell.message);
}
template <class Archive>
void fields(Archive& archive, SettledCell& settled) {
  archive(settled.cell), archive(settled.period_states);
}
template <class Archive>
void fields(Archive& archive, RunImpact& impact) {
  archive(impact.time), archive(impact.stop), archive(impact.speed);
}
template <class Archive>
void fields(Archive& archive, ValueRun& run) {
  archive(run.value), archive(run.outcome), archive(run.message), archive(run.impacts);
  archive(run.peaks), archive(run.ends);
}
template <class Archive>
void fields(Archive& archive, MotionDifference& difference) {
  archive(difference.agreeing), archive(difference.first);
  archive(difference.first_time), archive(difference.first_speed);
  archive(difference.is_same_attractor), archive(difference.displacement);
  archive(difference.velocity), archive(difference.energy), archive(difference.taken);
}
template <class Archive>
void fields(Archive& archive, ComparedCell& cell) {
  archive(cell.is_known), archive(cell.one), archive(cell.other), archive(cell.difference);
  archive(cell.message);
}

// A writer leaves what it is given as it is.
template <class Archive, class Value>
void visit(Archive& archive, Value& value) {
  fields(archive, const_cast<std::remove_const_t<Value>&>(value));
}

template <class Piece>
std::string text_of(const Piece& piece) {
  Writer writer;
  visit(writer, piece);
  return writer.take();
}

template <class Piece>
bool read(const std::string& text, Piece& piece) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) return false;
  try {
    Reader reader(json);
    visit(reader, piece);
  } catch (const Json::exception&) {
    return false;
  }
  return true;
}

}  // namespace

std::string piece_text(const SweepRow& row) { return text_of(row); }
std::string piece_text(const SettledCell& cell) { return text_of(cell); }
std::string piece_text(const ValueRun& run) { return text_of(run); }
std::string piece_text(const ComparedCell& cell) { return text_of(cell); }

bool read_piece(const std::string& text, SweepRow& row) { return read(text, row); }
bool read_piece(const std::string& text, SettledCell& cell) { return read(text, cell); }
bool read_piece(const std::string& text, ValueRun& run) { return read(text, run); }
bool read_piece(const std::string& text, ComparedCell& cell) { return read(text, cell); }

}  // namespace graze
