#include "analysis/probes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sabo {
namespace {

/// Places along a gauge at which the filling is known, per smoothing length.
constexpr double places_per_h = 16;

/// Length over which a quantity, linear between two places a step apart, is above 1/2.
double length_above_half(double a, double b, double step) {
  const double low = std::min(a, b), high = std::max(a, b);
  if (low > 0.5) return step;
  return high > 0.5 ? step * (high - 0.5) / (high - low) : 0;
}

}  // namespace

double pressure_at(const Particles& fluid, const Vec3d& point, const WendlandC2<double>& kernel,
                   const Vec3d& gravity) {
  double weight = 0, sum = 0;
  const double radius2 = kernel.radius() * kernel.radius();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d x = point - fluid.position[i];
    const double r2 = dot(x, x);
    if (r2 >= radius2) continue;
    const double w = fluid.mass[i] / fluid.density[i] * kernel.value(std::sqrt(r2));
    weight += w;
    sum += w * (fluid.pressure[i] + fluid.density[i] * dot(gravity, x));
  }
  return weight > 0 ? sum / weight : 0;
}

double water_height(const Particles& fluid, const Vec3d& point, const WendlandC2<double>& kernel) {
  const double step = kernel.h / places_per_h;
  std::vector<double> filling;
  const auto add = [&](double height, double plan2, double volume) {
    const double reach = std::sqrt(kernel.radius() * kernel.radius() - plan2);
    const auto first = static_cast<std::ptrdiff_t>(std::ceil((height - reach) / step));
    const auto last = static_cast<std::ptrdiff_t>(std::floor((height + reach) / step));
    if (last < 0) return;
    // One more, which stays empty: the line ends above the fluid.
    if (std::ssize(filling) < last + 2) filling.resize(static_cast<std::size_t>(last) + 2, 0.0);
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(first, 0); k <= last; ++k) {
      const double z = static_cast<double>(k) * step - height;
      filling[k] += volume * kernel.value(std::sqrt(plan2 + z * z));
    }
  };
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Vec3d x = fluid.position[i] - point;
    const double plan2 = x.x * x.x + x.y * x.y;
    if (plan2 >= kernel.radius() * kernel.radius() || x.z < 0) continue;
    const double volume = fluid.mass[i] / fluid.density[i];
    add(x.z, plan2, volume);
    add(-x.z, plan2, volume);
  }
  double length = 0;
  for (std::size_t k = 1; k < filling.size(); ++k)
    length += length_above_half(filling[k - 1], filling[k], step);
  return length;
}

}  // namespace sabo
