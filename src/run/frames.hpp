#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/output/vtp.hpp"
#include "particles/particles.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Writes the frames of a run for ParaView: one .vtp per time, listed in flow.pvd, the ground and
/// the bodies.
class Frames {
 public:
  /// Writes ground.vtp and, if there are bodies, bodies.vtp.
  Frames(const Scene& scene, const RunFolder& folder);

  void write(double time, const Particles& fluid);

  /// Which frames there are. What is read takes off those that were written later; throws RunError
  /// when an earlier one is gone.
  template <class Archive>
  void archive(Archive& a) {
    a(count_);
    if constexpr (Archive::is_reader) take_back();
    a(list_);
  }

 private:
  std::filesystem::path file(std::size_t number) const;
  void take_back() const;
  void write_bodies(const Scene& scene) const;

  std::filesystem::path folder_;
  Vec3d origin_;
  PvdWriter list_;
  std::size_t count_ = 0;
};

}  // namespace sabo
