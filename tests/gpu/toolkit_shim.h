// SPDX-License-Identifier: Apache-2.0
//
// What clang needs to compile kernels for NVIDIA and AMD without the headers of CUDA or HIP: their
// words, the place of a thread, and <cmath>, whose harder functions it leaves to be linked from
// their libraries. Given to the compiler by -include, and for compiling alone.

#pragma once
#pragma clang system_header // or <cmath> refuses to give way

#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))

#if defined(__CUDA__) && !defined(__HIP__)
#define __CUDACC__ 1
#define SHIM_MATH(name) __nv_##name##f
#define SHIM_BLOCK_INDEX __nvvm_read_ptx_sreg_ctaid_x()
#define SHIM_THREAD_INDEX __nvvm_read_ptx_sreg_tid_x()
#else
#define SHIM_MATH(name) __ocml_##name##_f32
#define SHIM_BLOCK_INDEX __builtin_amdgcn_workgroup_id_x()
#define SHIM_THREAD_INDEX __builtin_amdgcn_workitem_id_x()
#endif

struct BlockIndex {
    struct {
        __device__ operator unsigned() const { return SHIM_BLOCK_INDEX; }
    } x;
};
struct ThreadIndex {
    struct {
        __device__ operator unsigned() const { return SHIM_THREAD_INDEX; }
    } x;
};
extern const __device__ BlockIndex blockIdx;
extern const __device__ ThreadIndex threadIdx;

// Before <cmath>, whose functions the compiler takes for code of both sides otherwise.
#define SHIM_FUNCTION(name)                                                                        \
    extern "C" __device__ float SHIM_MATH(name)(float);                                            \
    namespace std {                                                                                \
    __device__ inline float name(float x) { return SHIM_MATH(name)(x); }                           \
    }
SHIM_FUNCTION(sin)
SHIM_FUNCTION(cos)
SHIM_FUNCTION(atan)
SHIM_FUNCTION(exp)
SHIM_FUNCTION(expm1)
SHIM_FUNCTION(log)
SHIM_FUNCTION(log1p)

extern "C" __device__ float SHIM_MATH(atan2)(float, float);
extern "C" __device__ float SHIM_MATH(pow)(float, float);
namespace std {
__device__ inline float atan2(float y, float x) { return SHIM_MATH(atan2)(y, x); }
__device__ inline float pow(float x, float y) { return SHIM_MATH(pow)(x, y); }
__device__ inline float sqrt(float x) { return __builtin_sqrtf(x); }
__device__ inline float fabs(float x) { return __builtin_fabsf(x); }
__device__ inline float fmax(float x, float y) { return __builtin_fmaxf(x, y); }
__device__ inline float copysign(float x, float y) { return __builtin_copysignf(x, y); }
} // namespace std

#include <cmath>
