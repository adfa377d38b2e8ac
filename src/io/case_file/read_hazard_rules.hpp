#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/faults.hpp"
#include "case/hazard_rules.hpp"

namespace sabo {

/// Reads the rules of a TOML text. Adds every fault it finds, by key and line; the rules are of use
/// only when there is none.
HazardRules read_hazard_rules(std::string_view text, const std::string& file_name, Faults& faults);

/// Names of the rules that come with the program: swiss, austria, japan.
std::vector<std::string> known_hazard_rules();

/// Their text, which users copy and change; "" for a name that is none of them.
std::string_view hazard_rules_text(std::string_view name);

}  // namespace sabo
