#pragma once

#include <cstddef>

#include <cuda_runtime_api.h>

namespace sabo {

/// Throws RunError with the words of CUDA if a call has failed.
void check_cuda(cudaError_t outcome, const char* call);

/// Memory of the card. Throws RunError where it does not suffice.
void* allocate_on_card(std::size_t bytes);
void free_on_card(void* memory) noexcept;

/// Memory of the host that stays in its place, so that the card copies to it by itself; where the
/// system does not grant that, memory as any other, to which copies are waited for.
void* allocate_page_locked(std::size_t bytes);
/// After the copies that are on their way there.
void free_page_locked(void* memory) noexcept;

}  // namespace sabo
