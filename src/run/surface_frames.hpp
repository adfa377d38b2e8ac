#pragma once

#include <filesystem>

#include "io/output/paraview_state.hpp"
#include "io/output/vtp.hpp"
#include "run/read_frames.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Writes the surface of the flow for ParaView: a surface_*.vtp for each frame, listed in
/// surface.pvd, with depth, mean speed over the column and elevation of the ground; and a state
/// that shows them with the ground and the structures.
class SurfaceFrames {
 public:
  SurfaceFrames(const std::filesystem::path& folder, const Scene& scene);

  /// Throws RunError.
  void write(const RunFrame& frame);

  /// Writes paraview.pvsm, which opens the run as a whole. Throws RunError.
  void finish();

 private:
  const Scene& scene_;
  std::filesystem::path folder_;
  PvdWriter list_;
  ParaviewState shown_;
  bool has_surface_ = false;
};

}  // namespace sabo
