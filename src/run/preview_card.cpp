#include "run/preview_card.hpp"

#include <fmt/format.h>

namespace sabo {
namespace {

std::string need_text(double bytes) {
  return fmt::format("about {:.0f} MB of the graphics card", bytes / 1e6);
}

}  // namespace

void tell_card_memory(Preview& preview, double needed, const GraphicsCard& card) {
  preview.line("Memory", fmt::format("{}, of {:.0f} MB that are free on {}", need_text(needed),
                                     card.free_memory / 1e6, card.name));
  if (needed > card.free_memory)
    preview.warn(
        "the run will not fit into the memory of the graphics card; raise "
        "numerics.spacing, or use --backend cpu");
}

void tell_missing_card(Preview& preview, double needed, const std::string& fault) {
  preview.line("Memory", need_text(needed));
  preview.warn(fmt::format("numerics.backend: {}; use --backend cpu", fault));
}

}  // namespace sabo
