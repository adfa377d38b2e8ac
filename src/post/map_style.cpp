#include "post/map_style.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/capitalised.hpp"
#include "run/pictures.hpp"

namespace sabo {

MapStyle style_of(const RunMap& map, double wet_depth) {
  const auto labelled = [&](const std::string& quantity) {
    return fmt::format("{} [{}]", quantity, map.unit);
  };
  if (const MapKind* kind = map_kind(map.name)) {
    const bool is_in_classes = map.name == "res";
    return {kind->title, labelled(kind->quantity), kind->threshold(wet_depth),
            is_in_classes ? resolution_steps() : std::vector<ColourStep>{}};
  }
  const std::string what = map.description.empty() ? map.name : map.description;
  return {capitalised(what), labelled(map.name), map.unit == "m" ? wet_depth : 0, {}};
}

std::vector<ColourStep> class_steps(const std::vector<RasterClass>& classes) {
  std::vector<ColourStep> steps;
  for (const RasterClass& one : classes) steps.push_back({one.number + 0.5, one.colour, one.label});
  std::ranges::sort(steps, {}, &ColourStep::end);
  return steps;
}

double greatest_value(const Raster& raster) {
  double greatest = 0;
  for (const double value : raster.values) greatest = std::max(greatest, value);  // false for NaN
  return greatest;
}

}  // namespace sabo
