#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/curtain.hpp"
#include "particles/places.hpp"

namespace sabo {

/// Where the released volume is, m3: released = trapped + beyond + outflow.
struct VolumeRow {
  double released = 0;
  double trapped = 0;          ///< in the domain and not beyond the dam
  double beyond = 0;           ///< in the domain and beyond the dam; 0 without a dam
  double outflow = 0;          ///< left the domain, from either side of the dam
  std::uint64_t put_back = 0;  ///< particles found in the ground or a solid and put back
};

/// Ledger of volumes about one dam; a run with several dams keeps one for each.
///
/// A particle is beyond the dam when its net number of crossings of the curtain through the dam's
/// axis is positive. Crossings are kept for each particle, so that one which passed the dam and
/// then left the domain counts as outflow alone.
class VolumeLedger {
 public:
  /// Without a dam. Density in kg/m3: volumes are masses divided by it.
  explicit VolumeLedger(double reference_density) : reference_density_(reference_density) {}

  /// `upstream` is any point on the side that the flow comes from, e.g. the centre of the release.
  VolumeLedger(double reference_density, const Polyline& dam_axis, const Vec3d& upstream);

  /// Particles that enter the run. Every particle must be released, once, before it is recorded or
  /// leaves.
  void release(const Particles& particles);

  /// Paths from `before` (one position a row, see Tracks) to where the particles are. Threads: 0
  /// stands for all.
  void record(const std::vector<Vec3d>& before, const Places& particles, int threads = 1);

  /// Particles that left the domain, their last path recorded; they must not come back.
  void leave(const Particles& particles);

  void put_back(std::uint64_t count) { put_back_ += count; }

  VolumeRow row() const;

  /// Whether all of these particles were released.
  bool knows(const Particles& particles) const;

  template <class Archive>
  void archive(Archive& a) {
    a(crossings_);
    a(released_, beyond_, outflow_, put_back_);
  }

 private:
  double reference_density_;
  std::optional<Curtain> dam_;
  int downstream_ = 1;          // sign of a crossing that goes downstream
  std::vector<int> crossings_;  // net and downstream, by particle number
  double released_ = 0;         // masses, kg
  double beyond_ = 0;
  double outflow_ = 0;
  std::uint64_t put_back_ = 0;
};

}  // namespace sabo
