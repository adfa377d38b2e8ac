#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "analysis/columns.hpp"
#include "case/case.hpp"
#include "io/output/read_vtp.hpp"
#include "particles/particles.hpp"
#include "run/scene.hpp"

namespace sabo {

/// A frame of a finished run, read back.
struct RunFrame {
  std::size_t number = 0;
  double time = 0;             ///< s
  const Particles& particles;  ///< solver frame; id, position, velocity, pressure and mass
  const Columns& columns;      ///< of these particles
};

/// The frames of a run folder in their order. Throws CaseError when it is no run.
std::vector<PvdEntry> frames_of(const std::filesystem::path& run_folder);

/// The particles of one frame in the solver frame: id, position, velocity, pressure and mass.
/// Throws CaseError when the file is damaged or lacks one of them.
Particles particles_of(const std::filesystem::path& file, const Frame& frame);

/// Calls visit for each frame of a run folder, one in memory at a time. Throws CaseError.
void for_each_frame(const std::filesystem::path& run_folder, const Case& c, const Scene& scene,
                    const std::function<void(const RunFrame&)>& visit);

/// The case of a run folder with the files that it names. Throws CaseError when the folder is no
/// run or an input is gone.
struct FinishedScene {
  Case run_case;
  Scene scene;
};
FinishedScene scene_of_run(const std::filesystem::path& run_folder);

}  // namespace sabo
