#pragma once

#include <cstddef>

#include "backend/model.hpp"
#include "case/numerics_case.hpp"

namespace sabo {

/// Boundary particles that a run of that many particles has at its peak; right to a factor of about
/// two. The peak comes late, when the flow has thinned out: it is taken to be one and a half
/// particles deep by then and ten times as long as wide.
double expected_boundary(const FlowModel& model, std::size_t particles);

/// Memory that so many particles take of a graphics card with the backend cuda, bytes; right to
/// about a tenth, depending on the room that there is around the flow.
double card_memory(const FlowModel& model, Method method, double fluid, double boundary);

/// The same at the peak of a run; right to a factor of about two.
double expected_card_memory(const FlowModel& model, Method method, std::size_t particles);

/// Memory of the host that a run on a graphics card takes at its peak, bytes; right to a factor of
/// about two.
double expected_memory_beside_card(const FlowModel& model, std::size_t particles,
                                   std::size_t dem_cells);

/// Memory that a run on the CPU takes at its peak, bytes; right to a factor of about two.
double expected_memory(const FlowModel& model, Method method, std::size_t particles,
                       std::size_t dem_cells);

}  // namespace sabo
