#pragma once

#include <string>
#include <string_view>

namespace sabo {

/// Text for XML, SVG and HTML, between tags or inside quotes: the five special characters are
/// escaped; control characters and bytes that are not UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

/// A relative path as a URL: everything but letters, digits and -._~/ is percent-encoded.
std::string url_of(std::string_view path);

}  // namespace sabo
