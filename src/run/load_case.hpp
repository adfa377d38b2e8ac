#pragma once

#include <string>

#include "io/case_file/read_case.hpp"

namespace sabo {

/// The case that a user names: a case file, a folder with a case.toml, or the input folder of other
/// software (AvaFrame). Faults and overrides are those of read_case().
Case load_case(const std::filesystem::path& path, Faults& faults,
               const std::vector<Override>& overrides = {});

/// Name for what is made of a case: that of the folder that holds it or that the user named, also
/// when it was written as "." or with a slash at its end.
std::string name_of_case(const std::filesystem::path& path);

}  // namespace sabo
