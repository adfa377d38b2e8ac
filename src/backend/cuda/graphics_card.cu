#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

#include "backend/cuda/check_cuda.hpp"
#include "backend/cuda/graphics_card.hpp"
#include "base/error.hpp"

namespace sabo {
namespace {

std::string version_text(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

/// Stands for all kernels: there is code for a card or there is none.
__global__ void probe() {}

/// Why the card cannot do what is needed; empty if it can.
std::string fault_of(const cudaDeviceProp& device) {
  int has_pools = 0;
  cudaDeviceGetAttribute(&has_pools, cudaDevAttrMemoryPoolsSupported, 0);
  if (!has_pools)
    return std::string(device.name) + " has no memory pools, as some shared virtual cards";
  cudaFuncAttributes attributes;
  const cudaError_t outcome = cudaFuncGetAttributes(&attributes, probe);
  cudaGetLastError();
  if (outcome == cudaSuccess) return "";
  return std::string(device.name) + " of compute capability " + std::to_string(device.major) + "." +
         std::to_string(device.minor) + " cannot run this program (" + cudaGetErrorString(outcome) +
         "): build it with that capability among CMAKE_CUDA_ARCHITECTURES";
}

[[noreturn]] void throw_out_of_memory(const std::string& wanted) {
  std::size_t free = 0, all = 0;
  cudaGetLastError();
  cudaMemGetInfo(&free, &all);
  const auto megabytes = [](std::size_t b) { return std::to_string(b / 1000000) + " MB"; };
  throw RunError("the graphics card is out of memory: " + wanted + ", " + megabytes(free) + " of " +
                 megabytes(all) + " are free; raise numerics.spacing, or use --backend cpu");
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
  if (outcome == cudaErrorMemoryAllocation) throw_out_of_memory(std::string("wanted by ") + call);
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
  if (outcome == cudaErrorMemoryAllocation)
    throw_out_of_memory(std::to_string(bytes / 1000000) + " MB more are wanted");
  check_cuda(outcome, "cudaMalloc");
  return memory;
}

void free_on_card(void* memory) noexcept {
  if (memory) cudaFreeAsync(memory, nullptr);
}

void* allocate_page_locked(std::size_t bytes) {
  constexpr std::size_t page = 4096;  // whole ones: what shares a page cannot be locked apart
  const std::size_t size = (bytes / page + 1) * page;
  void* memory = std::aligned_alloc(page, size);
  if (!memory) throw std::bad_alloc();
  if (cudaHostRegister(memory, size, cudaHostRegisterDefault) != cudaSuccess) cudaGetLastError();
  return memory;
}

void free_page_locked(void* memory) noexcept {
  if (!memory) return;
  cudaStreamSynchronize(nullptr);
  if (cudaHostUnregister(memory) != cudaSuccess) cudaGetLastError();
  std::free(memory);
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
  static const std::string fault = fault_of(device);  // takes a moment
  return fault;
}

GraphicsCard graphics_card() {
  if (const std::string fault = graphics_card_fault(); !fault.empty()) throw RunError(fault);
  cudaDeviceProp device;
  check_cuda(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
  give_back_freed_memory();
  std::size_t free = 0, all = 0;
  check_cuda(cudaMemGetInfo(&free, &all), "cudaMemGetInfo");
  return {device.name, static_cast<double>(all), static_cast<double>(free)};
}

}  // namespace sabo
