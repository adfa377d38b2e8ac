#pragma once

#include <string>
#include <string_view>

namespace sabo {

/// A text as a string of JavaScript and of JSON, in quotes, that is safe inside a page as well: no
/// "</script>" or "<!--" can come of it. Control characters become spaces; bytes that are not UTF-8
/// become U+FFFD.
std::string script_string(std::string_view text);

}  // namespace sabo
