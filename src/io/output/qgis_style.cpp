#include "io/output/qgis_style.hpp"

#include <fmt/format.h>

#include "io/output/markup.hpp"

namespace sabo {
namespace {

constexpr double opacity = 0.8;  // a fifth of the relief shines through, as in our pictures

std::string document(const std::string& renderer) {
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22\" styleCategories=\"AllStyleCategories\" "
      "hasScaleBasedVisibilityFlag=\"0\" maxScale=\"0\" minScale=\"1e+08\">\n"
      "  <pipe>\n{}"
      "    <brightnesscontrast brightness=\"0\" contrast=\"0\" gamma=\"1\"/>\n"
      "    <huesaturation saturation=\"0\" grayscaleMode=\"0\" colorizeOn=\"0\"/>\n"
      "    <rasterresampler maxOversampling=\"2\"/>\n"
      "  </pipe>\n  <blendMode>0</blendMode>\n</qgis>\n",
      renderer);
}

struct RampItem {
  std::string value;
  Colour colour;
  std::string label;
};

// Where a colour ends a range of values; `transparent` is the rasterTransparency element.
std::string pseudocolour(std::string_view type, double low, double high,
                         const std::vector<RampItem>& items, const std::string& transparent) {
  std::string list;
  for (const RampItem& item : items) {
    list += fmt::format("          <item alpha=\"255\" value=\"{}\" label=\"{}\" color=\"{}\"/>\n",
                        item.value, escaped(item.label), hex(item.colour));
  }
  return fmt::format(
      "    <rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" alphaBand=\"-1\" "
      "opacity=\"{0}\" classificationMin=\"{1:.9g}\" classificationMax=\"{2:.9g}\" "
      "nodataColor=\"\">\n{3}"
      "      <minMaxOrigin>\n        <limits>None</limits>\n        <extent>WholeRaster</extent>\n"
      "        <statAccuracy>Estimated</statAccuracy>\n      </minMaxOrigin>\n"
      "      <rastershader>\n"
      "        <colorrampshader colorRampType=\"{4}\" classificationMode=\"1\" clip=\"0\" "
      "minimumValue=\"{1:.9g}\" maximumValue=\"{2:.9g}\" labelPrecision=\"4\">\n{5}"
      "        </colorrampshader>\n      </rastershader>\n    </rasterrenderer>\n",
      opacity, low, high, transparent, type, list);
}

}  // namespace

std::string qgis_flow_style(std::string_view label, double threshold, double top) {
  constexpr int pieces = 8;
  std::vector<RampItem> items;
  for (int i = 0; i <= pieces; ++i) {
    const double value = top * i / pieces;
    items.push_back({fmt::format("{:.9g}", value), flow_colour(static_cast<double>(i) / pieces),
                     i == 0 ? fmt::format("0 {}", label) : fmt::format("{:.4g}", value)});
  }
  const std::string transparent = fmt::format(
      "      <rasterTransparency>\n        <singleValuePixelList>\n"
      "          <pixelListEntry min=\"-1e+30\" max=\"{:.9g}\" percentTransparent=\"100\"/>\n"
      "        </singleValuePixelList>\n      </rasterTransparency>\n",
      threshold);
  return document(pseudocolour("INTERPOLATED", 0, top, items, transparent));
}

std::string qgis_step_style(std::string_view label, std::span<const ColourStep> steps) {
  std::vector<RampItem> items;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    items.push_back({k + 1 < steps.size() ? fmt::format("{:.9g}", steps[k].end) : "inf",
                     steps[k].colour,
                     k == 0 ? fmt::format("{} {}", steps[k].label, label) : steps[k].label});
  }
  const double low = steps.front().end;
  const double high = steps.size() > 1 ? steps[steps.size() - 2].end : low;
  return document(pseudocolour("DISCRETE", low, high, items, "      <rasterTransparency/>\n"));
}

std::string qgis_class_style(const std::vector<RasterClass>& classes) {
  std::string entries;
  for (const RasterClass& name : classes) {
    entries += fmt::format(
        "        <paletteEntry value=\"{}\" color=\"{}\" alpha=\"255\" label=\"{}\"/>\n",
        name.number, hex(name.colour), escaped(name.label));
  }
  return document(fmt::format(
      "    <rasterrenderer type=\"paletted\" band=\"1\" alphaBand=\"-1\" opacity=\"{}\" "
      "nodataColor=\"\">\n      <rasterTransparency/>\n      <colorPalette>\n{}"
      "      </colorPalette>\n    </rasterrenderer>\n",
      opacity, entries));
}

std::string qgis_ground_style() {
  return document(
      "    <rasterrenderer type=\"hillshade\" band=\"1\" alphaBand=\"-1\" opacity=\"1\" "
      "azimuth=\"315\" angle=\"45\" zfactor=\"1\" multidirection=\"0\" nodataColor=\"\">\n"
      "      <rasterTransparency/>\n    </rasterrenderer>\n");
}

}  // namespace sabo
