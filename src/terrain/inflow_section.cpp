#include "terrain/inflow_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

constexpr int bisections = 100;

/// Unit vector from the first vertex to the last, in plan; 0 if they are at one place.
Vec3d chord_of(const std::vector<Vec3d>& vertices) {
  const Vec3d chord = in_plan(vertices.back() - vertices.front());
  const double size = norm(chord);
  return size > 0 ? (1 / size) * chord : Vec3d{};
}

}  // namespace

bool InflowSection::turns_back(const Polyline& line) {
  const Vec3d along = chord_of(line.vertices);
  for (std::size_t k = 1; k < line.vertices.size(); ++k)
    if (!(dot(line.vertices[k] - line.vertices[k - 1], along) > 0)) return true;
  return line.vertices.size() < 2;
}

InflowSection::InflowSection(const Surface& surface, const Polyline& line, bool to_left,
                             double spacing, double reach)
    : surface_(&surface),
      spacing_(spacing),
      vertices_(line.vertices),
      along_(chord_of(line.vertices)) {
  direction_ = to_left ? Vec3d{-along_.y, along_.x, 0} : Vec3d{along_.y, -along_.x, 0};
  const double width = norm(in_plan(vertices_.back() - vertices_.front()));
  const auto count = std::max<long>(1, std::lround(width / spacing));
  column_width_ = width / static_cast<double>(count);
  lowest_ = std::numeric_limits<double>::infinity();
  double drop = 0;
  for (long k = 0; k < count; ++k) {
    Vec3d place = on_line((static_cast<double>(k) + 0.5) * column_width_);
    place.z = bed(place);
    drop += place.z - bed(place + reach * direction_);
    lowest_ = std::min(lowest_, place.z);
    columns_.push_back(place);
  }
  fall_ = drop / static_cast<double>(count) / reach;
  cosine_ = 1 / std::hypot(1, fall_);
  bed_at_ends_ = {bed(vertices_.front()), bed(vertices_.back())};
}

/// Place on the line that is `across` (m) from its first vertex, along the chord; z is 0.
Vec3d InflowSection::on_line(double across) const {
  std::size_t k = 1;
  const auto station = [&](std::size_t at) { return dot(vertices_[at] - vertices_[0], along_); };
  while (k + 1 < vertices_.size() && station(k) < across) ++k;
  const double share = (across - station(k - 1)) / (station(k) - station(k - 1));
  return in_plan(vertices_[k - 1] + share * (vertices_[k] - vertices_[k - 1]));
}

double InflowSection::area(double level) const {
  double sum = 0;
  for (const Vec3d& column : columns_) sum += std::max(0.0, level - column.z);
  return column_width_ * sum;
}

double InflowSection::width(double level) const {
  const auto is_wet = [level](const Vec3d& column) { return column.z < level; };
  return column_width_ * static_cast<double>(std::ranges::count_if(columns_, is_wet));
}

double InflowSection::level_of(double wanted) const {
  double low = lowest_;
  double high = lowest_ + wanted / column_width_;  // one column alone would hold it
  for (int k = 0; k < bisections && low < high; ++k) {
    const double middle = 0.5 * (low + high);
    (area(middle) < wanted ? low : high) = middle;
  }
  return high;
}

double InflowSection::froude_speed(double depth, double froude, double gravity) const {
  return froude * cosine_ * std::sqrt(gravity * depth);
}

SectionFlow InflowSection::flow_at(double level, double speed) const {
  return {level, area(level), width(level), speed, level - lowest_};
}

SectionFlow InflowSection::at_speed(double discharge, double speed) const {
  return flow_at(level_of(discharge / (speed * cosine_)), speed);
}

SectionFlow InflowSection::at_froude(double discharge, double froude, double gravity) const {
  const auto speed_at = [&](double level) {
    const double wet = width(level);
    return wet > 0 ? froude_speed(area(level) / wet, froude, gravity) : 0;
  };
  const auto discharge_at = [&](double level) { return area(level) * cosine_ * speed_at(level); };
  double rise = spacing_;
  while (discharge_at(lowest_ + rise) < discharge) rise *= 2;
  double low = lowest_;
  double high = lowest_ + rise;
  for (int k = 0; k < bisections && low < high; ++k) {
    const double middle = 0.5 * (low + high);
    (discharge_at(middle) < discharge ? low : high) = middle;
  }
  return flow_at(high, speed_at(high));
}

double InflowSection::distance(const Vec3d& point) const {
  const double across = dot(point - vertices_.front(), along_);
  return dot(point - on_line(across), direction_);
}

bool InflowSection::holds(const Vec3d& point, double reach) const {
  const double across = dot(point - vertices_.front(), along_);
  const double beyond = distance(point);
  return across >= 0 && across <= column_width_ * static_cast<double>(columns_.size()) &&
         beyond > -spacing_ && beyond <= reach;
}

double InflowSection::rise_at(const Vec3d& point) const {
  return (bed(point + spacing_ * direction_) - bed(point)) / spacing_;
}

}  // namespace sabo
