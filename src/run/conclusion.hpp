#pragma once

#include <functional>

#include "case/case.hpp"
#include "run/flow.hpp"
#include "run/recorder.hpp"
#include "run/run_facts.hpp"
#include "run/run_folder.hpp"
#include "run/run_maps.hpp"
#include "run/scene.hpp"
#include "run/simulation.hpp"

namespace sabo {

/// Ends a run: writes maps, pictures, page and manifest of whatever it has reached.
class Conclusion {
 public:
  /// All of these must outlive it. The facts are those that the steps leave: how they ended, their
  /// time and their passes; what the outputs tell of them comes on top.
  Conclusion(const Case& c, const Scene& scene, const RunFolder& folder, Flow& flow,
             Recorder& recorder, RunFacts& facts)
      : case_(c), scene_(scene), folder_(folder), flow_(flow), recorder_(recorder), facts_(facts) {}

  /// A part that cannot be written makes the run one that has failed, in the facts too; the others
  /// are written.
  RunResult write();

 private:
  void attempt(const std::function<void()>& part);
  void fill_facts(const RunMaps& maps);

  const Case& case_;
  const Scene& scene_;
  const RunFolder& folder_;
  Flow& flow_;
  Recorder& recorder_;
  RunFacts& facts_;
};

}  // namespace sabo
