#include "analysis/load_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sabo {
namespace {

/// Where the places of a bin are along a unit vector, sorted.
std::vector<double> stations(const std::vector<std::vector<Vec3d>>& places, std::size_t bin,
                             const Vec3d& along) {
  std::vector<double> at;
  if (bin >= places.size()) return at;
  for (const Vec3d& place : places[bin]) at.push_back(dot(place, along));
  std::ranges::sort(at);
  return at;
}

/// From a number to the nearest of some that are sorted; infinite if there are none.
double distance_to(const std::vector<double>& sorted, double number) {
  const auto above = std::ranges::lower_bound(sorted, number);
  double nearest = std::numeric_limits<double>::infinity();
  if (above != sorted.end()) nearest = *above - number;
  if (above != sorted.begin()) nearest = std::min(nearest, number - *(above - 1));
  return nearest;
}

}  // namespace

/// The outermost particle of the flow is a spacing away from the nearest one of the structure, and
/// is felt as far beside that as the kernel reaches.
LoadProfile::LoadProfile(double base, double spacing, double radius)
    : base_(base),
      spacing_(spacing),
      overhang_(std::sqrt(std::max(radius * radius - spacing * spacing, 0.0))) {}

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

void LoadProfile::see(const Vec3d& place, bool feels_flow) {
  const std::size_t bin = bin_at(place.z);
  std::vector<std::vector<Vec3d>>& places = feels_flow ? felt_ : unfelt_;
  if (bin >= places.size()) places.resize(bin + 1);
  places[bin].push_back(place);
}

/// Length that the flow covers in a bin along a horizontal unit vector, m. Each place that feels it
/// counts as a spacing, but for those within the overhang from one that does not: there only the
/// kernel reaches. At an end of the structure there is no such place, and all counts.
double LoadProfile::covered(std::size_t bin, const Vec3d& along) const {
  const std::vector<double> felt = stations(felt_, bin, along);
  std::vector<double> unfelt = stations(unfelt_, bin, along);
  // But for what lies deeper in the structure, behind a place that feels the flow.
  std::erase_if(unfelt, [&](double at) { return distance_to(felt, at) < spacing_ / 2; });
  double length = 0, end = -std::numeric_limits<double>::infinity();
  for (const double middle : felt) {
    if (distance_to(unfelt, middle) < overhang_) continue;
    length += middle + spacing_ / 2 - std::max(end, middle - spacing_ / 2);
    end = middle + spacing_ / 2;
  }
  return felt.empty() ? 0 : std::max(length, spacing_);
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
    if (size > 0) bins[k].width = covered(k, across);
  }
  impulse_.clear();
  felt_.clear();
  unfelt_.clear();
  return bins;
}

}  // namespace sabo
