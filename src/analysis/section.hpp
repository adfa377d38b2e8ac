#pragma once

#include <utility>
#include <vector>

#include "analysis/curtain.hpp"
#include "particles/places.hpp"

namespace sabo {

/// Volumes through a section, m3; both are positive numbers.
struct SectionVolumes {
  double forward = 0;   ///< from left to right, looking from the first to the last vertex
  double backward = 0;  ///< the other way
  double net() const { return forward - backward; }
  friend bool operator==(const SectionVolumes&, const SectionVolumes&) = default;
};

/// Discharge through a vertical curtain from exact crossings of the particles' paths (see Curtain).
class Section {
 public:
  explicit Section(Polyline line) : curtain_(std::move(line)) {}

  /// Counts `volume` (m3) for its straight path; one that crosses both ways counts its net only.
  void record(const Vec3d& from, const Vec3d& to, double volume);

  /// All particles at once: from `before` (one position a row, see Tracks) to where they are.
  /// Threads: 0 stands for all.
  void record(const std::vector<Vec3d>& before, const Places& particles, double reference_density,
              int threads = 1);

  /// Since the start.
  const SectionVolumes& total() const { return total_; }

  /// Since the last call; discharge is this by the time in between.
  SectionVolumes take_interval();

  template <class Archive>
  void archive(Archive& a) {
    a(total_, interval_);
  }

 private:
  void add(int net, double volume);

  Curtain curtain_;
  SectionVolumes total_;
  SectionVolumes interval_;
};

}  // namespace sabo
