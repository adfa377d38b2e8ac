#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include "backend/cuda/cuda_executor.cuh"

namespace sabo {
namespace {

/// CUB says how many bytes of scratch it wants when it is given none.
template <class Run>
void with_scratch(const Run& run) {
  std::size_t bytes = 0;
  run(nullptr, bytes);
  DeviceArray<unsigned char> scratch;
  scratch.resize(bytes);
  run(scratch.data(), bytes);
}

}  // namespace

void CudaExecutor::sort(DeviceArray<std::uint64_t>& keys, DeviceArray<std::uint32_t>& values,
                        int bits) const {
  const std::size_t count = keys.size();
  if (count == 0) return;
  DeviceArray<std::uint64_t> sorted_keys;
  DeviceArray<std::uint32_t> sorted_values;
  sorted_keys.resize(count);
  sorted_values.resize(count);
  with_scratch([&](void* scratch, std::size_t& bytes) {
    check_cuda(cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), sorted_keys.data(),
                                               values.data(), sorted_values.data(), count, 0, bits),
               "sort");
  });
  keys = std::move(sorted_keys);
  values = std::move(sorted_values);
}

void CudaExecutor::scan(DeviceArray<std::uint64_t>& values) const {
  const std::size_t count = values.size();
  if (count == 0) return;
  DeviceArray<std::uint64_t> sums;
  sums.resize(count);
  with_scratch([&](void* scratch, std::size_t& bytes) {
    check_cuda(cub::DeviceScan::ExclusiveSum(scratch, bytes, values.data(), sums.data(), count),
               "scan");
  });
  values = std::move(sums);
}

}  // namespace sabo
