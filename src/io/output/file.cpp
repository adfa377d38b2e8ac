#include "io/output/file.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/gis/partial_file.hpp"

namespace sabo {

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  const auto fail = [&file](int reason) {
    throw RunError(
        fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(reason)));
  };
  PartialFile partial(file);
  std::FILE* out = std::fopen(partial.path().c_str(), "wb");
  if (!out) fail(errno);
  errno = 0;
  const bool is_written = std::fwrite(content.data(), 1, content.size(), out) == content.size();
  const int reason = errno;
  if (std::fclose(out) != 0) fail(errno);
  if (!is_written) fail(reason);
  partial.commit();
}

}  // namespace sabo
