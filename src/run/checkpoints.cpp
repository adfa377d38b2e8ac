#include "run/checkpoints.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/version.hpp"
#include "io/case_file/write_case.hpp"
#include "io/output/checksum.hpp"
#include "io/output/cpu_name.hpp"
#include "run/input_files.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".sabo";
constexpr const char* kept_extension = ".kept";  // before the other one

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == extension && entry.path().stem().extension() != ".part")
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::size_t number_of(const fs::path& file) {
  return std::strtoul(file.filename().c_str(), nullptr, 10);
}

}  // namespace

CheckpointHead checkpoint_head(const Case& c, const Scene& scene) {
  CheckpointHead head;
  head.program = build_version;
  head.machine = cpu_name();
  head.case_text = write_case(c);
  for (const fs::path& file : input_files(c)) head.inputs.push_back(checksum(file));
  head.origin = scene.frame.origin();
  head.released = scene.release.size();
  return head;
}

std::vector<FoundCheckpoint> find_checkpoints(
    const fs::path& folder, const std::function<void(const std::string&)>& on_damage) {
  std::vector<FoundCheckpoint> found;
  for (const fs::path& file : files_in(folder)) {
    try {
      FoundCheckpoint checkpoint{file, {}};
      read_state_file(file, checkpoint_version).read_head([&](ArchiveReader& a) {
        a(checkpoint.head);
      });
      found.push_back(std::move(checkpoint));
    } catch (const RunError& error) {
      on_damage(fmt::format("{} {}", file.string(), error.what()));
    }
  }
  std::ranges::stable_sort(found, [](const FoundCheckpoint& a, const FoundCheckpoint& b) {
    return a.head.steps > b.head.steps;
  });
  return found;
}

CheckpointWriter::CheckpointWriter(fs::path folder) : folder_(std::move(folder)) {
  for (const fs::path& file : files_in(folder_)) next_ = std::max(next_, number_of(file) + 1);
}

void CheckpointWriter::write(CheckpointHead head, bool is_kept,
                             const std::function<void(ArchiveWriter&)>& state) {
  const fs::path file =
      folder_ / fmt::format("{:06}{}{}", next_, is_kept ? kept_extension : "", extension);
  write_state_file(file, checkpoint_version, [&](ArchiveWriter& a) {
    a(head);
    state(a);
  });
  ++next_;
  keep(2);
}

void CheckpointWriter::keep(std::size_t count) const {
  std::vector<fs::path> files = files_in(folder_);
  std::erase_if(files,
                [](const fs::path& file) { return file.stem().extension() == kept_extension; });
  std::error_code error;
  for (std::size_t k = 0; k + count < files.size(); ++k) fs::remove(files[k], error);
}

}  // namespace sabo
