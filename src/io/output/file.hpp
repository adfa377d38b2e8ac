#pragma once

#include <filesystem>
#include <string_view>

namespace sabo {

/// Writes a file under a temporary name and renames it, so that readers see the old or the new
/// file, never a part, after a power failure either. Throws RunError with the reason (disk full,
/// read-only, no such folder).
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// With all that it lies in; it may be there already. Throws RunError with the reason.
void make_folder(const std::filesystem::path& folder);

/// Removes what lies in a folder, if there is one, and has a name that begins so.
void remove_named(const std::filesystem::path& folder, std::string_view start);

}  // namespace sabo
