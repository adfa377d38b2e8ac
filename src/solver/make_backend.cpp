#include "solver/make_backend.hpp"

#include "backend/cpu/cpu_backend.hpp"
#include "backend/reference/reference_backend.hpp"

namespace sabo {

std::unique_ptr<Backend> make_backend(BackendKind kind, const FlowModel& model) {
  if (kind == BackendKind::reference) return std::make_unique<ReferenceBackend>(model);
  return std::make_unique<CpuBackend>(model);
}

}  // namespace sabo
