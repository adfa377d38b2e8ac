#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "particles/particles.hpp"

// Some particles of a set, by their rows, which are sorted, each once.

namespace sabo {

using ParticleRows = std::vector<std::uint32_t>;

/// Takes all but the first `count` particles out of a set.
Particles take_tail(Particles& from, std::size_t count);

/// Lets a function change a copy of some particles, which then takes their place; it takes none
/// out, and particles that it appends become the last of all.
void change_rows(Particles& all, const ParticleRows& rows,
                 const std::function<void(Particles&)>& change);

/// Takes some particles out; those that stay keep their order.
Particles take_out(Particles& all, const ParticleRows& rows);

}  // namespace sabo
