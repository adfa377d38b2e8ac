#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace sabo {

/// The content of a file; nothing if it cannot be read, is empty or has more than `max_bytes`.
std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace sabo
