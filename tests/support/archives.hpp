#pragma once

#include <algorithm>
#include <string>

#include "base/archive.hpp"

namespace sabo::test {

/// Its state in bytes.
template <class T>
std::string archived(T& value) {
  std::string bytes;
  ArchiveWriter a([&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  a(value);
  return bytes;
}

template <class T>
void restore(T& value, const std::string& bytes) {
  std::size_t place = 0;
  ArchiveReader a([&](void* to, std::size_t size) {
    const std::size_t count = std::min(size, bytes.size() - place);
    bytes.copy(static_cast<char*>(to), count, place);
    place += count;
    return count;
  });
  a(value);
  a.end();
}

}  // namespace sabo::test
