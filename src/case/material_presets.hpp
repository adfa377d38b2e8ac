#pragma once

#include <string_view>
#include <vector>

#include "physics/rheology_list.hpp"
#include "physics/yield.hpp"

namespace sabo {

/// A material with published numbers: a place to start from, never a substitute for a measurement.
struct MaterialPreset {
  std::string_view name;
  std::string_view summary;
  std::string_view source;   ///< authors, year, where
  std::string_view caution;  ///< what it does not say, and what was assumed
  double density = 1000;     ///< kg/m3
  Rheology law;
  MohrCoulomb yield;
};

/// The one list of them.
const std::vector<MaterialPreset>& material_presets();

/// By its name; nullptr if there is none.
const MaterialPreset* find_preset(std::string_view name);

}  // namespace sabo
