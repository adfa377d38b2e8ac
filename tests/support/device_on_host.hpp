#pragma once

#include "support/late_executor.hpp"

#include "backend/device/device_backend.hpp"

namespace sabo {

namespace test {
/// The code of graphics cards where there is none, slowly.
using DeviceOnHost = DeviceBackend<LateExecutor>;
}  // namespace test

extern template class DeviceBackend<test::LateExecutor>;

}  // namespace sabo
