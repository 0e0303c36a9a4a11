#include "graze/report/page/detail/page_curves.hpp"

#include <algorithm>
#include <limits>

#include "graze/report/chart/detail/branch_lines.hpp"
#include "graze/report/json/detail/json_page.hpp"

namespace graze {
namespace {

constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();

// What distances along a branch are measured by.
AxisRange heights_of(const MotionObservable& observable) {
  AxisRange range;
  for (const DiagramCurve& curve : observable.curves)
    for (const std::vector<double>& heights : curve.points)
      for (const double height : heights) range.include(height);
  range.settle(0.0);
  return range;
}

// Which of the values a node is; of equal ones that which the node before was.
int place_among(const std::vector<double>& values, double value, int before) {
  const auto at = static_cast<std::size_t>(before);
  if (at < values.size() && values[at] == value) return before;
  return static_cast<int>(std::find(values.begin(), values.end(), value) - values.begin());
}

Json line_json(const BranchLine& line, const MotionObservable& observable, int first_special) {
  const DiagramCurve& curve = observable.curves[line.branch];
  std::vector<std::int32_t> point, index;
  int before = 0;
  for (const BranchLine::Node& node : line.nodes) {
    const std::vector<double>& values =
        node.point >= 0 ? curve.points[static_cast<std::size_t>(node.point)]
                        : curve.special[static_cast<std::size_t>(-1 - node.point)];
    before = place_among(values, node.y, before);
    index.push_back(before);
    point.push_back(node.point >= 0 ? node.point : node.point - first_special);
  }
  Json json = {
      {"branch", line.branch}, {"kind", static_cast<int>(line.kind)}, {"point", packed(point)}};
  if (!observable.is_of_motion) json["index"] = packed(index);
  return json;
}

}  // namespace

Json page_lines(const BranchRecord& record, const std::vector<MotionObservable>& observables) {
  const std::vector<OrbitBranch>& branches = record.traced.branches;
  std::vector<int> first_special;  // of each branch, in the list of all
  int count = 0;
  for (const OrbitBranch& branch : branches) {
    first_special.push_back(count);
    count += static_cast<int>(branch.special.size());
  }
  AxisRange across;
  for (const double end : {record.from, record.to}) across.include(end);
  across.settle(0.0);
  Json layouts = Json::object();
  for (const MotionObservable& observable : observables) {
    const std::string layout = observable.is_of_motion ? "motion" : observable.key;
    if (observable.curves.empty() || layouts.contains(layout)) continue;
    Json list = Json::array();
    const BranchLines made =
        branch_lines(branches, observable.curves, across.span(), heights_of(observable).span());
    for (const BranchLine& line : made.lines)
      list.push_back(line_json(line, observable, first_special[line.branch]));
    if (!list.empty()) layouts[layout] = std::move(list);
  }
  return layouts;
}

Json page_values(const std::vector<MotionObservable>& observables) {
  Json all = Json::object();
  for (const MotionObservable& observable : observables) {
    if (observable.curves.empty()) continue;
    Json list = Json::array();
    for (const DiagramCurve& curve : observable.curves) {
      std::vector<double> of;
      std::vector<std::int32_t> first{0};
      for (const std::vector<double>& heights : curve.points) {
        if (observable.is_of_motion)
          of.push_back(heights.empty() ? kNoPoint : heights.front());
        else
          of.insert(of.end(), heights.begin(), heights.end());
        first.push_back(static_cast<std::int32_t>(of.size()));
      }
      Json values = {{"of", packed(of)}};
      if (!observable.is_of_motion) values["first"] = packed(first);
      list.push_back(std::move(values));
    }
    all[observable.key] = std::move(list);
  }
  return all;
}

}  // namespace graze
