#pragma once

#include <string>

namespace sabo {

/// Name of this machine's processor as the operating system gives it; "unknown" if it does not.
std::string cpu_name();

}  // namespace sabo
