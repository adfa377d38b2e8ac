#include "base/error.hpp"

#include <utility>

namespace sabo {
namespace {

std::string join(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string text = fault.place.empty() ? fault.problem : fault.place + ": " + fault.problem;
  if (!fault.remedy.empty()) text += "; " + fault.remedy;
  return text;
}

CaseError::CaseError(std::vector<Fault> faults)
    : std::runtime_error(join(faults)), faults_(std::move(faults)) {}

CaseError::CaseError(std::string place, std::string problem, std::string remedy)
    : CaseError(std::vector<Fault>{{std::move(place), std::move(problem), std::move(remedy)}}) {}

}  // namespace sabo
