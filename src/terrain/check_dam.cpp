#include "terrain/check_dam.hpp"

#include <algorithm>
#include <cmath>

namespace sabo {
namespace {

constexpr double thinnest_part = 1e-9;  // m: less is rounding

/// Sorted, and without those that differ by rounding only.
std::vector<double> cuts(std::vector<double> values, double size) {
  std::sort(values.begin(), values.end());
  const double tolerance = 1e-9 * (1 + size);
  const auto same = [&](double a, double b) { return b - a < tolerance; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

}  // namespace

double CheckDam::crest_at(double station) const {
  const double end = length(axis);
  const double within = std::clamp(station, 0.0, end);
  if (axis.has_z) return point_at(axis, within).z;
  if (profile.size() < 2 || !(end > 0)) return crest;
  const auto last = static_cast<double>(profile.size() - 1);
  const double place = within / end * last;
  const auto k = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
  return std::lerp(profile[k], profile[k + 1], place - static_cast<double>(k));
}

double CheckDam::top(double station) const { return crest_at(station) - notch_depth(station); }

double CheckDam::notch_depth(double station) const {
  if (!notch) return 0;
  const double beyond_sill = std::abs(station - notch->centre) - notch->width / 2;
  if (beyond_sill <= 0) return notch->depth;
  if (notch->side_slope <= 0) return 0;
  return std::max(0.0, notch->depth - beyond_sill / notch->side_slope);
}

bool CheckDam::contains(const Vec3d& point) const {
  const LinePlace place = project(axis, point.x, point.y);
  if (std::abs(place.offset) > thickness / 2 || place.station < 0 || place.station > length(axis) ||
      point.z >= top(place.station)) {
    return false;
  }
  return std::none_of(openings.begin(), openings.end(), [&](const Opening& opening) {
    return place.station > opening.from && place.station < opening.to &&
           opening.reaches(place.offset) && point.z > opening.bottom && point.z < opening.top;
  });
}

std::vector<DamPart> solid_parts(const CheckDam& dam, double station, double offset,
                                 double ground) {
  std::vector<DamPart> parts{{ground, dam.top(station)}};
  for (const Opening& opening : dam.openings) {
    if (station <= opening.from || station >= opening.to || !opening.reaches(offset)) continue;
    std::vector<DamPart> left;
    for (const DamPart& part : parts) {
      left.push_back({part.bottom, std::min(part.top, opening.bottom)});
      left.push_back({std::max(part.bottom, opening.top), part.top});
    }
    parts = std::move(left);
  }
  std::erase_if(parts,
                [](const DamPart& part) { return !(part.top - part.bottom > thinnest_part); });
  return parts;
}

std::vector<double> dam_stations(const CheckDam& dam) {
  const double end = length(dam.axis);
  std::vector<double> stations{0, end};
  double station = 0;
  for (std::size_t k = 1; k < dam.axis.vertices.size(); ++k) {
    const Vec3d step = dam.axis.vertices[k] - dam.axis.vertices[k - 1];
    station += std::hypot(step.x, step.y);
    stations.push_back(station);
  }
  if (dam.notch) {
    const double half_sill = dam.notch->width / 2;
    const double half_crest = half_sill + dam.notch->side_slope * dam.notch->depth;
    for (const double half : {half_sill, half_crest}) {
      stations.push_back(dam.notch->centre - half);
      stations.push_back(dam.notch->centre + half);
    }
  }
  for (const Opening& opening : dam.openings)
    stations.insert(stations.end(), {opening.from, opening.to});
  for (double& s : stations) s = std::clamp(s, 0.0, end);
  return cuts(std::move(stations), end);
}

std::vector<double> dam_offsets(const CheckDam& dam, double station) {
  std::vector<double> offsets{-dam.thickness / 2, dam.thickness / 2};
  for (const Opening& opening : dam.openings) {
    if (station <= opening.from || station >= opening.to || opening.core >= dam.thickness) continue;
    if (opening.core > 0) offsets.insert(offsets.end(), {-opening.core / 2, opening.core / 2});
  }
  return cuts(std::move(offsets), dam.thickness);
}

}  // namespace sabo
