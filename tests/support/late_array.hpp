#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "support/late_stream.hpp"

namespace sabo::test {

/// Not a number, no index, and true.
inline constexpr int no_number = 0xff;

/// What memory holds before it is written to, in each byte.
inline void spoil(void* memory, std::size_t bytes, int with = no_number) {
  if (bytes > 0) std::memset(memory, with, bytes);
}

inline constexpr std::align_val_t line{64};  // as the widest records want it

/// Memory as that of a card: it goes once the work that was asked for before is done.
struct LateMemory {
  static void free(void* memory, std::size_t bytes) {
    late_stream().add([=] {
      spoil(memory, bytes);
      ::operator delete(memory, line);
    });
  }
};

/// Memory of the host to which the card copies: it goes at once, so that work is waited for.
struct StagingMemory {
  static void free(void* memory, std::size_t /*bytes*/) {
    late_stream().wait_for_all();
    ::operator delete(memory, line);
  }
};

/// As backend/cuda/device_array.cuh, but what it holds is lost with each change of its size, and
/// nothing lies behind its end.
template <class T, class Memory>
class LateArray {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  LateArray() = default;
  LateArray(LateArray&& other) noexcept { swap(other); }
  LateArray& operator=(LateArray&& other) noexcept {
    swap(other);
    return *this;
  }
  LateArray(const LateArray&) = delete;
  LateArray& operator=(const LateArray&) = delete;
  ~LateArray() { clear(); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  /// For tests: what is there once all work is done.
  const T& operator[](std::size_t k) const {
    late_stream().wait_for_all();
    return data_[k];
  }

  void resize(std::size_t count) {
    if (count == size_) return;
    clear();
    if (count == 0) return;
    data_ = static_cast<T*>(::operator new(count * sizeof(T), line));
    size_ = count;
    spoil(data_, count * sizeof(T));
  }

 private:
  void clear() {
    if (data_) Memory::free(data_, size_ * sizeof(T));
    data_ = nullptr;
    size_ = 0;
  }
  void swap(LateArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace sabo::test
