#include "io/output/file.hpp"

#include <system_error>

#include "base/error.hpp"
#include "io/output/atomic_file.hpp"

namespace sabo {

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  AtomicFile out(file);
  out.write(content.data(), content.size());
  out.commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError("cannot make " + folder.string() + ": " + error.message());
}

void remove_named(const std::filesystem::path& folder, std::string_view start) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().filename().string().starts_with(start))
      std::filesystem::remove(entry.path(), error);
}

}  // namespace sabo
