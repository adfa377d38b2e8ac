#pragma once

#include <cmath>
#include <numbers>

#include "geometry/box_mesh.hpp"

namespace sabo::test {

/// From (0, 0, 0) to (1, 1, 1).
inline UprightBox unit_box() { return {{0, 0, 0}, {1, 1, 1}, {}, 0}; }

/// A sphere of bands between circles of latitude, each a regular polygon of `meridians` corners.
inline TriangleMesh sphere_mesh(const Vec3d& centre, double radius, int bands, int meridians) {
  TriangleMesh mesh;
  mesh.vertices.push_back(centre - Vec3d{0, 0, radius});
  for (int band = 1; band < bands; ++band) {
    const double latitude = std::numbers::pi * (double(band) / bands - 0.5);
    for (int k = 0; k < meridians; ++k) {
      const double longitude = 2 * std::numbers::pi * k / meridians;
      mesh.vertices.push_back(centre + radius * Vec3d{std::cos(latitude) * std::cos(longitude),
                                                      std::cos(latitude) * std::sin(longitude),
                                                      std::sin(latitude)});
    }
  }
  mesh.vertices.push_back(centre + Vec3d{0, 0, radius});
  const auto at = [&](int band, int k) -> std::uint32_t {
    if (band == 0) return 0;
    if (band == bands) return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    return static_cast<std::uint32_t>(1 + (band - 1) * meridians + k % meridians);
  };
  for (int band = 0; band < bands; ++band)
    for (int k = 0; k < meridians; ++k) {
      if (band > 0) mesh.triangles.push_back({at(band, k), at(band, k + 1), at(band + 1, k)});
      if (band + 1 < bands)
        mesh.triangles.push_back({at(band, k + 1), at(band + 1, k + 1), at(band + 1, k)});
    }
  return mesh;
}

/// Its volume: frusta between regular polygons.
inline double sphere_mesh_volume(double radius, int bands, int meridians) {
  const auto area = [&](int band) {
    const double r = radius * std::sin(std::numbers::pi * band / bands);
    return 0.5 * meridians * r * r * std::sin(2 * std::numbers::pi / meridians);
  };
  double sum = 0;
  for (int band = 0; band < bands; ++band) {
    const double height = radius * (std::cos(std::numbers::pi * band / bands) -
                                    std::cos(std::numbers::pi * (band + 1) / bands));
    sum += height / 3 * (area(band) + area(band + 1) + std::sqrt(area(band) * area(band + 1)));
  }
  return sum;
}

}  // namespace sabo::test
