#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace sabo {

/// Bytes in base64 (RFC 4648), padded, on one line. Throws RunError above 1 GiB.
std::string base64_of(std::span<const std::byte> bytes);

}  // namespace sabo
