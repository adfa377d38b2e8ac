#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/output/state_file.hpp"
#include "run/scene.hpp"

namespace sabo {

/// Version of what a checkpoint holds: to be raised with every change of an archive().
inline constexpr std::uint32_t checkpoint_version = 7;

/// What a checkpoint says of itself and of its run.
struct CheckpointHead {
  std::string program;              ///< version
  std::string machine;              ///< processor
  std::string case_text;            ///< the case with every default
  std::vector<std::string> inputs;  ///< checksums of its files, in the order of its keys
  double time = 0;                  ///< s
  std::uint64_t steps = 0;
  Vec3d origin;                ///< of the solver frame
  std::uint64_t released = 0;  ///< particles

  template <class Archive>
  void archive(Archive& a) {
    a.mark("head");
    a(program, machine, case_text, inputs, time, steps, origin, released);
  }
};

/// The head of a checkpoint of this program's, at no time.
CheckpointHead checkpoint_head(const Case& c, const Scene& scene);

/// A file in a run's folder of checkpoints.
struct FoundCheckpoint {
  std::filesystem::path file;
  CheckpointHead head;
};

/// Checkpoints that can be read, the latest first. `on_damage` is told "FILE is damaged ..." of
/// each of the others.
std::vector<FoundCheckpoint> find_checkpoints(
    const std::filesystem::path& folder, const std::function<void(const std::string&)>& on_damage);

/// Writes the checkpoints of a run, in files whose numbers rise. Of those that need not be kept the
/// last two are.
class CheckpointWriter {
 public:
  explicit CheckpointWriter(std::filesystem::path folder);

  /// Throws RunError; those before stay then.
  void write(CheckpointHead head, bool is_kept, const std::function<void(ArchiveWriter&)>& state);

  /// Removes all but the last `count` of those that need not be kept.
  void keep(std::size_t count) const;

 private:
  std::filesystem::path folder_;
  std::size_t next_ = 0;
};

}  // namespace sabo
