#pragma once

#include <vector>

#include "terrain/polyline.hpp"
#include "terrain/surface.hpp"

namespace sabo {

/// What flows through a section at a discharge.
struct SectionFlow {
  double level = 0;  ///< of its surface, m
  double area = 0;   ///< wet, of the vertical plane, m2
  double width = 0;  ///< of its surface, m
  double speed = 0;  ///< along the bed, m/s
  double depth = 0;  ///< greatest, vertical, m
};

/// A vertical section through which a flow comes in, all of it in one direction: the normal of the
/// straight line between the ends of its line. Its bed is sampled in columns about a particle
/// spacing wide, so that they fill the line; a level fills each from its bed up.
class InflowSection {
 public:
  /// `to_left`: the flow goes to the left side, looking along the line from its first vertex to its
  /// last. The slope is that of the bed over `reach` (m) from there on, the mean of all columns.
  /// `line` must not turn back: see turns_back(). The surface must outlive the section.
  InflowSection(const Surface& surface, const Polyline& line, bool to_left, double spacing,
                double reach);

  /// Whether a line has no length or goes backwards somewhere, seen along the straight line between
  /// its ends.
  static bool turns_back(const Polyline& line);

  double area(double level) const;     ///< m2
  double width(double level) const;    ///< m
  double level_of(double area) const;  ///< the level that has an area (m2), m

  /// What flows at a discharge (m3/s, above 0) and a speed (m/s, above 0).
  SectionFlow at_speed(double discharge, double speed) const;
  /// The same where u^2 = froude^2 g cos(slope) h, h normal to the bed: the mean depth A/B of a
  /// section that is not a rectangle (Chow 1959, section 3-3).
  SectionFlow at_froude(double discharge, double froude, double gravity) const;
  /// Speed along the bed of a flow of a vertical depth (m), m/s.
  double froude_speed(double depth, double froude, double gravity) const;

  /// Places on the line, with the elevation of the bed.
  const std::vector<Vec3d>& columns() const { return columns_; }
  double column_width() const { return column_width_; }  ///< m
  const Vec3d& direction() const { return direction_; }  ///< unit, in plan
  double cosine() const { return cosine_; }              ///< of the slope of the bed
  double fall() const { return fall_; }                  ///< of the bed in the direction, m/m
  double lowest() const { return lowest_; }              ///< elevation of the bed, m
  /// Elevation of the bed at the two ends of the line, m.
  const std::vector<double>& bed_at_ends() const { return bed_at_ends_; }

  /// How far a point is beyond the line in the direction, m; negative before it.
  double distance(const Vec3d& point) const;
  /// Whether a point is between the ends of the line and up to `reach` (m) beyond it, or less than
  /// a spacing before it.
  bool holds(const Vec3d& point, double reach) const;
  /// Elevation of the bed below a point, m.
  double bed(const Vec3d& point) const { return surface_->height(point.x, point.y); }
  /// Elevation that the bed gains in the direction, over a spacing, m/m.
  double rise_at(const Vec3d& point) const;

 private:
  Vec3d on_line(double across) const;
  SectionFlow flow_at(double level, double speed) const;

  const Surface* surface_;
  double spacing_;
  std::vector<Vec3d> vertices_;
  Vec3d along_;  // unit, from the first vertex to the last, in plan
  Vec3d direction_;
  double column_width_ = 0;
  std::vector<Vec3d> columns_;
  std::vector<double> bed_at_ends_;
  double lowest_ = 0;
  double fall_ = 0;
  double cosine_ = 1;
};

}  // namespace sabo
