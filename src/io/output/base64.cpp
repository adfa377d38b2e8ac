#include "io/output/base64.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>

#include "base/error.hpp"

namespace sabo {

std::string base64_of(std::span<const std::byte> bytes) {
  constexpr std::size_t most = std::size_t{1} << 30;  // GDAL counts in int
  if (bytes.size() > most) throw RunError("more than 1 GiB for one file of text");
  char* text =
      CPLBase64Encode(static_cast<int>(bytes.size()), reinterpret_cast<const GByte*>(bytes.data()));
  std::string result = text;
  CPLFree(text);
  return result;
}

}  // namespace sabo
