#include "run/study_plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/load_case.hpp"
#include "run/scene.hpp"

namespace sabo {
namespace {

constexpr int most_members = 1000;

void check(const StudyRequest& request) {
  Faults faults;
  if (request.spacings.size() < 2) {
    faults.add("--spacings", "has fewer than two",
               "give two or more, better three, e.g. --spacings 2,1.4,1");
  }
  std::vector<double> sorted = request.spacings;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    faults.add("--spacings", fmt::format("has {:g} m twice", *twice), "give each once");
  for (const double spacing : request.spacings) {
    if (std::isfinite(spacing) && spacing > 0) continue;
    faults.add("--spacings", fmt::format("{:g} m is no spacing", spacing), "give lengths above 0");
  }
  if (request.members < 1 || request.members > most_members) {
    faults.add("--members", fmt::format("{} is out of range", request.members),
               fmt::format("give a whole number from 1 to {}", most_members));
  }
  faults.throw_if_any();
}

Case case_at(const StudyRequest& request, double spacing, Faults& faults) {
  std::vector<Override> overrides = request.overrides;
  overrides.push_back({"numerics", "spacing", spacing});
  return load_case(request.case_path, faults, overrides);
}

/// Reads what the case names at one spacing: the release may be too thin for it, or too large.
void check_scene(const Case& c) {
  Faults faults, told;
  make_scene(c, faults);
  for (const Fault& fault : faults.list())
    told.add(fault.place, fmt::format("at {:g} m {}", c.numerics.spacing, fault.problem),
             fault.remedy);
  told.throw_if_any();
}

void add_runs(const StudyRequest& request, double spacing, const Case& c,
              std::vector<StudyRun>& runs) {
  if (request.members == 1) {
    runs.push_back({spacing, 0, fmt::format("spacing-{}", spacing), c});
    return;
  }
  for (int member = 1; member <= request.members; ++member) {
    StudyRun run{spacing, member, fmt::format("spacing-{}-member-{}", spacing, member), c};
    if (run.c.release.jitter == 0) run.c.release.jitter = member_jitter;
    run.c.release.seed = member;
    runs.push_back(std::move(run));
  }
}

}  // namespace

std::vector<StudyRun> study_plan(const StudyRequest& request) {
  check(request);
  std::vector<double> spacings = request.spacings;
  std::ranges::sort(spacings, std::ranges::greater());
  std::vector<StudyRun> runs;
  for (const double spacing : spacings) {
    Faults faults;
    const Case c = case_at(request, spacing, faults);
    faults.throw_if_any();  // the same at every spacing but for the range of the key
    if (request.members > 1 && !c.release.given())
      throw CaseError("--members",
                      "would all be the same: only particles of a release are jittered",
                      "leave it out");
    check_scene(c);
    add_runs(request, spacing, c, runs);
  }
  return runs;
}

}  // namespace sabo
