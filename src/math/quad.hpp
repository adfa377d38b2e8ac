#pragma once

#include <cstddef>

namespace sabo {

/// A vector padded to four numbers, so that it is loaded in one piece.
template <class T>
struct alignas(4 * sizeof(T)) Quad {
  T x = 0, y = 0, z = 0, unused = 0;
};

}  // namespace sabo
