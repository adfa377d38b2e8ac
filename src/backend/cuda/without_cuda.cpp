#include "backend/cuda/graphics_card.hpp"
#include "base/error.hpp"

// In place of the backend where the program is built without the CUDA toolkit.

namespace sabo {

std::string graphics_card_fault() {
  return "this program was built without CUDA; it needs the CUDA toolkit 12 or later when it is "
         "built (docs/performance.md)";
}

GraphicsCard graphics_card() { throw RunError(graphics_card_fault()); }
double card_bandwidth() { throw RunError(graphics_card_fault()); }
double card_peak() { throw RunError(graphics_card_fault()); }

std::unique_ptr<Backend> make_graphics_card_backend(const FlowModel& /*model*/) {
  throw RunError(graphics_card_fault());
}

}  // namespace sabo
