#include "analysis/resolution.hpp"

#include <algorithm>
#include <vector>

#include "analysis/flow_maps.hpp"

namespace sabo {

ResolutionGuard resolution_guard(const Raster& peak_depth, double spacing) {
  std::vector<double> layers;
  for (const double depth : peak_depth.values) {
    if (depth > FlowMaps::wet_depth) layers.push_back(depth / spacing);
  }
  if (layers.empty()) return {};

  const auto middle = layers.begin() + static_cast<std::ptrdiff_t>(layers.size() / 2);
  std::nth_element(layers.begin(), middle, layers.end());
  double median = *middle;
  if (layers.size() % 2 == 0) median = (median + *std::max_element(layers.begin(), middle)) / 2;
  const auto thin = std::count_if(layers.begin(), layers.end(), [](double value) {
    return value < ResolutionGuard::enough_layers;
  });
  const auto count = static_cast<double>(layers.size());
  return {count * peak_depth.grid.cell_area(), median, static_cast<double>(thin) / count};
}

}  // namespace sabo
