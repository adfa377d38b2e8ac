#pragma once

#include <string>
#include <vector>

#include "io/output/colour_scale.hpp"

namespace sabo {

/// Pixels row by row from the top left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Colour> pixels;
};

/// The bytes of a PNG file. Throws RunError.
std::string png_of(const Image& image);

/// "data:image/png;base64,..." for an <image> element.
std::string data_url_of_png(const std::string& png);

}  // namespace sabo
