#include "io/output/png.hpp"

#include <atomic>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/output/base64.hpp"

namespace sabo {

std::string png_of(const Image& image) {
  const GdalErrors errors;
  const CPLConfigOptionSetter no_side_file("GDAL_PAM_ENABLED", "NO", false);
  GDALDriverManager& drivers = *GetGDALDriverManager();
  GDALDatasetUniquePtr pixels(
      drivers.GetDriverByName("MEM")->Create("", image.width, image.height, 3, GDT_Byte, nullptr));
  // PNG is written from another dataset only (CreateCopy), in memory under a name of its own.
  static std::atomic<int> counter{0};
  const std::string name = "/vsimem/sabo_picture_" + std::to_string(counter++) + ".png";
  bool is_written =
      pixels != nullptr &&
      pixels->RasterIO(GF_Write, 0, 0, image.width, image.height,
                       const_cast<Colour*>(image.pixels.data()), image.width, image.height,
                       GDT_Byte, 3, nullptr, 3, 3L * image.width, 1, nullptr) == CE_None;
  if (is_written) {
    CPLStringList options;
    options.SetNameValue("ZLEVEL", "9");
    const GDALDatasetUniquePtr copy(drivers.GetDriverByName("PNG")->CreateCopy(
        name.c_str(), pixels.get(), false, options.List(), nullptr, nullptr));
    is_written = copy != nullptr;
  }
  vsi_l_offset size = 0;
  GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &size, true);
  std::string png(reinterpret_cast<const char*>(bytes), bytes ? size : 0);
  CPLFree(bytes);
  if (!is_written || png.empty()) {
    throw RunError("cannot draw a picture: " + errors.failure("not enough memory"));
  }
  return png;
}

std::string data_url_of_png(const std::string& png) {
  return "data:image/png;base64," + base64_of(std::as_bytes(std::span(png)));
}

}  // namespace sabo
