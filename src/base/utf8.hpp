#pragma once

#include <cstddef>
#include <string_view>

namespace sabo {

/// Bytes of the character at `i` (< text.size()); 0 when they are not well-formed UTF-8 (Unicode
/// 15, table 3-7).
std::size_t utf8_length(std::string_view text, std::size_t i);

}  // namespace sabo
