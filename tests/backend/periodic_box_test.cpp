#include <map>
#include <memory>

#include "support/backends.hpp"
#include "support/scenes.hpp"
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.hpp"
#include "backend/reference/reference_backend.hpp"

namespace sabo {
namespace {

template <class Base>
struct OpenedFilling : Base {
  using Base::Base;
  using Base::filling_;
};

/// Particles of a lattice periodic in every direction are all alike, wherever the box is cut.
template <class B>
void expect_no_borders(int dimension) {
  FlowModel model = test::plain_model(0.1, 20, 0);
  model.dimension = dimension;
  model.periodic.period = {Vec3d{1, 0, 0}, dimension == 3 ? Vec3d{0, 1, 0} : Vec3d{},
                           Vec3d{0, 0, 1}};
  B backend(model);
  test::add_block(backend.fluid(), model, {0, 10, 0, 10, 0, 10});
  for (Vec3d& x : backend.fluid().position) x += Vec3d{0.62, 0, 0.94};  // beyond the box: wrapped
  backend.find_neighbours();
  backend.pressure();
  backend.wall_pressure();
  backend.near_forces();
  for (std::size_t i = 0; i < backend.fluid().size(); ++i) {
    EXPECT_LT(backend.fluid().position[i].z, 1);
    EXPECT_GE(backend.fluid().position[i].z, 0);
    EXPECT_NEAR(backend.filling_[i].share, backend.filling_[0].share, 1e-5);
    EXPECT_NEAR(backend.filling_[i].share, 1, 0.01);
    EXPECT_LT(norm(backend.filling_[i].gradient), 1e-4);
  }
}

TEST(PeriodicBox, HasNoBordersInAnyDirection) {
  for (const int dimension : {2, 3}) {
    expect_no_borders<OpenedFilling<ReferenceBackend>>(dimension);
    expect_no_borders<OpenedFilling<CpuBackend>>(dimension);
    expect_no_borders<OpenedFilling<test::DeviceOnHost>>(dimension);
  }
}

}  // namespace
}  // namespace sabo
