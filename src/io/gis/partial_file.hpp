#pragma once

#include <filesystem>

namespace sabo {

/// A file that is written under a temporary name beside its own, so that readers see the old file
/// or the complete new one. Removed when it was not committed.
class PartialFile {
 public:
  explicit PartialFile(std::filesystem::path target);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write; has the extension of the target, by which GDAL knows the format.
  const std::filesystem::path& path() const { return partial_; }

  /// Gives the file its own name. Throws RunError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
};

}  // namespace sabo
