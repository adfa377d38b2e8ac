#include "io/mesh/read_mesh.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {
namespace {

constexpr std::uintmax_t max_bytes = 4'000'000'000;

std::string bytes_of(const std::filesystem::path& file, const std::string& key) {
  std::error_code error;
  const std::string name = file.string();
  const std::uintmax_t size =
      std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream || size == 0)
    throw CaseError(key, name + " cannot be read, or is empty", "check the name of the file");
  if (size > max_bytes) {
    throw CaseError(key, fmt::format("{} has {:.1f} GB", name, static_cast<double>(size) / 1e9),
                    fmt::format("give at most {} GB", max_bytes / 1'000'000'000));
  }
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file, const std::string& key) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_obj = extension == ".obj";
  if (!is_obj && extension != ".stl") {
    throw CaseError(key, file.string() + " is neither an STL nor an OBJ by its name",
                    "give a file whose name ends in .stl or .obj");
  }
  const std::string bytes = bytes_of(file, key);
  return is_obj ? parse_obj(bytes, file.string(), key) : parse_stl(bytes, file.string(), key);
}

}  // namespace sabo
