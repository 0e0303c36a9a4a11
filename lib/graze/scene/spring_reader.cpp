#include "graze/scene/detail/spring_reader.hpp"

#include <fmt/format.h>

#include "graze/scene/detail/table_reader.hpp"

namespace graze {
namespace {

SpringDamping read_damping(const Node& node, const std::string& path, Origins& origins) {
  const TableReader table(node, path, origins);
  SpringDamping damping;
  std::vector<std::pair<std::string, ContactModel>> models;
  for (const ContactModel model :
       {ContactModel::kKelvinVoigt, ContactModel::kLeeWang1, ContactModel::kLeeWang2,
        ContactModel::kHuntCrossley, ContactModel::kLankaraniNikravesh, ContactModel::kFlores})
    models.emplace_back(contact_model_name(model), model);
  table.required("model", "the name of a model of damping");
  damping.model = table.choice<ContactModel>("model", models);
  const auto number = [&](const char* key, const char* what, std::optional<double>& value) {
    if (table.has(key)) value = table.number(key, what);
  };
  number("coefficient", "a number of at least 0", damping.coefficient);
  number("ratio", "a number of at least 0", damping.ratio);
  number("alpha", "a number of at least 0, in s/m", damping.alpha);
  number("restitution", "a number greater than 0 and at most 1", damping.restitution);
  number("speed", "a number greater than 0, in m/s", damping.speed);
  number("mass", "a number greater than 0, in kg", damping.mass);
  number("onset", "a number greater than 0, in m", damping.onset);
  number("sharpness", "a number of at least 0", damping.sharpness);
  damping.exact = table.choice<bool>("inversion", {{"published", false}, {"exact", true}});
  return damping;
}

// Two radii are those of balls; four those in two planes at right angles, body by body.
SpringGeometry read_geometry(const TableReader& table) {
  SpringGeometry geometry;
  const std::string what = "a list of two numbers in m, or of four";
  table.required("radii", what);
  const std::vector<double> radii = table.numbers("radii", what);
  if (radii.size() != 2 && radii.size() != 4)
    table.fail("radii", fmt::format("the list has {} entries, it must have two, of balls, or four",
                                    radii.size()));
  const auto pair = [&](const char* key, const char* each) {
    table.required(key, each);
    const std::vector<double> values = table.numbers(key, each);
    if (values.size() != 2)
      table.fail(key, fmt::format("the list has {} entries, it must have two, one per body",
                                  values.size()));
    return values;
  };
  const std::vector<double> moduli = pair("moduli", "a list of two numbers in Pa");
  const std::vector<double> poisson = pair("poisson", "a list of two numbers");
  for (std::size_t body = 0; body < 2; ++body) {
    const bool ball = radii.size() == 2;
    geometry.bodies[body] = {{radii[ball ? body : 2 * body], radii[ball ? body : 2 * body + 1]},
                             moduli[body],
                             poisson[body]};
  }
  geometry.angle = table.number_or("angle", "a number in rad", 0.0);
  return geometry;
}

}  // namespace

Spring read_spring(const Node& node, const std::string& path, Origins& origins) {
  const TableReader table(node, path, origins);
  Spring spring;
  const bool geometric = table.has("radii") || table.has("moduli") || table.has("poisson");
  if (geometric) {
    for (const char* key : {"stiffness", "exponent"})
      if (table.has(key))
        table.fail(key, "it follows from radii, moduli and poisson, it must be left out with them");
    spring.geometry = read_geometry(table);
  } else {
    if (table.has("angle")) table.fail("angle", "it needs radii, moduli and poisson");
    spring.stiffness = table.number("stiffness", "a number greater than 0, in N/m^exponent");
    spring.exponent = table.number("exponent", "a number of at least 1");
  }
  if (const Node* damping = table.find("damping"))
    spring.damping = read_damping(*damping, path + ".damping", origins);
  spring.release = table.choice<Separation>(
      "release", {{"force", Separation::kAtZeroForce}, {"position", Separation::kAtZeroDepth}});
  return spring;
}

}  // namespace graze
