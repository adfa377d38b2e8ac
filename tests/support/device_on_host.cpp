#include "support/device_on_host.hpp"

#include "backend/device/device_implicit.hpp"

namespace sabo {

template class DeviceBackend<test::LateExecutor>;

}  // namespace sabo
