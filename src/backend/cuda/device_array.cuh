#pragma once

#include <cstddef>
#include <utility>

#include "backend/cuda/check_cuda.hpp"

namespace sabo {

/// The memory of the card; arrays there are as large as they need to be.
struct CardMemory {
  static void* allocate(std::size_t bytes) { return allocate_on_card(bytes); }
  static void free(void* memory) noexcept { free_on_card(memory); }
  static std::size_t room_for(std::size_t count) { return count; }
};

/// Memory of the host to which the card copies by itself. To get some takes long: arrays that grow
/// have room for more.
struct PageLockedMemory {
  static void* allocate(std::size_t bytes) { return allocate_page_locked(bytes); }
  static void free(void* memory) noexcept { free_page_locked(memory); }
  static std::size_t room_for(std::size_t count) { return count + count / 8; }
};

template <class T, class Memory>
class CudaArray {
 public:
  CudaArray() = default;
  CudaArray(CudaArray&& other) noexcept { swap(other); }
  CudaArray& operator=(CudaArray&& other) noexcept {
    swap(other);
    return *this;
  }
  CudaArray(const CudaArray&) = delete;
  CudaArray& operator=(const CudaArray&) = delete;
  ~CudaArray() { Memory::free(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }

  /// Room for `count` values, which are lost if there was not enough or far too much.
  void resize(std::size_t count) {
    if (count > capacity_ || count < capacity_ / 2) {
      Memory::free(data_);
      data_ = nullptr;
      size_ = capacity_ = 0;
      const std::size_t room = Memory::room_for(count);
      if (room > 0) data_ = static_cast<T*>(Memory::allocate(room * sizeof(T)));
      capacity_ = room;
    }
    size_ = count;
  }

 private:
  void swap(CudaArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

template <class T>
using DeviceArray = CudaArray<T, CardMemory>;
template <class T>
using PageLockedArray = CudaArray<T, PageLockedMemory>;

}  // namespace sabo
