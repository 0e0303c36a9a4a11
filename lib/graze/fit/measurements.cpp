#include "graze/fit/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "graze/assembly/probes.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

enum class Place { kMode, kStop, kProbe };

struct QuantityName {
  const char* name;
  Quantity quantity;
  const char* unit;  // of a probe its own
  Place of;
};
constexpr std::array<QuantityName, 8> kQuantities = {{
    {"qdot", Quantity::kRate, "kg^1/2 m/s", Place::kMode},
    {"q", Quantity::kCoordinate, "kg^1/2 m", Place::kMode},
    {"gap", Quantity::kGap, "m", Place::kStop},
    {"force", Quantity::kForce, "N", Place::kStop},
    {"displacement", Quantity::kDisplacement, "m", Place::kStop},
    {"velocity", Quantity::kVelocity, "m/s", Place::kStop},
    {"penetration", Quantity::kPenetration, "m", Place::kStop},
    {"probe_", Quantity::kProbe, "", Place::kProbe},
}};

struct NamedQuantity {
  const QuantityName* of = nullptr;
  int number = 1;  // from 1
};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// "force2": the force at the second stop; "force" that at the first.
std::optional<NamedQuantity> quantity_of(const std::string& written) {
  const std::string column = lower(written);
  const std::size_t letters = std::min(column.find_first_of("0123456789"), column.size());
  const std::string name = column.substr(0, letters), digits = column.substr(letters);
  for (const QuantityName& known : kQuantities) {
    if (name != known.name) continue;
    if (digits.empty()) return NamedQuantity{&known, 1};
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && end == digits.data() + digits.size() && number >= 1)
      return NamedQuantity{&known, number};
  }
  return {};
}

class Reader {
 public:
  Reader(const DataTable& table, const Scene& scene, const MeasurementOptions& options)
      : table_(table), scene_(scene), options_(options) {
    result_.file = table.name();
    for (std::size_t c = 0; c < table.columns(); ++c)
      if (const std::string name = lower(table.column_name(c));
          name == "time" || (name == "t" && time_.empty()))
        time_ = table.column_name(c);
  }

  Measurements read() {
    const bool pairs = table_.find("speed") && table_.find("restitution") && !table_.find("kind");
    if (pairs) {
      read_restitution();
    } else if (time_.empty()) {
      throw table_.error(
          "there is neither a column 'time' (or 't') nor the columns 'speed' and 'restitution'; "
          "allowed are speed,restitution or time, alone (impact times) or with columns such as "
          "force1, gap1, displacement1, velocity1, penetration1, q1, qdot1");
    } else if (has_response()) {
      read_response();
    } else {
      read_impacts();
    }
    if (!options_.columns.empty() && result_.kind != MeasurementKind::kResponse)
      throw InputError("--column: only columns of a response (time and what moves) are chosen");
    refuse_mixed_uncertainties();
    for (std::size_t c = 0; c < table_.columns(); ++c)
      if (!used_.count(c)) result_.unused.push_back(table_.column_name(c));
    return std::move(result_);
  }

 private:
  bool has_response() const {
    if (table_.find("kind")) return false;
    if (!options_.columns.empty()) return true;
    for (std::size_t c = 0; c < table_.columns(); ++c)
      if (quantity_of(table_.column_name(c))) return true;
    return false;
  }

  std::size_t column(const std::string& name, const std::string& unit) {
    const std::size_t c = *table_.find(name);
    used_.insert(c);
    table_.check_unit(c, unit);
    return c;
  }

  Vector numbers(std::size_t column, const std::string& unit) const {
    Vector values(static_cast<Eigen::Index>(kept_.size()));
    for (std::size_t i = 0; i < kept_.size(); ++i)
      values[static_cast<Eigen::Index>(i)] = table_.number(kept_[i], column, unit);
    return values;
  }

  void keep_all_rows() {
    kept_.resize(table_.rows());
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = i;
  }

  // The uncertainties of a column: those of the command line, of a column of its own, or of the
  // column `sigma`.
  Vector uncertainty(const std::string& name, const std::string& unit) {
    const auto count = static_cast<Eigen::Index>(kept_.size());
    for (const auto& [column, value] : options_.uncertainties)
      if (column == name) return Vector::Constant(count, value);
    for (const auto& [column, value] : options_.uncertainties)
      if (column.empty()) return Vector::Constant(count, value);
    for (const std::string& candidate : {"sigma_" + name, std::string("sigma")}) {
      if (!table_.find(candidate)) continue;
      const std::size_t c = column(candidate, unit);
      Vector values = numbers(c, unit);
      for (std::size_t i = 0; i < kept_.size(); ++i)
        if (!(values[static_cast<Eigen::Index>(i)] > 0.0))
          throw table_.cell_error(
              kept_[i], c, fmt::format("{}: a standard uncertainty must be above 0", candidate));
      return values;
    }
    return {};
  }

  void add_series(const std::string& name, const std::string& unit, std::size_t c,
                  Quantity quantity = Quantity::kCoordinate, int index = 0) {
    MeasuredSeries series{name,
                          unit_in(scene_.units, unit),
                          quantity,
                          index,
                          numbers(c, unit),
                          uncertainty(name, unit)};
    if (result_.series.empty())
      for (const std::size_t row : kept_) result_.places.push_back(table_.place(row, c));
    result_.series.push_back(std::move(series));
  }

  void read_restitution() {
    result_.kind = MeasurementKind::kRestitution;
    keep_all_rows();
    const std::size_t speed = column("speed", "m/s"), restitution = column("restitution", "1");
    result_.at = numbers(speed, "m/s");
    add_series("restitution", "", restitution);
    // The law lies between 0 and 1; measurements may be out of this range by its width.
    constexpr double kLeast = -1.0, kMost = 2.0;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (!(result_.at[k] > 0.0))
        throw table_.cell_error(i, speed, "speed: an approach speed must be above 0, in m/s");
      const double value = result_.series[0].values[k];
      if (value < kLeast || value > kMost)
        throw table_.cell_error(
            i, restitution,
            fmt::format("restitution: {:g} is far from what a restitution can be; it is a number "
                        "from 0 to 1, here -1 to 2 for what scatters",
                        value));
    }
  }

  void read_impacts() {
    result_.kind = MeasurementKind::kImpactTimes;
    if (const auto kind = table_.find("kind")) {
      used_.insert(*kind);
      for (std::size_t i = 0; i < table_.rows(); ++i)
        if (table_.text(i, *kind) == "impact" || table_.text(i, *kind) == "contact")
          kept_.push_back(i);
      if (kept_.empty())
        throw table_.name_error(*kind,
                                "kind: no row is an impact or a contact, whose times are "
                                "fitted");
    } else {
      keep_all_rows();
    }
    const std::size_t time = column(time_, "s");
    read_stops();
    add_series("time", "s", time);
    result_.at.resize(static_cast<Eigen::Index>(kept_.size()));
    std::map<int, int> count;
    std::map<int, double> last;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double value = result_.series[0].values[k];
      const int stop = result_.stops[i];
      if (value < 0.0) throw negative_time(kept_[i], time);
      if (count[stop] > 0 && !(value > last[stop])) throw falling_time(kept_[i], time, last[stop]);
      last[stop] = value;
      result_.at[k] = ++count[stop];
    }
  }

  void read_stops() {
    result_.stops.assign(kept_.size(), -1);
    if (scene_.stops.empty())
      throw table_.error("these are impact times, but the scene has no stop");
    const auto c = table_.find("stop");
    if (!c) {
      if (scene_.stops.size() > 1)
        throw table_.error(fmt::format(
            "the scene has {} stops; a column 'stop' must say which of them each time belongs to",
            scene_.stops.size()));
      return;
    }
    used_.insert(*c);
    const auto stops = static_cast<double>(scene_.stops.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const double number = table_.number(kept_[i], *c);
      if (number != std::floor(number) || number < 1.0 || number > stops)
        throw table_.cell_error(
            kept_[i], *c,
            fmt::format("stop: {:g} is not allowed; stops count from 1 to {:g}", number, stops));
      result_.stops[i] = static_cast<int>(number) - 1;
    }
  }

  void read_response() {
    result_.kind = MeasurementKind::kResponse;
    keep_all_rows();
    const std::size_t time = column(time_, "s");
    result_.at = numbers(time, "s");
    for (Eigen::Index i = 0; i < result_.at.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      if (result_.at[i] < 0.0) throw negative_time(row, time);
      if (i > 0 && !(result_.at[i] > result_.at[i - 1]))
        throw falling_time(row, time, result_.at[i - 1]);
    }
    for (const std::string& name : wanted_columns()) {
      const std::size_t c = *table_.find(name);
      const NamedQuantity quantity = *quantity_of(name);
      require_place(c, name, quantity);
      const bool of_probe = quantity.of->of == Place::kProbe;
      const std::string unit =
          of_probe
              ? probe_unit(scene_.probes[static_cast<std::size_t>(quantity.number - 1)].quantity)
              : quantity.of->unit;
      add_series(name, unit, column(name, unit), quantity.of->quantity, quantity.number - 1);
      const Vector& values = result_.series.back().values;
      if (values.size() > 1 && values.minCoeff() == values.maxCoeff())
        throw table_.cell_error(0, c,
                                fmt::format("{}: all {} values are {:g}; what does not change "
                                            "tells nothing of the parameters",
                                            name, values.size(), values[0]));
    }
  }

  void require_place(std::size_t c, const std::string& name, const NamedQuantity& quantity) const {
    const Place of = quantity.of->of;
    const int most = of == Place::kMode   ? scene_.modes()
                     : of == Place::kStop ? static_cast<int>(scene_.stops.size())
                                          : static_cast<int>(scene_.probes.size());
    const char* what = of == Place::kMode ? "mode" : of == Place::kStop ? "stop" : "probe";
    if (quantity.number > most)
      throw table_.name_error(
          c, fmt::format("{}: the scene has {} {}{}", name, most, what, most == 1 ? "" : "s"));
  }

  std::vector<std::string> wanted_columns() const {
    std::vector<std::string> known;
    for (std::size_t c = 0; c < table_.columns(); ++c)
      if (quantity_of(table_.column_name(c))) known.push_back(table_.column_name(c));
    if (options_.columns.empty()) return known;
    for (const std::string& name : options_.columns)
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError(fmt::format(
            "--column: {} has no column '{}' that a motion has; allowed are {}", table_.name(),
            name, known.empty() ? "none of its columns" : joined(known, "and")));
    return options_.columns;
  }

  // Values of several columns need uncertainties as weights.
  void refuse_mixed_uncertainties() const {
    for (const auto& [column, value] : options_.uncertainties) {
      const auto is_that = [&, name = column](const MeasuredSeries& s) { return s.name == name; };
      if (!column.empty() && std::none_of(result_.series.begin(), result_.series.end(), is_that))
        throw InputError(fmt::format("--sigma: no column '{}' is fitted", column));
    }
    if (result_.series.size() < 2) return;
    std::vector<std::string> names;
    bool known = true;
    for (const MeasuredSeries& series : result_.series) {
      names.push_back(series.name);
      known = known && series.uncertainty.size() > 0;
    }
    if (!known)
      throw table_.error(fmt::format(
          "{} would be fitted together, but how they are to be weighed against each other is not "
          "known; choose one with --column, or give each its uncertainty (--sigma {}=VALUE, or a "
          "column sigma_{})",
          joined(names, "and"), names[0], names[0]));
  }

  InputError negative_time(std::size_t row, std::size_t column) const {
    return table_.cell_error(row, column, "time: it counts from 0 on, the scene's start, in s");
  }
  InputError falling_time(std::size_t row, std::size_t column, double before) const {
    return table_.cell_error(
        row, column,
        fmt::format("time: {:g} s is not after the {:g} s before it; times must increase",
                    table_.number(row, column, "s"), before));
  }

  const DataTable& table_;
  const Scene& scene_;
  const MeasurementOptions& options_;
  std::string time_;  // the name of its column; empty if there is none
  std::set<std::size_t> used_;
  std::vector<std::size_t> kept_;  // rows of the table
  Measurements result_;
};

}  // namespace

Measurements read_measurements(const DataTable& table, const Scene& scene,
                               const MeasurementOptions& options) {
  return Reader(table, scene, options).read();
}

}  // namespace graze
