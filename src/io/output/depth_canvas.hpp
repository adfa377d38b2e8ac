#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sabo {

/// What a sample of a picture in perspective shows.
enum class Shown : std::uint8_t {
  nothing,
  ground,
  flow,
  wall,
  earth  ///< the ground from below, and where the picture cuts it
};

/// Corner of a triangle on the picture.
struct CanvasCorner {
  double x = 0;         ///< px from the left
  double y = 0;         ///< px from the top
  double nearness = 0;  ///< 1 / distance, 1/m
  float shade = 1;      ///< brightness, 0 to 1
  float value = 0;      ///< of the flow
  float elevation = 0;  ///< of the ground, m
  float wetness = 0;    ///< 1 with flow, 0 without
};

/// The nearest of the triangles at one place of the picture.
struct CanvasSample {
  float nearness = 0;  ///< 1/m; 0 where there is none
  float shade = 0;
  float value = 0;
  float elevation = 0;
  Shown shown = Shown::nothing;
};

/// Hides surfaces behind others: of all triangles drawn, each sample keeps the nearest.
class DepthCanvas {
 public:
  /// `width` x `height` samples.
  DepthCanvas(int width, int height);

  /// A piece of the ground, seen from above when its corners go anticlockwise on the picture; from
  /// below it is earth. Where the wetness passes one quarter it is flow.
  void draw_ground(const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c);

  /// A piece of anything else, the same from both sides.
  void draw_solid(const CanvasCorner& a, const CanvasCorner& b, const CanvasCorner& c, Shown shown);

  int width() const { return width_; }
  int height() const { return height_; }
  const CanvasSample& at(int column, int row) const {
    return samples_[static_cast<std::size_t>(row) * width_ + column];
  }

  /// Whether a point is in front of what is drawn around it; false outside the canvas.
  bool shows(double x, double y, double nearness) const;

 private:
  template <class ShownAt>
  void draw(const std::array<const CanvasCorner*, 3>& corners, ShownAt&& shown_at);

  int width_;
  int height_;
  std::vector<CanvasSample> samples_;
};

}  // namespace sabo
