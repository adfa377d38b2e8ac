#include "io/output/folder_lock.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.hpp"

namespace sabo {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / file_name;
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw RunError("cannot write " + path.string() + ": " + std::generic_category().message(errno));
  // File systems without locks refuse for another reason; there the lock is left to the user.
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(file_);
    throw CaseError(folder.string(), "another run is writing to it",
                    "wait for it, or choose another folder with -o");
  }
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace sabo
