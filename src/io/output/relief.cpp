#include "io/output/relief.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/vec3.hpp"
#include "terrain/bilinear.hpp"

namespace sabo {
namespace {

constexpr Colour no_ground{247, 248, 249};

// Direction to the light: north-west, 45 degrees up, as on printed maps.
const Vec3d light = normalised(Vec3d{-1, 1, std::numbers::sqrt2});

// Brightness of each cell from the slope across its neighbours, from 0 (turned away from the light,
// so that slopes in the shade keep their relief) to 1; NaN without data.
Raster hillshade(const Raster& elevation) {
  const Grid& grid = elevation.grid;
  Raster shade(grid, Raster::no_data);
  const auto at = [&](int column, int row, double otherwise) {
    column = std::clamp(column, 0, grid.columns - 1);
    row = std::clamp(row, 0, grid.rows - 1);
    const double z = elevation.at(column, row);
    return std::isnan(z) ? otherwise : z;
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double z = elevation.at(column, row);
      if (std::isnan(z)) continue;
      const double east = (at(column + 1, row, z) - at(column - 1, row, z)) / (2 * grid.dx);
      const double north = (at(column, row - 1, z) - at(column, row + 1, z)) / (2 * grid.dy);
      shade.at(column, row) = 0.5 + 0.5 * dot(normalised(Vec3d{-east, -north, 1}), light);
    }
  }
  return shade;
}

struct Pixel {
  Colour colour = no_ground;
  double band = Raster::no_data;  // number of the contour line below
  bool is_flow = false;
};

// Between the cells of two classes there is no third one, as interpolation would make it.
double nearest(const Raster& values, double x, double y) {
  const int column = values.grid.column_of(x), row = values.grid.row_of(y);
  return values.grid.has_cell(column, row) ? values.at(column, row) : Raster::no_data;
}

Pixel pixel_at(const Relief& relief, const Raster& shade, double x, double y) {
  Pixel pixel;
  const double light_here = bilinear(shade, x, y, Raster::no_data);
  if (!std::isnan(light_here)) {
    pixel.colour = ground_colour(light_here);
    pixel.band = std::floor(bilinear(relief.elevation, x, y, Raster::no_data) / relief.contour);
  }
  const double value =
      relief.steps.empty() ? bilinear(relief.values, x, y, 0) : nearest(relief.values, x, y);
  if (value > relief.threshold) {
    const Colour colour =
        relief.steps.empty() ? flow_colour(value / relief.top) : step_colour(relief.steps, value);
    // A fifth of the relief shines through.
    pixel.colour = mixed(colour, pixel.colour, 0.2);
    pixel.is_flow = true;
  }
  return pixel;
}

// A pixel beside one of the flow's edge or of another contour band is darker.
Colour with_lines(const Pixel& pixel, const Pixel& left, const Pixel& above) {
  if (pixel.is_flow != left.is_flow || pixel.is_flow != above.is_flow) {
    return mixed(pixel.colour, ground_line_colour, 0.6);
  }
  const auto crosses = [&pixel](const Pixel& other) {
    return !std::isnan(other.band) && !std::isnan(pixel.band) && other.band != pixel.band;
  };
  const bool is_contour = crosses(left) || crosses(above);
  return is_contour ? mixed(pixel.colour, ground_line_colour, 0.28) : pixel.colour;
}

}  // namespace

Image draw_relief(const Relief& relief, const MapView& view, int width, int height) {
  const Raster shade = hillshade(relief.elevation);
  const double dx = (view.east - view.west) / width;
  const double dy = (view.north - view.south) / height;
  Image image{width, height, std::vector<Colour>(static_cast<std::size_t>(width) * height)};
  std::vector<Pixel> above(width);
  for (int row = 0; row < height; ++row) {
    Pixel left;
    for (int column = 0; column < width; ++column) {
      const Pixel pixel =
          pixel_at(relief, shade, view.west + (column + 0.5) * dx, view.north - (row + 0.5) * dy);
      image.pixels[static_cast<std::size_t>(row) * width + column] =
          with_lines(pixel, left, above[column]);
      left = above[column] = pixel;
    }
  }
  return image;
}

}  // namespace sabo
