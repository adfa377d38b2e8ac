#pragma once

#include <string>

#include "backend/cuda/graphics_card.hpp"
#include "run/preview_lines.hpp"

namespace sabo {

/// Of a run that needs so much memory (bytes) of a graphics card: that of this card, or the one
/// that `fault` says why it cannot be used.
void tell_card_memory(Preview& preview, double needed, const GraphicsCard& card);
void tell_missing_card(Preview& preview, double needed, const std::string& fault);

}  // namespace sabo
