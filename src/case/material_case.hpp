#pragma once

#include <optional>
#include <string>

#include "base/describe.hpp"
#include "physics/rheology_list.hpp"
#include "physics/yield.hpp"

namespace sabo {

/// Name of one of material_presets(); empty for none.
struct PresetName {
  std::string name;
};

struct MaterialCase {
  PresetName preset;
  double density = 1726;
  std::optional<double> concentration;
  Rheology law = Cross{};
  MohrCoulomb yield;  ///< used by laws with a yield stress

  template <class V>
  void describe(V&& v) {
    v(Key{"preset", "",
          "start from a documented material (`sabo models` lists them); keys beside it replace its "
          "values, and another rheology keeps its viscosity"},
      preset);
    if constexpr (SetsMembers<V>) take_preset();
    v(Key{"density", "kg/m3", "bulk density of the mixture"}.at_least(100).at_most(3e4), density);
    v(Key{"concentration", "%",
          "of solids by volume: sets viscosity = 0.621 exp(0.173 concentration); the unit of the "
          "formula is in doubt, see docs/rheology/README.md"}
          .at_least(0)
          .at_most(65),
      concentration);
    // A visitor that reads sets the law here, so that what follows are the keys of that law.
    v(Key{"rheology", "", "law of flow; `sabo models` lists them with their keys"}, law);
    if constexpr (SetsMembers<V>) take_viscosity();
    std::visit([&](auto& chosen) { chosen.describe(v); }, law);
    if (has_yield(law)) yield.describe(v);
  }

 private:
  /// Replaces density, law and yield by those of the preset, if there is one.
  void take_preset();
  /// Replaces the viscosity of the law by that of the concentration, else of the preset, if any.
  void take_viscosity();
};

/// Sets the key `viscosity` of a law; false if it has none.
bool set_viscosity(Rheology& law, double viscosity);

/// The key `viscosity` of a law, Pa s; nothing if it has none.
std::optional<double> viscosity_of(const Rheology& law);

}  // namespace sabo
