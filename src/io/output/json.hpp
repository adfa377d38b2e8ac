#pragma once

#include <string>

namespace sabo {

/// A text as a string of JSON, in quotes; control characters become spaces.
std::string json_string(const std::string& text);

/// Six digits; JSON has neither NaN nor infinity, which become null.
std::string json_number(double value);

}  // namespace sabo
