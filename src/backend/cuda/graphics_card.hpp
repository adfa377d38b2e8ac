#pragma once

#include <memory>
#include <string>

#include "backend/backend.hpp"

namespace sabo {

/// Why no graphics card can be used by this program on this machine; empty if one can.
std::string graphics_card_fault();

/// A card that can be used.
struct GraphicsCard {
  std::string name;
  double memory = 0;       ///< bytes, all of it
  double free_memory = 0;  ///< bytes
};
/// Waits for the card and gives back memory that the program kept for later, so that it counts as
/// free. Throws RunError where graphics_card_fault() has something to say.
GraphicsCard graphics_card();

/// What the card does at most, measured in a moment: copies in its memory, bytes/s read and written
/// together, and multiply-adds in single precision, flop/s.
double card_bandwidth();
double card_peak();

/// The backend on that card. Throws RunError where its memory does not suffice.
std::unique_ptr<Backend> make_graphics_card_backend(const FlowModel& model);

}  // namespace sabo
