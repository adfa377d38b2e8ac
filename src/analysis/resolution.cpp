#include "analysis/resolution.hpp"

#include <algorithm>
#include <vector>

#include "analysis/columns.hpp"

namespace sabo {

ResolutionGuard resolution_guard(const Raster& peak_depth, double spacing) {
  std::vector<double> layers;
  for (const double depth : peak_depth.values) {
    if (depth > wet_depth(spacing)) layers.push_back(depth / spacing);
  }
  if (layers.empty()) return {};

  const auto middle = layers.begin() + static_cast<std::ptrdiff_t>(layers.size() / 2);
  std::nth_element(layers.begin(), middle, layers.end());
  double median = *middle;
  if (layers.size() % 2 == 0) median = (median + *std::max_element(layers.begin(), middle)) / 2;
  const auto count = static_cast<double>(layers.size());
  const auto share_below = [&](double limit) {
    const auto below = [limit](double value) { return value < limit; };
    return static_cast<double>(std::count_if(layers.begin(), layers.end(), below)) / count;
  };
  const double thin = share_below(ResolutionGuard::enough_layers);
  return {count * peak_depth.grid.cell_area(), median, thin,
          share_below(ResolutionGuard::good_layers) - thin};
}

Raster layers_map(const Raster& peak_depth, double spacing) {
  Raster layers(peak_depth.grid, Raster::no_data);
  for (std::size_t cell = 0; cell < layers.values.size(); ++cell) {
    const double depth = peak_depth.values[cell];
    if (depth > wet_depth(spacing)) layers.values[cell] = depth / spacing;
  }
  return layers;
}

}  // namespace sabo
