#include "backend/cuda/cuda_executor.cuh"
#include "backend/cuda/graphics_card.hpp"
#include "backend/device/device_implicit.hpp"

namespace sabo {

std::unique_ptr<Backend> make_graphics_card_backend(const FlowModel& model) {
  return std::make_unique<DeviceBackend<CudaExecutor>>(model);
}

}  // namespace sabo
