#pragma once

#include <filesystem>
#include <string_view>

namespace sabo {

/// Writes a file under a temporary name and renames it, so that readers see the old or the new
/// file, never a part, after a power failure either. Throws RunError with the reason (disk full,
/// read-only, no such folder).
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

}  // namespace sabo
