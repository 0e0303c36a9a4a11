#include "graze/report/page/detail/page_looks.hpp"

#include <array>

#include "graze/report/appearance/looks.hpp"

namespace graze {
namespace {

const char* name_of(MarkShape shape) {
  static constexpr std::array kLookNames = {"none", "dot",  "circle",   "square", "diamond",
                                            "up",   "down", "pentagon", "cross",  "plus", "star"};
  return kLookNames[static_cast<std::size_t>(shape)];
}

template <class Looks>
Json list_of(const Looks& looks) {
  Json list = Json::array();
  for (const Look& look : looks) list.push_back(look_json(look));
  return list;
}

}  // namespace

Json look_json(const Look& look) {
  return {{"id", look.id},         {"title", look.title}, {"colour", look.colour},
          {"dashes", look.dashes}, {"width", look.width}, {"mark", name_of(look.mark)},
          {"open", look.open},     {"size", look.size}};
}

Json page_looks() {
  const std::span<const char* const> curves = curve_colours();
  return {{"lines", list_of(line_looks())},
          {"curves", std::vector<std::string>(curves.begin(), curves.end())},
          {"none", ground_look("none").colour},
          {"motion", kBlue},
          {"impact", kVermillion},
          {"stop", kStopShade},
          {"stuck", kStuckShade}};
}

}  // namespace graze
