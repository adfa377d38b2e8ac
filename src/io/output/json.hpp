#pragma once

#include <string>
#include <string_view>

namespace sabo {

/// A text as a string of JSON and of JavaScript, in quotes, that is safe inside a page as well: no
/// "</script>" or "<!--" can come of it. Control characters become spaces; bytes that are not UTF-8
/// become U+FFFD.
std::string json_string(std::string_view text);

/// Six digits; JSON has neither NaN nor infinity, which become null.
std::string json_number(double value);

}  // namespace sabo
