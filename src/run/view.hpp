#pragma once

#include <filesystem>

#include "case/case.hpp"
#include "io/output/relief.hpp"
#include "io/output/view_scene.hpp"
#include "run/read_frames.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Writes the 3D view of a run, the folder view/: the page, the scene and a script for each frame.
class ViewWriter {
 public:
  /// Makes the folder and removes what an earlier call left there. Throws RunError.
  ViewWriter(std::filesystem::path folder, const Case& c, const Scene& scene);

  /// Throws RunError.
  void add(const RunFrame& frame);

  /// Writes the scene, without which the page shows nothing. Throws RunError.
  void finish();

 private:
  const Case& case_;
  const Scene& scene_;
  std::filesystem::path folder_;
  std::size_t one_of_ = 1;
  ViewScene view_;
  MapView reach_;  // of the flow over all frames
  bool has_flow_ = false;
};

/// Reads the frames of a run back once and writes from them what is made at its end: the folder
/// view/ and the surface of the flow for ParaView, frames/surface.pvd. Throws RunError.
void write_from_frames(const std::filesystem::path& run_folder, const Case& c, const Scene& scene);

/// The folder view/ of a finished run; made from its frames where it is missing or was written for
/// another version of the page. Throws CaseError when the folder is no run or an input is gone,
/// RunError.
std::filesystem::path view_of_run(const std::filesystem::path& run_folder);

}  // namespace sabo
