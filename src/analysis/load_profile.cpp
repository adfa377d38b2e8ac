#include "analysis/load_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {

double LoadProfile::Bin::pressure() const {
  return width > 0 ? std::hypot(force.x, force.y) / (width * (top - bottom)) : 0;
}

std::size_t LoadProfile::bin_at(double elevation) const {
  return static_cast<std::size_t>(std::max(0.0, std::floor((elevation - base_) / spacing_)));
}

void LoadProfile::add(const Vec3d& place, const Vec3d& impulse) {
  const std::size_t bin = bin_at(place.z);
  if (bin >= impulse_.size()) impulse_.resize(bin + 1);
  impulse_[bin] += impulse;
}

void LoadProfile::touch(const Vec3d& place) {
  const std::size_t bin = bin_at(place.z);
  if (bin >= touched_.size()) touched_.resize(bin + 1);
  touched_[bin].push_back(place);
}

double LoadProfile::covered(const std::vector<Vec3d>& places, const Vec3d& along) const {
  std::vector<double> at;
  for (const Vec3d& place : places) at.push_back(dot(place, along));
  std::ranges::sort(at);
  double length = 0, end = -std::numeric_limits<double>::infinity();
  for (const double middle : at) {
    length += middle + spacing_ / 2 - std::max(end, middle - spacing_ / 2);
    end = middle + spacing_ / 2;
  }
  return length;
}

std::vector<LoadProfile::Bin> LoadProfile::take(double interval) {
  Vec3d total;
  for (const Vec3d& impulse : impulse_) total += impulse;
  const double size = std::hypot(total.x, total.y);
  const Vec3d across = size > 0 ? Vec3d{-total.y / size, total.x / size, 0} : Vec3d{};
  std::vector<Bin> bins(impulse_.size());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].bottom = base_ + static_cast<double>(k) * spacing_;
    bins[k].top = bins[k].bottom + spacing_;
    if (interval > 0) bins[k].force = (1 / interval) * impulse_[k];
    if (k < touched_.size() && size > 0) bins[k].width = covered(touched_[k], across);
  }
  impulse_.clear();
  touched_.clear();
  return bins;
}

}  // namespace sabo
