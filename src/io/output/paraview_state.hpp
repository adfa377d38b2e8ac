#pragma once

#include <filesystem>
#include <string>

#include "geometry/triangle_mesh.hpp"

namespace sabo {

/// What ParaView is to show of a run when its state file is opened.
struct ParaviewState {
  std::filesystem::path folder;  ///< of the frames; absolute, because ParaView takes names so
  bool has_bodies = false;       ///< bodies.vtp is there
  double end = 0;                ///< time of the last frame, s
  double deepest = 0;            ///< depth at the dark end of the colours, m
  Bounds flow{};                 ///< of its surface in all frames, in the frame of the files
};

/// A state of ParaView (5.11 and later read it): the ground, structures, the surface of the flow
/// coloured by depth, its particles ready to be shown, and the times of the frames.
std::string paraview_state(const ParaviewState& state);

}  // namespace sabo
