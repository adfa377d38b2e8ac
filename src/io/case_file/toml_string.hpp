#pragma once

#include <string>

namespace sabo {

/// Text as a basic string of TOML: in quotes, with quotes, backslashes and control characters
/// escaped.
std::string toml_string(const std::string& text);

}  // namespace sabo
