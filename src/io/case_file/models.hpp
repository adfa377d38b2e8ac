#pragma once

#include <string>

namespace sabo {

/// Every rheology with its keys, defaults, ranges and units, for `sabo models`.
std::string models_text();

}  // namespace sabo
