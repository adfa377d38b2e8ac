#include "case/material_case.hpp"

#include "case/material_presets.hpp"
#include "physics/viscosity_of_concentration.hpp"

namespace sabo {
namespace {

/// Visitor that hands the key `viscosity` of a law to a function.
template <class Use>
struct ViscosityFinder {
  const Use& use;
  void operator()(const Key& key, double& member) const {
    if (key.name == "viscosity") use(member);
  }
};

template <class Use>
void with_viscosity(Rheology& law, const Use& use) {
  std::visit([&](auto& chosen) { chosen.describe(ViscosityFinder<Use>{use}); }, law);
}

}  // namespace

bool set_viscosity(Rheology& law, double viscosity) {
  bool is_found = false;
  with_viscosity(law, [&](double& member) {
    member = viscosity;
    is_found = true;
  });
  return is_found;
}

std::optional<double> viscosity_of(const Rheology& law) {
  std::optional<double> viscosity;
  Rheology copy = law;
  with_viscosity(copy, [&](double& member) { viscosity = member; });
  return viscosity;
}

void MaterialCase::take_preset() {
  const MaterialPreset* chosen = find_preset(preset.name);
  if (!chosen) return;
  density = chosen->density;
  law = chosen->law;
  yield = chosen->yield;
}

void MaterialCase::take_viscosity() {
  const MaterialPreset* chosen = find_preset(preset.name);
  if (const auto known = chosen ? viscosity_of(chosen->law) : std::nullopt)
    set_viscosity(law, *known);
  if (concentration) set_viscosity(law, viscosity_of_concentration(*concentration));
}

}  // namespace sabo
