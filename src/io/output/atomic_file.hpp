#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "io/gis/partial_file.hpp"

namespace sabo {

/// A file written part by part that readers see whole or not at all, after a power failure too: it
/// has its name only once all of it is on the disk. Throws RunError with the reason (disk full,
/// read-only, no such folder).
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& file);

  void write(const void* data, std::size_t size);
  /// Gives the file its name; without this nothing is left of it.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path path_;
  PartialFile partial_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The names in a folder as well: without it a file that was renamed may be gone after a power
/// failure. What the file system cannot do is left.
void sync_folder(const std::filesystem::path& folder);

}  // namespace sabo
