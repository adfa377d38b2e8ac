#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verify/verification.hpp"

namespace sabo {

/// A case that was run.
struct VerifyRecord {
  std::string name = {};
  Method method = Method::fast;
  Effort effort = Effort::full;
  Verdict verdict = {};                    ///< its charts are kept as pictures
  std::string failure = {};                ///< why there is no verdict; "" when there is one
  double seconds = 0;                      ///< that it took
  std::string date = {};                   ///< UTC, ISO 8601
  std::string version = {};                ///< of the program that ran it
  std::string machine = {};                ///< its processor, and how many threads ran it
  bool is_current = false;                 ///< ran by this very program
  std::vector<std::string> pictures = {};  ///< files of the folder

  bool holds() const { return failure.empty() && verdict.holds(); }
};

/// Runs a case with the given settings. A failure of the run ends up in the record.
VerifyRecord run_verification(const Verification& verification, const VerifySettings& settings);

/// Writes the record and its pictures to the folder, which is made, over those of an earlier run.
/// Throws RunError when it cannot.
void write_record(VerifyRecord& record, const std::filesystem::path& folder);

/// The record of a case in the folder; nothing where there is none that can be read.
std::optional<VerifyRecord> read_record(const std::filesystem::path& folder, std::string_view name,
                                        Method method, Effort effort);

/// All records of the folder, of this program and of others, in the order of the cases.
std::vector<VerifyRecord> read_records(const std::filesystem::path& folder, Effort effort);

}  // namespace sabo
