// The numbers of a scene by their paths, as the schema has them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/schema.hpp"

namespace graze {

// Calls f(path, number) for every number of the scene; `all`: also for those that are no
// parameters.
template <class F>
class NumberVisitor : public SchemaVisitor {
 public:
  NumberVisitor(const Scene& scene, F& f, std::string path, bool all)
      : scene_(scene), f_(f), path_(std::move(path)), all_(all) {}

  template <class Number>
  void number(const Key& key, Number& value) {
    if (!is_meant(key)) return;
    if constexpr (std::is_same_v<std::remove_const_t<Number>, double>)
      f_(path_ + key.name, value);
    else if (value)
      f_(path_ + key.name, *value);
  }
  void number_or(const Key& key, auto& value, const bool& is_word, const char*) {
    if (!is_word) number(key, value);
  }
  // Entries are counted from 1.
  void list(const Key& key, auto& values) {
    if (!is_meant(key)) return;
    std::size_t k = 0;
    for (auto& value : values) f_(fmt::format("{}{}.{}", path_, key.name, ++k), value);
  }
  void values(const Key& key, auto& values) { list(key, values); }
  // Those on and above the diagonal, of a symmetric matrix.
  void entries(const Key& key, auto&, auto& rows) {
    if (!is_meant(key)) return;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = key.is_symmetric && !all_ ? i : 0; j < rows[i].size(); ++j)
        f_(fmt::format("{}{}.{}.{}", path_, key.name, i + 1, j + 1), rows[i][j]);
  }
  void series(const Key& key, auto& values) {
    if (values.size() == 1)
      number(key, values.front());
    else
      list(key, values);
  }
  void taper(const Key& key, auto& values) { series(key, values); }
  void table(const TableKey& key, auto&& value) {
    if (value && (all_ || key.is_varied)) descend(path_ + key.name, *value);
  }
  void tables(const TableKey& key, auto& values) {
    visit_list(key, 0, values);
  }
  void leading(const TableKey& key, auto&& first, auto& others) {
    table(key, first);
    visit_list(key, 1, others);
  }

 private:
  bool is_meant(const Key& key) const { return key.applies && (all_ || key.is_parameter); }
  void visit_list(const TableKey& key, std::size_t before, auto& values) {
    if (!all_ && !key.is_varied) return;
    for (auto& value : values) descend(path_ + numbered_path(key.name, ++before), value);
  }
  void descend(const std::string& path, auto& value) {
    NumberVisitor inner(scene_, f_, path + ".", all_);
    describe(inner, value, scene_);
  }

  const Scene& scene_;
  F& f_;
  std::string path_;
  bool all_;
};

template <class S, class F>
void visit_numbers(S& scene, F&& f, bool all) {
  NumberVisitor<F> visitor(scene, f, "", all);
  describe(visitor, scene);
}

// The number, or null.
template <class S>
auto found_number(S& scene, const std::string& path, bool all) {
  std::conditional_t<std::is_const_v<S>, const double, double>* result = nullptr;
  const std::string wanted = first_unnumbered(path);
  visit_numbers(
      scene,
      [&](const std::string& name, auto& value) {
        if (name == wanted) result = &value;
      },
      all);
  return result;
}

}  // namespace graze
