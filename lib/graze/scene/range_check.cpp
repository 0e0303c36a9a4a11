#include "graze/scene/detail/range_check.hpp"

#include <fmt/format.h>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/schema.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

class RangeChecker : public SchemaVisitor {
 public:
  RangeChecker(const Scene& scene, std::string path)
      : scene_(scene), path_(std::move(path)), checker_(scene, path_) {}

  void number(const Key& key, double value) const {
    if (is_meant(key, value != 0.0)) checker_.number(key.name, value, key.range);
  }
  void number(const Key& key, const std::optional<double>& value) const {
    if (value && is_meant(key, true)) checker_.number(key.name, *value, key.range);
  }
  void number_or(const Key& key, double value, bool is_word, const char*) const {
    if (!is_word) number(key, value);
  }
  // The points of a torque, which are no list of the modes, have a rule of their own.
  void list(const Key& key, const std::vector<double>& values) const {
    if (is_meant(key, !values.empty()) && key.range.is_checked &&
        (key.is_required || !values.empty()))
      checker_.entries(key.name, values, scene_.modes(), key.range);
  }
  // Only a0, the restitution of a vanishing speed, has bounds of its own: where r(v) leaves 0..1
  // depends on the speeds that occur. The others may be of any size. A constant has no number.
  void series(const Key& key, const std::vector<double>& values) const {
    if (!key.applies) return;
    if (values.empty())
      checker_.fail(key.name, "the list is empty, it must have at least one number");
    if (values.size() == 1) {
      checker_.number(key.name, values.front(), key.range);
      return;
    }
    checker_.entry(key.name, 1, values.front(), key.range);
    for (std::size_t k = 1; k < values.size(); ++k)
      if (!kAny.holds(values[k])) checker_.entry(key.name, k + 1, values[k], kAny);
  }
  void taper(const Key& key, const Taper& values) const {
    if (!is_meant(key, !values.empty())) return;
    if (values.size() == 1) checker_.number(key.name, values.front(), key.range);
    if (values.size() != 2) return;
    for (std::size_t k = 0; k < 2; ++k) checker_.entry(key.name, k + 1, values[k], key.range);
  }
  void bodies(const Key& key, const SpringGeometry& geometry, BodyNumbers which) const {
    if (!key.applies || !key.range.is_checked) return;
    std::size_t k = 0;
    for (const double value : body_numbers(geometry, which))
      checker_.entry(key.name, ++k, value, key.range);
  }
  void values(const Key& key, const std::vector<double>& values) const {
    if (!is_meant(key, !values.empty()) || !key.range.is_checked) return;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!key.range.holds(values[k])) checker_.entry(key.name, k + 1, values[k], key.range);
  }
  void entries(const Key& key, const auto&, const MatrixEntries& rows) const {
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (std::size_t j = 0; j < rows[k].size(); ++j)
        checker_.number(fmt::format("{}.{}.{}", key.name, k + 1, j + 1).c_str(), rows[k][j], kAny);
  }
  // Zero of what may be left out stands for none.
  void count(const Key& key, int value) const {
    if (!key.range.holds(value) && (key.is_required || value != 0))
      checker_.refuse(key.name, value, fmt::format("an integer {}", key.range.words));
  }
  void table(const TableKey& key, const auto& value) const {
    if (value) descend(joined_path(path_, key.name), *value);
  }
  void tables(const TableKey& key, const auto& values) const {
    check_list(key, 0, values);
  }
  void leading(const TableKey& key, const auto& first, const auto& others) const {
    table(key, first);
    check_list(key, 1, others);
  }

 private:
  // Whether to check the key; refuses one that is there though it does not apply.
  bool is_meant(const Key& key, bool is_there) const {
    if (!key.applies && key.refusal && is_there && !key.may_stand)
      checker_.fail(key.name, key.refusal);
    return key.applies;
  }
  void check_list(const TableKey& key, std::size_t before, const auto& values) const {
    if (values.empty()) return;
    const std::string list = joined_path(path_, key.name);
    for (const auto& value : values) descend(numbered_path(list, ++before), value);
  }
  void descend(const std::string& path, const auto& value) const {
    const RangeChecker inner(scene_, path);
    describe(inner, value, scene_);
  }

  const Scene& scene_;
  std::string path_;
  ValueChecker checker_;
};

}  // namespace

void check_ranges(const Scene& scene) {
  const RangeChecker checker(scene, "");
  describe(checker, scene);
}

}  // namespace graze
