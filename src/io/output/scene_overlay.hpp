#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/output/map_picture.hpp"
#include "io/output/scene_view.hpp"

namespace sabo {

inline constexpr const char* wall_label_colour = "#8c1c13";

/// Where a finished canvas stands on the page.
struct ScenePage {
  const SceneMesh& mesh;
  const DepthCanvas& canvas;
  CanvasView view;
  double left = 0;   ///< px, of the canvas on the page
  double top = 0;    ///< px
  double width = 0;  ///< px
  double height = 0;
};

/// A point on the page and whether it can be seen.
struct PagePoint {
  double x = 0;
  double y = 0;
  bool is_seen = false;
};

/// Keeps labels off each other and inside the picture.
class SceneLabels {
 public:
  explicit SceneLabels(const ScenePage& page) : page_(page) {}

  /// Writes a label above one of the points that are seen, the uppermost where there is room, if
  /// need be at the end of a leader line; leaves it out where there is none.
  void add(std::string_view text, const char* colour, std::vector<PagePoint> places);

  const std::string& svg() const { return svg_; }

 private:
  struct Box {
    double left, top, right, bottom;
  };
  bool is_free(const Box& box) const;

  ScenePage page_;
  std::vector<Box> taken_;
  std::string svg_;
};

/// A point of the scene (height as drawn) on the page.
PagePoint page_point(const ScenePage& page, const Vec3d& point);

/// A line laid on the surface, in pieces where it can be seen, and its label.
std::string draw_draped(const ScenePage& page, const MapLine& line, SceneLabels& labels);

}  // namespace sabo
