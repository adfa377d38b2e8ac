#include "io/output/read_file.hpp"

#include <fstream>

namespace sabo {

std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t max_bytes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size == 0 || size > max_bytes) return {};
  std::ifstream stream(file, std::ios::binary);
  std::string content(size, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad() || content.empty()) return {};
  return content;
}

}  // namespace sabo
