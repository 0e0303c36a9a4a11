#include "graze/scene/detail/choices.hpp"

namespace graze {

std::string flow_name(FlowChoice flow) { return name_among(kFlows, flow); }
std::string contact_model_name(ContactModel model) { return name_among(kContactModels, model); }
std::string probe_quantity_name(ProbeQuantity quantity) {
  return name_among(kQuantities, quantity);
}

}  // namespace graze
