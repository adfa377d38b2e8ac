#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "support/device_on_host.hpp"
#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "run/flow.hpp"
#include "run/frames.hpp"
#include "run/load_case.hpp"
#include "run/new_case.hpp"
#include "run/recorder.hpp"
#include "solver/flow_model.hpp"
#include "solver/make_stepper.hpp"

// Of a flow on a device of its own maps and frames are made while it goes on.

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

  /// Records 200 steps of the release; the greatest depths.
  Raster peak_depth(std::unique_ptr<Backend> backend) {
    const FlowModel model = backend->model();
    Ground ground(*scene_.surface, scene_.dams, ground_settings(model), scene_.bodies);
    Domain domain(ground, {}, static_cast<std::uint32_t>(scene_.release.size()));
    backend->fluid() = scene_.release;
    const auto stepper = make_stepper(case_.numerics, *backend, &domain);
    const RunFolder folder(folder_ / "run", FormerRun::replaced);
    Recorder recorder(case_, scene_, model, folder);
    recorder.start(0, scene_.release, scene_.release);
    for (int k = 0; k < 200; ++k) recorder.after_step(*stepper, stepper->step(1), *backend);
    way_ = norm(backend->fluid().position.front() - scene_.release.position.front());
    recorder.finish(stepper->time(), backend->fluid());
    return recorder.maps().peak_depth();
  }

  std::string frame(const RunFolder& folder, int number) const {
    std::ostringstream text;
    text << std::ifstream(folder.frames() / ("flow_0000" + std::to_string(number) + ".vtp"),
                          std::ios::binary)
                .rdbuf();
    return text.str();
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

TEST_F(BesideSteps, MapsAreTheSame) {
  const FlowModel model = flow_model(case_.material, case_.numerics, scene_.greatest_depth());
  const Raster beside = peak_depth(std::make_unique<test::DeviceOnHost>(model));
  const Raster at_once = peak_depth(std::make_unique<SeemsOnHost>(model));
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
}

TEST_F(BesideSteps, FramesAreTheSame) {
  Particles later = scene_.release;
  for (Vec3d& x : later.position) x.x += 1;
  std::string written[2][2];
  for (const bool are_beside : {false, true}) {
    const RunFolder folder(folder_ / "run", FormerRun::replaced);
    Frames frames(scene_, folder, 2, are_beside);
    frames.write(0, scene_.release);
    frames.write(1, later);
    frames.settle();
    for (int k = 0; k < 2; ++k) written[are_beside][k] = frame(folder, k);
  }
  EXPECT_GT(written[0][0].size(), 1000u);
  EXPECT_NE(written[0][0], written[0][1]);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(written[1][k], written[0][k]);
}

TEST_F(BesideSteps, AFrameThatCannotBeWrittenIsToldOf) {
  const RunFolder folder(folder_ / "run", FormerRun::replaced);
  Frames frames(scene_, folder, 2, true);
  std::filesystem::remove_all(folder.frames());
  frames.write(0, scene_.release);
  EXPECT_THROW(frames.write(1, scene_.release), RunError);
  EXPECT_NO_THROW(frames.settle());
}

}  // namespace
}  // namespace sabo
