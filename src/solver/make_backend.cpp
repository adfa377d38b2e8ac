#include "solver/make_backend.hpp"

#include "backend/cpu/cpu_backend.hpp"
#include "backend/cuda/graphics_card.hpp"
#include "backend/reference/reference_backend.hpp"
#include "base/error.hpp"

namespace sabo {

std::string missing_backend(BackendKind kind) {
  return kind == BackendKind::cuda ? graphics_card_fault() : "";
}

void require_backend(BackendKind kind) {
  if (const std::string fault = missing_backend(kind); !fault.empty())
    throw CaseError("numerics.backend", fault, "use --backend cpu");
}

std::unique_ptr<Backend> make_backend(BackendKind kind, const FlowModel& model) {
  require_backend(kind);
  switch (kind) {
    case BackendKind::reference:
      return std::make_unique<ReferenceBackend>(model);
    case BackendKind::cuda:
      return make_graphics_card_backend(model);
    case BackendKind::cpu:
      break;
  }
  return std::make_unique<CpuBackend>(model);
}

}  // namespace sabo
