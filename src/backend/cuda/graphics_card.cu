#include <cstdint>
#include <string>

#include "backend/cuda/check_cuda.hpp"
#include "backend/cuda/graphics_card.hpp"
#include "base/error.hpp"

namespace sabo {
namespace {

constexpr int least_capability = 8;  // of the code that is compiled, src/CMakeLists.txt

std::string version_text(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

/// Memory that is freed stays with the program: most of it is wanted again at once.
void keep_freed_memory() {
  cudaMemPool_t pool;
  check_cuda(cudaDeviceGetDefaultMemPool(&pool, 0), "cudaDeviceGetDefaultMemPool");
  std::uint64_t all = UINT64_MAX;
  check_cuda(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all),
             "cudaMemPoolSetAttribute");
}

/// Gives back what is kept; whether there was anything to do it with.
bool give_back_freed_memory() {
  cudaMemPool_t pool;
  cudaGetLastError();
  return cudaStreamSynchronize(nullptr) == cudaSuccess &&
         cudaDeviceGetDefaultMemPool(&pool, 0) == cudaSuccess &&
         cudaMemPoolTrimTo(pool, 0) == cudaSuccess;
}

}  // namespace

void check_cuda(cudaError_t outcome, const char* call) {
  if (outcome == cudaSuccess) return;
  throw RunError(std::string("the graphics card failed in ") + call + ": " +
                 cudaGetErrorString(outcome) + "; --backend cpu runs the same case");
}

void* allocate_on_card(std::size_t bytes) {
  static const bool is_set_up = (keep_freed_memory(), true);
  (void)is_set_up;
  void* memory = nullptr;
  cudaError_t outcome = cudaMallocAsync(&memory, bytes, nullptr);
  if (outcome == cudaErrorMemoryAllocation && give_back_freed_memory())
    outcome = cudaMallocAsync(&memory, bytes, nullptr);
  if (outcome == cudaErrorMemoryAllocation) {
    cudaGetLastError();
    std::size_t free = 0, all = 0;
    check_cuda(cudaMemGetInfo(&free, &all), "cudaMemGetInfo");
    const auto megabytes = [](std::size_t b) { return std::to_string(b / 1000000) + " MB"; };
    throw RunError("the graphics card is out of memory: " + megabytes(bytes) +
                   " more are wanted, " + megabytes(free) + " of " + megabytes(all) +
                   " are free; raise numerics.spacing, or use --backend cpu");
  }
  check_cuda(outcome, "cudaMalloc");
  return memory;
}

void free_on_card(void* memory) noexcept {
  if (memory) cudaFreeAsync(memory, nullptr);
}

std::string graphics_card_fault() {
  int driver = 0, runtime = 0, count = 0;
  cudaRuntimeGetVersion(&runtime);
  cudaDriverGetVersion(&driver);
  if (driver == 0) return "no CUDA device was found: there is no NVIDIA driver on this machine";
  const cudaError_t outcome = cudaGetDeviceCount(&count);
  cudaGetLastError();
  if (outcome == cudaErrorInsufficientDriver)
    return "the NVIDIA driver is too old: it knows CUDA up to " + version_text(driver) +
           ", the program needs " + version_text(runtime);
  if (outcome != cudaSuccess || count == 0)
    return std::string("no CUDA device was found") +
           (outcome == cudaSuccess ? "" : std::string(": ") + cudaGetErrorString(outcome));
  cudaDeviceProp device;
  if (cudaGetDeviceProperties(&device, 0) != cudaSuccess)
    return "the graphics card does not answer";
  if (device.major < least_capability)
    return std::string(device.name) + " is too old: it has compute capability " +
           std::to_string(device.major) + "." + std::to_string(device.minor) +
           ", the program needs " + std::to_string(least_capability) + ".0";
  return "";
}

GraphicsCard graphics_card() {
  if (const std::string fault = graphics_card_fault(); !fault.empty()) throw RunError(fault);
  cudaDeviceProp device;
  check_cuda(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
  std::size_t free = 0, all = 0;
  check_cuda(cudaMemGetInfo(&free, &all), "cudaMemGetInfo");
  return {device.name, static_cast<double>(all), static_cast<double>(free)};
}

}  // namespace sabo
