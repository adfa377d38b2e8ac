#pragma once

#include <string>
#include <vector>

#include "verify/record.hpp"

namespace sabo {

/// The records as a page in Markdown, for the documentation: their machines; for each case its
/// claims with both methods side by side, its pictures, which lie beside the page, and remarks.
std::string validation_markdown(const std::vector<VerifyRecord>& records);

}  // namespace sabo
