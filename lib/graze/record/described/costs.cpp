#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

void describe_errors(ResultVisitor& v, const RunError& compared, std::string_view unit) {
  v.field({"error", unit,
           "largest of an impact time; without impacts of the displacements, relative; null where "
           "the run failed or lost the sequence"},
          compared.error);
  v.field({"state_error", "1", "of the state at the end, relative"}, compared.state_error);
}

void describe_end(ResultVisitor& v, const RunError& compared) {
  v.field({"impacts_agree"}, compared.impacts_agree);
  if (const auto some = v.where(!compared.message.empty(), "where the run failed"))
    v.field(Field{"message"}.document(), compared.message);
}

void describe_flows(ResultVisitor& v, const FlowCosts& costs, std::string_view unit) {
  v.list({"rows", "", "flow by flow"}, costs.rows, [&](const FlowCost& row, std::size_t) {
    v.row("costs", [&] {
      v.field({"flow"}, row.flow);
      v.field({"setting", "", "`step=1e-05`, `tolerance=1e-08`; empty for exact"}, row.setting);
      describe_errors(v, row.compared, unit);
      v.field({"seconds_per_period", "s", "computing time; per second of motion without forcing"},
              row.seconds_per_period);
      v.field({"evaluations_per_period", "",
               "of the equations of motion, of gaps and of contact forces"},
              row.evaluations_per_period);
      describe_end(v, row.compared);
    });
  });
}

void describe_accuracies(ResultVisitor& v, const CostRecord& record, std::string_view unit) {
  v.list({"modes", "", "where their number is free"}, record.modes,
         [&](const ModeCost& row, std::size_t) {
           v.row("costs_of_modes", [&] {
             v.field({"modes"}, row.modes);
             v.field({"error", unit, "of the first impact time, against 64 modes"}, row.error);
             v.field({"seconds_per_period", "s"}, row.seconds_per_period);
             v.field({"evaluations_per_period"}, row.evaluations_per_period);
           });
         });
  v.list({"closure", "", "of a motion that chatters"}, record.closure.rows,
         [&](const ClosureCost& row, std::size_t) {
           v.row("costs_of_closure", [&] {
             v.field({"closure_speed", "m/s"}, row.speed);
             describe_errors(v, row.compared, unit);
             v.field({"seconds_per_period", "s"}, row.seconds_per_period);
             v.field({"impacts_per_period"}, row.impacts_per_period);
             describe_end(v, row.compared);
           });
         });
  if (const auto some =
          v.where(!record.closure.message.empty(), "where rounding alone changes the impacts"))
    v.field({"closure_message"}, record.closure.message);
}

void describe_corrector(ResultVisitor& v, const CorrectorCosts& costs) {
  v.part({"corrector", "", "Newton's steps to an orbit from its neighbour"}, [&] {
    v.field({"orbit", "", "null where there is none"}, named(costs.orbit));
    v.list({"rows"}, costs.rows, [&](const CorrectorCost& row, std::size_t) {
      v.row("costs_of_corrector", [&] {
        v.field({"predicted", "", "moved along the tangent of the branch"}, row.predicted);
        v.field({"steps"}, row.steps);
        v.field({"residual", "", "the corrector tolerance that they meet"}, row.residual);
        v.field({"error", "", "of impact times, s"}, row.error);
        v.field({"seconds", "s", "computing time"}, row.seconds);
      });
    });
    if (const auto some = v.where(!costs.message.empty(), "where there is none"))
      v.field({"message"}, costs.message);
  });
}

void describe_orders(ResultVisitor& v, const ContactOrder& line) {
  const bool stepped = !line.rows.empty() && line.rows.front().steps > 0;
  v.field(Field{"spring", "", "`linear`, `Hertz`, `n = 2`, all as deep"}.in("costs_of_contact"),
          line.spring);
  v.field(Field{"method", "", "`rk4, located`, `rk4, not located`, `exact`"}.in("costs_of_contact"),
          line.method);
  v.field({"stiffness", "", "N/m^n"}, line.contact.stiffness);
  v.field({"exponent"}, line.contact.exponent);
  v.field({"duration", "", "s"}, line.contact.duration());
  v.field(Field{"order", "", "slope of the error; null with exact"}.in("costs_of_contact"),
          stepped ? std::optional(line.order) : std::nullopt);
  v.list({"rows"}, line.rows, [&](const ContactOrderRow& row, std::size_t) {
    v.row("costs_of_contact", [&] {
      v.field({"steps", "", "a contact; 0 with exact"}, row.steps);
      v.field({"step", "", "s"}, row.step);
      v.field({"error", "", "of speed and duration, relative, the worst of 16 places"}, row.error);
      v.field({"seconds", "s", "computing time"}, row.seconds);
      v.field({"evaluations"}, row.evaluations);
    });
  });
}

void describe_contact(ResultVisitor& v, const std::optional<ContactOrders>& contact) {
  const ContactOrders& orders = held(contact);
  const FirstContact& first = orders.first;
  // Of rigid stops the table is there all the same.
  const auto some = v.where(contact.has_value(), "where a stop is compliant");
  if (!some) return;
  v.part({"contact", "", "the first one"}, [&] {
    if (const auto none = v.where(first.stop < 0, "where there is none"))
      v.field({"message"}, first.message);
    const auto any = v.where(first.stop >= 0, "else");
    if (!any) return;
    v.field({"stop", "", "from 1"}, first.stop + 1);
    v.field({"mass", "", "that it sees, kg"}, first.contact.mass);
    v.field({"speed", "", "m/s"}, first.contact.speed);
    v.field({"depth", "", "m"}, first.contact.depth());
    v.list({"lines"}, orders.lines,
           [&](const ContactOrder& line, std::size_t) { describe_orders(v, line); });
  });
}

}  // namespace

void describe(ResultVisitor& v, const CostRecord& record) {
  const FlowCosts& costs = record.costs;
  const char* unit = costs.impacts > 0 ? "s" : "1";
  describe_head(v, record.info, record.outcome, record.warnings);
  v.field({"reference"}, reference_name(costs));
  v.field({"span", "", "of the comparison, in words"}, compared_span(costs, record.info.units));
  if (const auto some =
          v.where(!costs.reference_message.empty(), "where the reference ended early"))
    v.field({"reference_message"}, costs.reference_message);
  v.field({"impacts", "", "compared"}, costs.impacts);
  v.field({"end_time", "s", "of the compared motion"}, costs.end_time);
  describe_flows(v, costs, unit);
  describe_accuracies(v, record, unit);
  describe_corrector(v, record.corrector);
  describe_contact(v, record.contact);
  const FlowCost* best = cheapest(costs, costs.allowed);
  v.part({"recommended", "", "flow that meets the tolerance in the least time"}, [&] {
    v.field({"tolerance", "", "of the scene"}, costs.tolerance);
    v.field({"allowed_error", "", "that part of a forcing period, s, or of the amplitude"},
            costs.allowed);
    v.field({"flow", "", "null where none does"}, best ? std::optional(best->flow) : std::nullopt);
    v.field({"setting"}, best ? std::optional(best->setting) : std::nullopt);
  });
}

}  // namespace graze
