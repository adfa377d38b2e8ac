#include "io/gis/partial_file.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"

namespace sabo {

PartialFile::PartialFile(std::filesystem::path target)
    : target_(std::move(target)), partial_(target_) {
  partial_.replace_filename(target_.stem().string() + ".part" + target_.extension().string());
}

PartialFile::~PartialFile() {
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void PartialFile::commit() {
  std::error_code error;
  std::filesystem::rename(partial_, target_, error);
  if (error) {
    throw RunError(fmt::format("cannot write {}: {}", target_.string(), error.message()));
  }
}

}  // namespace sabo
