#include <fmt/format.h>

#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/base/terminal_text.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

std::string direction_name(const DirectionShare& share) {
  return share.direction == 0 ? "" : fmt::format(" {}", share.direction);
}

// Two shapes are separated to the rounding of the stiffness relative to the difference of the
// squares of their frequencies, which is some more noise than that of numbers.
constexpr double kNoiseOfShapes = 100.0;

Table table_of(const ModeTable& modes, const TextUnits& in) {
  const bool has_hertz = !in("Hz").empty();
  std::vector<std::string> header = {"mode", in.head("frequency", "rad/s")};
  if (has_hertz) header.emplace_back("frequency (Hz)");
  header.push_back(in.head("decay rate", "1/s"));
  for (const DirectionShare& share : modes.directions) {
    header.push_back(in.head("modal inertia" + direction_name(share), "kg^1/2"));
    header.push_back(in.head("effective mass" + direction_name(share), "kg"));
  }
  if (modes.residuals.size() > 0) header.emplace_back("residual");
  Table table(header);
  for (Eigen::Index j = 0; j < modes.omega.size(); ++j) {
    std::vector<std::string> row = {std::to_string(j + 1), digits_text(modes.omega[j], 8)};
    if (has_hertz) row.push_back(digits_text(modes.omega[j] / kTurn, 6));
    row.push_back(digits_text(modes.decay[j], 6));
    for (const DirectionShare& share : modes.directions) {
      const double largest = kNoiseOfShapes * share.inertia.cwiseAbs().maxCoeff();
      row.push_back(digits_text(share.inertia[j], 6, largest));
      row.push_back(digits_text(share.inertia[j] * share.inertia[j], 6, largest * largest));
    }
    if (modes.residuals.size() > 0) row.push_back(fmt::format("{:.0e}", modes.residuals[j]));
    table.add(row);
  }
  return table;
}

std::string mac_text(const ModesRecord& record, std::size_t width) {
  const Matrix& values = record.mac->values;
  std::vector<std::string> header = {"mode"};
  for (Eigen::Index j = 0; j < values.cols(); ++j) header.push_back(std::to_string(j + 1));
  Table table(header);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    std::vector<std::string> row = {std::to_string(i + 1)};
    for (Eigen::Index j = 0; j < values.cols(); ++j)
      row.push_back(fmt::format("{:.3f}", values(i, j)));
    table.add(row);
  }
  return fmt::format("\nmodal assurance (MAC) against {}, {} common places:\n",
                     terminal_line(record.mac_file), record.mac->common) +
         table.text(width);
}

}  // namespace

std::string to_text(const ModesRecord& record, const TextOptions& options) {
  const ModeTable& modes = record.table;
  const TextUnits in(record.info.units);
  std::string text =
      record.info.scene_title.empty() ? "" : terminal_line(record.info.scene_title) + "\n";
  for (const std::string& note : modes.notes) text += note + "\n";
  if (modes.rigid > 0)
    text += fmt::format("{} rigid-body mode{}, frequency 0\n", modes.rigid,
                        modes.rigid == 1 ? "" : "s");
  if (!text.empty()) text += "\n";
  text += table_of(modes, in).text(options.width) + "\n";
  for (const DirectionShare& share : modes.directions) {
    if (!share.total_mass) continue;
    const double kept = share.inertia.squaredNorm();
    text += fmt::format("effective mass{} of these modes: {} of {}, {:.1f} %\n",
                        share.direction == 0 ? "" : " in direction" + direction_name(share),
                        in.quantity(kept, 6, "kg"), in.quantity(*share.total_mass, 6, "kg"),
                        100.0 * kept / *share.total_mass);
  }
  for (std::size_t i = 0; i < modes.flexibilities.size(); ++i) {
    const StopFlexibility& at = modes.flexibilities[i];
    text += fmt::format("stop {}: static flexibility of these modes: {}", i + 1,
                        in.quantity(at.kept, 6, "m/N"));
    if (at.whole)
      text += fmt::format(" of {}, {:.2f} %", in.quantity(*at.whole, 6, "m/N"),
                          100.0 * at.kept / *at.whole);
    text += "\n";
  }
  if (record.mac) text += mac_text(record, options.width);
  return text;
}

}  // namespace graze
