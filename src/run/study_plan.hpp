#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/case_file/read_case.hpp"

namespace sabo {

/// What a study of the spacing is to do.
struct StudyRequest {
  std::filesystem::path case_path;
  std::vector<double> spacings;     ///< m
  int members = 1;                  ///< jittered starts at each spacing; 1: the case as it is
  std::vector<Override> overrides;  ///< of keys other than the spacing
};

/// One run of a study.
struct StudyRun {
  double spacing = 0;  ///< m
  int member = 0;      ///< from 1; 0 when the starts are not jittered
  std::string folder;  ///< below that of the study
  Case c;
};

/// Share of the spacing by which the members' starts are jittered where the case does not say.
inline constexpr double member_jitter = 0.1;

/// The runs, from the coarsest spacing (the quickest) to the finest. Reads the case and all it
/// names at each spacing, so that a study does not stop half way: throws CaseError with what is
/// wrong with the request or with the case.
std::vector<StudyRun> study_plan(const StudyRequest& request);

}  // namespace sabo
