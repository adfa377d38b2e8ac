#pragma once

#include <filesystem>

namespace sabo {

/// Keeps other processes from writing to a folder while it lives: an advisory lock (flock) on the
/// file ".lock" in it, which ends with the process however that ends. The file stays.
class FolderLock {
 public:
  static constexpr const char* file_name = ".lock";

  /// Throws CaseError when another process holds the lock, RunError when the file cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace sabo
