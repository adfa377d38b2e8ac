#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "base/archive.hpp"

namespace sabo {

// A file of state: "sabo checkpoint\n", the version of its layout, a frame of Zstandard (RFC 8878)
// with an archive, and the CRC-32 of all before it. Numbers in the order of the machine.

/// Writes it under a temporary name, on the disk before it gets its own: a file of that name is
/// whole, whatever happens. Throws RunError.
void write_state_file(const std::filesystem::path& file, std::uint32_t version,
                      const std::function<void(ArchiveWriter&)>& content);

/// A file of state in memory.
class StateFile {
 public:
  /// From its bytes. Throws RunError with a reason that completes "the file ...", when it is not
  /// one, is damaged or has another version.
  StateFile(std::string bytes, std::uint32_t version);

  /// Reads it whole. Throws RunError, as an archive does, when it holds anything else.
  void read(const std::function<void(ArchiveReader&)>& content) const { read(content, true); }

  /// Reads its beginning.
  void read_head(const std::function<void(ArchiveReader&)>& content) const { read(content, false); }

 private:
  void read(const std::function<void(ArchiveReader&)>& content, bool to_the_end) const;

  std::string bytes_;
};

/// Reads a file of state. Throws RunError.
StateFile read_state_file(const std::filesystem::path& file, std::uint32_t version);

}  // namespace sabo
