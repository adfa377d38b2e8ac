#pragma once

#include <cstddef>

#include "backend/backend.hpp"
#include "base/background.hpp"
#include "io/output/vtp.hpp"
#include "run/run_folder.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Writes the frames of a run for ParaView: one .vtp per time, listed in flow.pvd, the ground and
/// the bodies.
class Frames {
 public:
  /// Writes ground.vtp and, if there are bodies, bodies.vtp. Frames are written by `threads`
  /// (host_threads()).
  Frames(const Scene& scene, const RunFolder& folder, int threads);

  /// A frame of the fluid as it is; beside the steps where these leave the host to itself. Throws
  /// RunError, for an earlier frame that was written beside the steps too.
  void write(double time, Backend& backend);

  /// Waits until all are written. Throws RunError.
  void settle() { writing_.settle(); }

  /// Which frames there are. What is read takes off those that were written later; throws RunError
  /// when an earlier one is gone.
  template <class Archive>
  void archive(Archive& a) {
    settle();
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
  int threads_;
  Background writing_;  // the last: it ends before what it works on
};

}  // namespace sabo
