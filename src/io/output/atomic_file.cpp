#include "io/output/atomic_file.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"

namespace sabo {

AtomicFile::AtomicFile(const std::filesystem::path& file)
    : path_(file), partial_(file), file_(std::fopen(partial_.path().c_str(), "wb")) {
  if (!file_) fail(errno);
}

void AtomicFile::fail(int reason) const {
  throw RunError(
      fmt::format("cannot write {}: {}", path_.string(), std::generic_category().message(reason)));
}

void AtomicFile::write(const void* data, std::size_t size) {
  errno = 0;
  if (std::fwrite(data, 1, size, file_.get()) != size) fail(errno);
}

void AtomicFile::commit() {
  if (std::fflush(file_.get()) != 0 || fsync(fileno(file_.get())) != 0) fail(errno);
  if (std::fclose(file_.release()) != 0) fail(errno);
  partial_.commit();
}

void sync_folder(const std::filesystem::path& folder) {
  const int handle =
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  fsync(handle);
  ::close(handle);
}

}  // namespace sabo
