#include "io/output/file.hpp"

#include "io/output/atomic_file.hpp"

namespace sabo {

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  AtomicFile out(file);
  out.write(content.data(), content.size());
  out.commit();
}

}  // namespace sabo
