#pragma once

#include <string_view>

namespace sabo {

// Rules that are part of the program: the files hazard_rules/*.toml of this folder.

std::string_view hazard_rules_swiss();
std::string_view hazard_rules_austria();
std::string_view hazard_rules_japan();

}  // namespace sabo
