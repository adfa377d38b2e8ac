#pragma once

#include <cstddef>
#include <utility>

#include "backend/cuda/check_cuda.hpp"

namespace sabo {

/// Values in the memory of the card.
template <class T>
class DeviceArray {
 public:
  DeviceArray() = default;
  DeviceArray(DeviceArray&& other) noexcept { swap(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    swap(other);
    return *this;
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() { free_on_card(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }

  /// Room for `count` values, which are lost if there was not enough or far too much.
  void resize(std::size_t count) {
    if (count > capacity_ || count < capacity_ / 2) {
      free_on_card(data_);
      data_ = nullptr;
      size_ = capacity_ = 0;
      if (count > 0) data_ = static_cast<T*>(allocate_on_card(count * sizeof(T)));
      capacity_ = count;
    }
    size_ = count;
  }

 private:
  void swap(DeviceArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace sabo
