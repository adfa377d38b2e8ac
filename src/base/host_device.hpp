#pragma once

// Functions marked SABO_HD run on the host and, when compiled by nvcc, on the device.
#ifdef __CUDACC__
#define SABO_HD __host__ __device__
#else
#define SABO_HD
#endif
