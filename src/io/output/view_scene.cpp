#include "io/output/view_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "io/gis/crs.hpp"
#include "io/gis/gdal_errors.hpp"
#include "io/output/base64.hpp"
#include "io/output/json.hpp"
#include "io/output/view_frame.hpp"

namespace sabo {
namespace {

constexpr std::uint16_t no_height = 65535;

/// The texts in brackets.
template <class Items, class Text>
std::string list_of(const Items& items, const Text& text) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.push_back(text(item));
  return fmt::format("[{}]", fmt::join(texts, ","));
}

std::string ground_text(const ViewScene& scene) {
  const Grid& grid = scene.ground.grid;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double z : scene.ground.values) {
    if (!std::isfinite(z)) continue;
    low = std::min(low, z);
    high = std::max(high, z);
  }
  std::vector<std::uint16_t> heights;
  heights.reserve(grid.size());
  for (const double z : scene.ground.values)
    heights.push_back(std::isfinite(z) ? quantised(z, low, high, no_height - 1) : no_height);
  return fmt::format(
      "{{\"columns\":{},\"rows\":{},\"west\":{:.17g},\"north\":{:.17g},\"dx\":{:.17g},"
      "\"dy\":{:.17g},\"stride\":{},\"low\":{:.9g},\"high\":{:.9g},\n\"heights\":\"{}\"}}",
      grid.columns, grid.rows, grid.west, grid.north, grid.dx, grid.dy, scene.stride, low, high,
      packed(heights));
}

std::string solid_text(const ViewSolid& solid) {
  std::vector<std::byte> bytes;
  for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3d& p = solid.mesh.corner(t, corner);
      for (const double value : {p.x, p.y, p.z})
        append_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
    }
  }
  return fmt::format("{{\"name\":{},\"triangles\":{},\"corners\":\"{}\"}}\n",
                     json_string(solid.name), solid.mesh.triangles.size(), base64_of(bytes));
}

const char* kind_word(MapLine::Kind kind) {
  switch (kind) {
    case MapLine::Kind::dam:
      return "dam";
    case MapLine::Kind::section:
    case MapLine::Kind::inflow:
      return "section";
    case MapLine::Kind::zone:
      return "zone";
    case MapLine::Kind::edit:
      return "edit";
    case MapLine::Kind::path:
      break;
  }
  return "path";
}

std::string line_text(const MapLine& line) {
  return fmt::format("{{\"kind\":\"{}\",\"name\":{},\"points\":{}}}\n", kind_word(line.kind),
                     json_string(line.label), list_of(line.line.vertices, [](const Vec3d& p) {
                       return fmt::format("[{:.9g},{:.9g}]", p.x, p.y);
                     }));
}

std::string frame_text(const ViewFrameEntry& entry) {
  return fmt::format("[{},{:.9g},{}]", entry.number, entry.time, entry.count);
}

}  // namespace

std::string view_scene_script(const ViewScene& scene) {
  const GdalErrors errors;
  const std::string& wkt = scene.frame.crs;
  return fmt::format(
      "sabo_scene({{\"format\":{},\"title\":{},\"note\":{},\"run\":{},\"program\":{},\"crs\":{},\n"
      "\"origin\":[{:.17g},{:.17g}],\"spacing\":{},\"one_of\":{},\n"
      "\"tops\":{{\"depth\":{},\"speed\":{},\"pressure\":{}}},\n"
      "\"frames\":{},\n\"lines\":{},\n\"solids\":{},\n\"ground\":{}}});\n",
      view_format, json_string(scene.title), json_string(scene.note), json_string(scene.run),
      json_string(scene.program), json_string(wkt.empty() ? "" : name_of(crs_of(wkt))),
      scene.frame.origin_x, scene.frame.origin_y, json_number(scene.spacing), scene.one_of,
      json_number(scene.depth_top), json_number(scene.speed_top), json_number(scene.pressure_top),
      list_of(scene.frames, frame_text), list_of(scene.lines, line_text),
      list_of(scene.solids, solid_text), ground_text(scene));
}

}  // namespace sabo
