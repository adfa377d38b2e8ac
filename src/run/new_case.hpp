#pragma once

#include <filesystem>
#include <string>

namespace sabo {

/// Writes a template of io/case_file/templates.hpp to a folder that is empty or does not exist,
/// with the generated input files where the template has them. Throws CaseError for an unknown
/// template (with the nearest name) or a folder that has files in it.
void new_case(const std::string& template_name, const std::filesystem::path& folder);

}  // namespace sabo
