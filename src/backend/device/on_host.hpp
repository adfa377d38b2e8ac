#pragma once

#include "backend/device/device_backend.hpp"
#include "backend/host_executor.hpp"

namespace sabo {

/// The code of graphics cards on the host, serial and slow: the tests run it where there is no
/// card.
using DeviceBackendOnHost = DeviceBackend<HostExecutor>;
extern template class DeviceBackend<HostExecutor>;

}  // namespace sabo
