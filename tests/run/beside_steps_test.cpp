#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "support/archives.hpp"
#include "support/device_on_host.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/output/read_file.hpp"
#include "run/flow.hpp"
#include "run/frames.hpp"
#include "run/load_case.hpp"
#include "run/new_case.hpp"
#include "run/recorder.hpp"
#include "solver/flow_model.hpp"
#include "solver/make_stepper.hpp"

// Of a flow on a device of its own maps, rows and frames are made while it goes on.

namespace sabo {
namespace {

class BesideSteps : public testing::Test {
 protected:
  BesideSteps() {
    new_case("yohutagawa", folder_ / "case");
    Faults faults;
    case_ = load_case(folder_ / "case", faults,
                      {{"numerics", "spacing", 4.0}, {"numerics", "method", std::string("fast")}});
    scene_ = make_scene(case_, faults);
    EXPECT_TRUE(faults.empty());
  }

  FlowModel model() const {
    return flow_model(case_.material, case_.numerics, scene_.greatest_depth());
  }

  /// The release on its way, recorded.
  struct Run {
    Run(const BesideSteps& test, std::unique_ptr<Backend> on, const RunFolder& folder)
        : ground(*test.scene_.surface, test.scene_.dams, ground_settings(test.model()),
                 test.scene_.bodies),
          domain(ground, {}, static_cast<std::uint32_t>(test.scene_.release.size())),
          backend(filled(std::move(on), test.scene_.release)),
          stepper(make_stepper(test.case_.numerics, *backend, &domain)),
          recorder(test.case_, test.scene_, test.model(), folder),
          frames(test.scene_, folder, 2) {
      recorder.start(0, test.scene_.release, test.scene_.release);
    }

    static std::unique_ptr<Backend> filled(std::unique_ptr<Backend> backend,
                                           const Particles& fluid) {
      backend->fluid() = fluid;
      return backend;
    }
    void step() {
      report = stepper->step(1);
      recorder.after_step(*stepper, report, *backend);
    }
    void write_row() { recorder.write_row(*stepper, report, backend->health(), *backend); }

    Ground ground;
    Domain domain;
    std::unique_ptr<Backend> backend;
    std::unique_ptr<Stepper> stepper;
    StepReport report;
    Recorder recorder;
    Frames frames;
  };

  /// Of 200 steps, with a row and a frame each twenty, the greatest depths.
  Raster recorded(std::unique_ptr<Backend> backend, const RunFolder& folder) {
    Run run(*this, std::move(backend), folder);
    for (int k = 0; k < 200; ++k) {
      run.step();
      if (k % 20 != 0) continue;
      run.write_row();
      run.frames.write(run.stepper->time(), *run.backend);
    }
    run.recorder.settle();
    run.frames.settle();
    EXPECT_EQ(run.recorder.rows().size(), 10u);
    const Particles& fluid = run.backend->fluid();
    way_ = norm(fluid.position.front() - scene_.release.position.front());
    run.recorder.finish(run.stepper->time(), fluid);
    return run.recorder.maps().peak_depth();
  }

  /// All files of a run, by their path in its folder.
  static std::map<std::string, std::string> files_of(const RunFolder& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.root()))
      if (entry.is_regular_file())
        files[entry.path().lexically_relative(folder.root()).string()] =
            read_file(entry.path(), 100'000'000).value_or("");
    return files;
  }

  TemporaryFolder folder_;
  Case case_;
  Scene scene_;
  double way_ = 0;  // m
};

/// Seems to be of the host, so that all is done at once.
class SeemsOnHost : public test::DeviceOnHost {
 public:
  using DeviceBackend::DeviceBackend;
  std::size_t device_bytes() const override { return 0; }
};

TEST_F(BesideSteps, MapsRowsAndFramesAreTheSame) {
  const RunFolder folder(folder_ / "beside", FormerRun::replaced);
  const RunFolder at_once_folder(folder_ / "at-once", FormerRun::replaced);
  const Raster beside = recorded(std::make_unique<test::DeviceOnHost>(model()), folder);
  const Raster at_once = recorded(std::make_unique<SeemsOnHost>(model()), at_once_folder);
  EXPECT_GT(way_, 10);
  double greatest = 0;
  ASSERT_EQ(beside.values.size(), at_once.values.size());
  for (std::size_t cell = 0; cell < beside.values.size(); ++cell) {
    ASSERT_EQ(std::isnan(beside.values[cell]), std::isnan(at_once.values[cell]));
    if (std::isnan(at_once.values[cell])) continue;
    greatest = std::max(greatest, at_once.values[cell]);
    EXPECT_EQ(beside.values[cell], at_once.values[cell]);
  }
  EXPECT_GT(greatest, 3);  // m

  const auto files = files_of(folder), expected = files_of(at_once_folder);
  ASSERT_TRUE(expected.contains("frames/flow_00009.vtp"));
  EXPECT_NE(expected.at("frames/flow_00000.vtp"), expected.at("frames/flow_00009.vtp"));
  for (const char* series : {"front", "volumes", "energy", "rest", "solver"})
    EXPECT_EQ(std::ranges::count(expected.at(std::string("series/") + series + ".csv"), '\n'), 11);
  EXPECT_EQ(files, expected);
}

// By limits that are so wide that the flow, once it has moved by a spacing, rests when it has been
// slower than before for a while.
TEST_F(BesideSteps, RestIsFoundAtTheSameStep) {
  case_.run.rest_time = 0.2;
  case_.run.rest_speed = 100;
  case_.run.rest_volume = 0.9;
  case_.run.rest_energy = 0.5;
  case_.run.rest_creep = 1e6;
  const RunFolder folder(folder_ / "run", FormerRun::replaced);
  const auto steps_to_rest = [&](std::unique_ptr<Backend> backend) {
    Run run(*this, std::move(backend), folder);
    while (!run.recorder.motion().is_at_rest && run.stepper->steps() < 300) {
      run.step();
      if (run.stepper->steps() != 150) continue;
      for (Vec3d& velocity : run.backend->fluid().velocity) velocity = {};
      run.backend->find_neighbours();
    }
    return run.stepper->steps();
  };
  const std::size_t beside = steps_to_rest(std::make_unique<test::DeviceOnHost>(model()));
  EXPECT_EQ(beside, steps_to_rest(std::make_unique<SeemsOnHost>(model())));
  EXPECT_GT(beside, 150u);
  EXPECT_LT(beside, 300u);
}

TEST_F(BesideSteps, AnArchiveHasWhatIsStillOnItsWay) {
  const RunFolder folder(folder_ / "run", FormerRun::replaced);
  const auto archived = [&](std::unique_ptr<Backend> backend) {
    Run run(*this, std::move(backend), folder);
    for (int k = 0; k < 40; ++k) {
      run.step();
      if (k % 13 == 0) run.write_row();
    }
    return test::archived(run.recorder);
  };
  const std::string beside = archived(std::make_unique<test::DeviceOnHost>(model()));
  EXPECT_EQ(beside, archived(std::make_unique<SeemsOnHost>(model())));
}

TEST_F(BesideSteps, ARowThatCannotBeIsToldOfBeforeItIsWritten) {
  const RunFolder folder(folder_ / "run", FormerRun::replaced);
  Run run(*this, std::make_unique<test::DeviceOnHost>(model()), folder);
  run.step();
  run.write_row();
  for (Vec3d& velocity : run.backend->fluid().velocity) velocity.x += 30;  // from nowhere
  run.backend->find_neighbours();
  run.step();
  EXPECT_NO_THROW(run.write_row());
  EXPECT_THROW(run.recorder.settle(), RunError);
  EXPECT_NO_THROW(run.recorder.settle());
  EXPECT_EQ(run.recorder.rows().size(), 1u);
  EXPECT_EQ(std::ranges::count(files_of(folder).at("series/energy.csv"), '\n'), 2);
}

TEST_F(BesideSteps, AFrameThatCannotBeWrittenIsToldOf) {
  test::DeviceOnHost backend(model());
  backend.fluid() = scene_.release;
  backend.find_neighbours();
  const RunFolder folder(folder_ / "run", FormerRun::replaced);
  Frames frames(scene_, folder, 2);
  std::filesystem::remove_all(folder.frames());
  frames.write(0, backend);
  EXPECT_THROW(frames.write(1, backend), RunError);
  EXPECT_NO_THROW(frames.settle());
}

}  // namespace
}  // namespace sabo
