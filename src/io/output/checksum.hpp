#pragma once

#include <filesystem>
#include <string>

namespace sabo {

/// CRC-32 of a file (as of gzip and zip), 8 hexadecimal digits: tells whether an input has changed
/// since a run. Throws RunError when the file cannot be read.
std::string checksum(const std::filesystem::path& file);

}  // namespace sabo
