#include <fmt/format.h>

#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

std::string error_text(const std::optional<double>& error) { return digits_text(error, 2); }

// "740 us"
std::string time_text(double seconds) {
  if (seconds == 0.0) return "0";
  if (seconds >= 1.0) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} us", 1e6 * seconds);
}

// The unit of time that costs refer to.
std::string unit_of_motion(const CostRecord& record) {
  if (record.costs.forced) return " / period";
  return record.info.units == Units::kSi ? " / s" : " / unit of time";
}

const char* agreement_text(const RunError& compared) {
  if (!compared.message.empty()) return "failed";
  return compared.impacts_agree ? "yes" : "no";
}

std::string modes_text(const CostRecord& record, const TextOptions& options) {
  if (record.modes.empty()) return "";
  const std::string per = unit_of_motion(record);
  const TextUnits in(record.info.units);
  Table table({"modes", in.head("error of first impact", "s"), "time" + per, "evaluations" + per});
  for (const ModeCost& row : record.modes)
    table.add({std::to_string(row.modes), error_text(row.error), time_text(row.seconds_per_period),
               digits_text(row.evaluations_per_period, 4)});
  return fmt::format("\nModes, against {} of them\n{}",
                     record.costs.turns ? kMostModesOnHub : kMostModesCompared,
                     table.text(options.width));
}

std::string closure_text(const CostRecord& record, const TextOptions& options) {
  if (record.closure.rows.empty())
    return record.closure.message.empty()
               ? ""
               : fmt::format("\nClosure speed: {}\n", record.closure.message);
  const std::string per = unit_of_motion(record);
  const TextUnits in(record.info.units);
  Table table({in.head("closure speed", "m/s"), in.head("error of impacts", "s"), "time" + per,
               "impacts" + per, "same impacts"});
  for (const ClosureCost& row : record.closure.rows)
    table.add({digits_text(row.speed, 3), error_text(row.compared.error),
               time_text(row.seconds_per_period), digits_text(row.impacts_per_period, 4),
               agreement_text(row.compared)});
  std::string text = "\nClosure speed, against impacts simulated to the end of a chatter\n" +
                     table.text(options.width);
  if (!record.closure.message.empty()) text += record.closure.message + "\n";
  return text;
}

std::string corrector_text(const CostRecord& record, const TextOptions& options) {
  const CorrectorCosts& costs = record.corrector;
  if (costs.rows.empty())
    return costs.message.empty() ? "" : fmt::format("\nNewton's steps: {}\n", costs.message);
  const TextUnits in(record.info.units);
  Table table({"start", "steps", "residual", in.head("error of impacts", "s"), "time"});
  for (const CorrectorCost& row : costs.rows)
    table.add({row.predicted ? "tangent" : "neighbour", std::to_string(row.steps),
               digits_text(row.residual, 2), digits_text(row.error, 2), time_text(row.seconds)});
  return fmt::format("\nNewton's steps to {} from a forcing frequency lower by {:g} %\n{}",
                     costs.orbit, 100.0 * kNeighbour, table.text(options.width));
}

// "rk4, located" of "linear"; all lines but the exact one have the same steps.
std::string contact_text(const CostRecord& record, const TextOptions& options) {
  if (!record.contact) return "";
  const FirstContact& first = record.contact->first;
  if (first.stop < 0) return fmt::format("\nOrder across a contact: {}\n", first.message);
  std::vector<std::string> header = {"steps a contact"}, orders = {"order"}, exact = {"exact flow"};
  std::vector<const ContactOrder*> stepped;
  for (const ContactOrder& line : record.contact->lines) {
    if (line.rows.empty()) continue;
    if (line.rows.front().steps > 0) {
      stepped.push_back(&line);
      header.push_back(line.spring + line.method.substr(line.method.find(',')));
      orders.push_back(fmt::format("{:.2f}", line.order));
    } else {
      exact.push_back(fmt::format("{:.2g}", line.rows.front().error));
      exact.push_back("");
    }
  }
  Table table(header);
  for (std::size_t i = 0; !stepped.empty() && i < stepped.front()->rows.size(); ++i) {
    std::vector<std::string> row = {std::to_string(stepped.front()->rows[i].steps)};
    for (const ContactOrder* line : stepped)
      row.push_back(i < line->rows.size() ? fmt::format("{:.2g}", line->rows[i].error) : "-");
    table.add(row);
  }
  table.add(orders);
  if (exact.size() == orders.size()) table.add(exact);
  const TextUnits in(record.info.units);
  return fmt::format(
      "\nOrder of rk4 across one contact: {} at {} on elastic springs that give way by {}\nerrors "
      "of speed and duration, relative, the larger; against closed forms\n{}",
      in.quantity(first.contact.mass, 4, "kg"), in.quantity(first.contact.speed, 4, "m/s"),
      in.quantity(first.contact.depth(), 4, "m"), table.text(options.width));
}

}  // namespace

std::string to_text(const CostRecord& record, const TextOptions& options) {
  const FlowCosts& costs = record.costs;
  const bool timed = costs.impacts > 0;
  const TextUnits in(record.info.units);
  const std::string per = unit_of_motion(record);
  Table table({"flow", "setting",
               timed ? in.head(costs.compliant ? "error of contacts" : "error of impacts", "s")
                     : "error / amplitude",
               "error of state", "time" + per, "evaluations" + per,
               costs.compliant ? "same contacts" : "same impacts"});
  for (const FlowCost& row : costs.rows)
    table.add({row.flow, row.setting, error_text(row.compared.error),
               error_text(row.compared.state_error), time_text(row.seconds_per_period),
               digits_text(row.evaluations_per_period, 4), agreement_text(row.compared)});
  std::string text = table.empty() ? "" : table.text(options.width) + "\n";
  text +=
      fmt::format("compared over: {}; reference: {}\n", compared_span(costs, record.info.units),
                  costs.compliant || costs.turns ? reference_name(costs) : "exact flow, 50 digits");
  if (!costs.reference_message.empty())
    text += fmt::format("the reference ended there: {}\n", costs.reference_message);
  const std::string allowed = quantity_text(costs.allowed, 2, timed ? in("s") : "");
  if (const FlowCost* best = cheapest(costs, costs.allowed))
    text += fmt::format("for tolerance {:g} (an error of {}): {}{}, {}{}\n", costs.tolerance,
                        allowed, best->flow, best->setting.empty() ? "" : " with " + best->setting,
                        time_text(best->seconds_per_period), per);
  else if (!costs.rows.empty())
    text +=
        fmt::format("no setting meets tolerance {:g} (an error of {})\n", costs.tolerance, allowed);
  text += modes_text(record, options) + closure_text(record, options) +
          corrector_text(record, options) + contact_text(record, options);
  return text + ending(record.outcome);
}

}  // namespace graze
