#include "validation/result_path.hpp"

#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace graze::support {
namespace {

std::string text_of(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

nlohmann::json members_with(const nlohmann::json& list, const std::string& key,
                            const std::string& text) {
  nlohmann::json kept = nlohmann::json::array();
  for (const nlohmann::json& member : list)
    if (member.contains(key) && text_of(member[key]) == text) kept.push_back(member);
  return kept;
}

}  // namespace

nlohmann::json result_at(const nlohmann::json& document, const std::string& path) {
  const std::string plus = " + ";
  if (const std::size_t place = path.find(plus); place != std::string::npos)
    return std::hypot(result_at(document, path.substr(0, place)).get<double>(),
                      result_at(document, path.substr(place + plus.size())).get<double>());
  nlohmann::json here = document;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');) {
    const std::size_t equals = part.find('=');
    if (here.is_array() && equals != std::string::npos)
      here = members_with(here, part.substr(0, equals), part.substr(equals + 1));
    else if (here.is_array() && std::isdigit(static_cast<unsigned char>(part[0])) &&
             std::stoul(part) < here.size())
      here = nlohmann::json(here[std::stoul(part)]);
    else if (here.is_object() && here.contains(part))
      here = nlohmann::json(here[part]);
    else
      throw std::out_of_range("the document has no '" + part + "' of '" + path + "'");
  }
  return here;
}

}  // namespace graze::support
