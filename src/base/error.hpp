#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace sabo {

/// Something wrong with what the user gave us: where it stands, what is wrong, what would be right.
struct Fault {
  std::string place;    ///< e.g. "case.toml:12 numerics.spacing"; may be a file name alone
  std::string problem;  ///< one sentence without a full stop
  std::string remedy;   ///< one sentence that starts with a verb; may be empty
};

/// "place: problem; remedy" on one line.
std::string to_string(const Fault& fault);

/// The case cannot be run as it stands (exit code 2). Carries every fault that was found.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<Fault> faults);
  CaseError(std::string place, std::string problem, std::string remedy = "");

  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A run that had begun could not go on (exit code 3): disk full, density out of range, NaN.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sabo
