#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "verify/record.hpp"

namespace sabo {

/// "within 5 % of 2.354 m/s", "at most 1.5".
std::string gate_text(const Claim& claim);
/// "2.42 m/s".
std::string measured_text(const Claim& claim);
std::string_view outcome_text(bool holds);
/// How many claims with a gate hold, and of how many: "3 of 4". What is only told is none.
std::string claims_met_text(const Verdict& verdict);
/// The case that was run.
const Verification& verification_of(const VerifyRecord& record);

/// The processors that ran the cases.
std::set<std::string> machines(const std::vector<VerifyRecord>& records);

/// What a case found, for the terminal: a line for the case, one for each claim, its remarks.
std::string text_of(const VerifyRecord& record);

/// All cases as JSON: of each the program that ran it, its claims with value, gate and outcome.
std::string json_of(const std::vector<VerifyRecord>& records);

/// Writes index.html to the folder that holds the records and their pictures; returns its path.
std::filesystem::path write_verify_page(const std::vector<VerifyRecord>& records,
                                        const std::filesystem::path& folder);

}  // namespace sabo
