#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace sabo {

/// Prints to stderr "2 faults in SUBJECT:" and the faults, one a line; without a subject each as
/// print_error() does.
void print_faults(const std::string& subject, const std::vector<Fault>& faults);

/// Prints "error: MESSAGE" to stderr.
void print_error(const std::string& message);

}  // namespace sabo
