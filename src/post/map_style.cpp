#include "post/map_style.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "run/pictures.hpp"

namespace sabo {
namespace {

constexpr double least = 0.01;  // of speeds, m/s, and pressures, kPa, as in a run's pictures

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

}  // namespace

MapStyle style_of(const RunMap& map, double wet_depth) {
  const auto labelled = [&](const char* quantity) {
    return fmt::format("{} [{}]", quantity, map.unit);
  };
  if (map.name == "dep") return {"Depth at the end of the run", labelled("depth"), wet_depth, {}};
  if (map.name == "pfd") return {"Greatest depth", labelled("depth"), wet_depth, {}};
  if (map.name == "pfv") return {"Greatest speed", labelled("speed"), least, {}};
  if (map.name == "ppr") return {"Greatest pressure", labelled("pressure"), least, {}};
  if (map.name == "pmf")
    return {"Greatest momentum flux", labelled("density x depth x speed²"), least, {}};
  if (map.name == "det")
    return {"Thickness at the end, normal to the ground", labelled("thickness"), wet_depth, {}};
  if (map.name == "pft")
    return {"Greatest thickness, normal to the ground", labelled("thickness"), wet_depth, {}};
  if (map.name == "tarr") return {"Arrival", labelled("time"), 0, {}};
  if (map.name == "res")
    return {"Resolution", labelled("depth over spacing"), 0, resolution_steps()};
  const std::string what = map.description.empty() ? map.name : map.description;
  return {capitalised(what), labelled(map.name.c_str()), map.unit == "m" ? wet_depth : 0, {}};
}

double greatest_value(const Raster& raster) {
  double greatest = 0;
  for (const double value : raster.values) greatest = std::max(greatest, value);  // false for NaN
  return greatest;
}

}  // namespace sabo
