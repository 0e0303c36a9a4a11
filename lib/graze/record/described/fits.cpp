#include <cmath>
#include <ranges>

#include "graze/record/described/detail/descriptions.hpp"
#include "graze/record/described/detail/shared_parts.hpp"
#include "graze/record/study_records.hpp"

namespace graze {
namespace {

void describe_parameter(ResultVisitor& v, const FittedParameter& parameter) {
  const bool known = parameter.uncertainty.has_value();
  v.field(Field{"name"}.as("parameter"), parameter.name);
  v.field(Field{"unit"}.document(), parameter.unit);
  v.field({"value"}, parameter.value);
  v.field({"uncertainty", "", "standard; null for what is at a limit or not determined"},
          parameter.uncertainty);
  v.field(Field{"interval", "", "95 %, two values, or null"}.as("interval_low,interval_high"),
          known ? std::optional(NumberPair(parameter.interval_low, parameter.interval_high))
                : std::nullopt);
  v.field({"at_limit"}, parameter.at_limit);
  v.field(Field{"start", "", "where the search began"}.document(), parameter.start);
  v.field(Field{"low", "", "limit, null without one"}.document(), parameter.low);
  v.field(Field{"high", "", "limit, null without one"}.document(), parameter.high);
}

void describe_series(ResultVisitor& v, const FitResult& result, const FittedSeries& series) {
  const bool known = series.uncertainty.size() > 0;
  v.field(Field{"name", "", "of the column"}.as("series").in("fit"), series.name);
  v.field({"unit"}, series.unit);
  v.field({"standard_deviation", "", "of the residuals"}, series.noise);
  v.values({"measured"}, series.measured);
  v.values({"predicted"}, series.predicted);
  if (const auto some = v.where(known, "where it is known"))
    v.values({"uncertainty"}, series.uncertainty);
  else
    v.field({"uncertainty"}, std::optional<double>());
  const Abscissa abscissa = abscissa_of(result.kind);
  v.list(Field{"values"}.tabular(), std::views::iota(Eigen::Index{0}, result.at.size()),
         [&](Eigen::Index i, std::size_t) {
           v.row("fit", [&] {
             const double measured = number_at(series.measured, i);
             const double predicted = number_at(series.predicted, i);
             v.field({abscissa.name, abscissa.unit}, number_at(result.at, i));
             v.field({"measured"}, measured);
             v.field({"predicted"}, predicted);
             v.field({"residual", "", "measured less predicted"}, measured - predicted);
             v.field({"uncertainty"}, number_at(series.uncertainty, i));
           });
         });
}

}  // namespace

void describe(ResultVisitor& v, const FitRecord& record) {
  const FitResult& result = record.result;
  describe_head(v, record.info, record.outcome, record.warnings);
  v.part({"data", "", "that was fitted"}, [&] {
    v.field({"file"}, record.data_file);
    v.field({"sha256"}, record.data_sha256);
    v.field({"kind", "", "`restitution`, `impact times` or `response`"}, name_of(result.kind));
    v.field({"values", "", "how many"},
            result.at.size() * static_cast<long long>(result.series.size()));
    v.values({"unused_columns"}, record.unused_columns);
  });
  v.list({"parameters"}, result.parameters, [&](const FittedParameter& parameter, std::size_t) {
    v.row("parameters", [&] { describe_parameter(v, parameter); });
  });
  v.lists({"correlations", "", "of the parameters; null with those that have no uncertainty"},
          static_cast<std::size_t>(result.correlations.rows()), [&](std::size_t i) {
            return Vector(result.correlations.row(static_cast<Eigen::Index>(i)).transpose());
          });
  v.field({"uncertainties", "", "of the data: `given` or `from the residuals`"},
          result.knows_uncertainty ? "given" : "from the residuals");
  v.field({"sum_of_squares", "", "of the residuals over the uncertainties, null without these"},
          result.knows_uncertainty && !result.series.empty() ? std::optional(result.sum_of_squares)
                                                             : std::nullopt);
  v.field({"degrees_of_freedom", "", "values less free parameters"}, result.freedom);
  v.field({"quantile", "", "how many standard uncertainties an interval reaches"},
          result.quantile > 0.0 ? std::optional(result.quantile) : std::nullopt);
  v.field({"method", "", "in words"}, result.method);
  v.field({"evaluations", "", "of the model"}, result.evaluations);
  const Abscissa abscissa = abscissa_of(result.kind);
  v.part({"at", "", "what the values stand at"}, [&] {
    v.field({"name"}, abscissa.name);
    v.field({"unit"}, abscissa.unit);
    v.values({"values"}, result.at);
  });
  v.list({"series", "", "a column each"}, result.series,
         [&](const FittedSeries& series, std::size_t) { describe_series(v, result, series); });
}

}  // namespace graze
