#include "backend/device/on_host.hpp"

#include "backend/device/device_implicit.hpp"

namespace sabo {

template class DeviceBackend<HostExecutor>;

}  // namespace sabo
