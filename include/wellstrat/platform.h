// SPDX-License-Identifier: Apache-2.0
//
// Marks that the other headers put on their functions, and what they ask of the compiler. Every
// header includes this one before anything else.

#pragma once

// Microsoft's compilers say C++98 in __cplusplus, and the truth in _MSVC_LANG.
#if __cplusplus < 201703L && (!defined(_MSVC_LANG) || _MSVC_LANG < 201703L)
#error "wellstrat needs C++17 or newer: compile with -std=c++17 (CMake: CXX_STANDARD 17)"
#endif

/// On functions that a GPU kernel may call too.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define WELLSTRAT_HOST_DEVICE __host__ __device__
#else
#define WELLSTRAT_HOST_DEVICE
#endif

/// Where that is compiled for a GPU.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
#define WELLSTRAT_DEVICE_CODE 1
#else
#define WELLSTRAT_DEVICE_CODE 0
#endif

/// On the compiled functions and data of the library, whose other symbols stay hidden.
#if defined(_WIN32)
#define WELLSTRAT_API
#else
#define WELLSTRAT_API __attribute__((visibility("default")))
#endif

/// On functions for rare cases, to keep their code out of their callers', on those where only the
/// host gains from that, and around the conditions of these cases.
#if defined(__GNUC__)
#define WELLSTRAT_NOINLINE __attribute__((noinline))
#define WELLSTRAT_UNLIKELY(condition) __builtin_expect(condition, false)
#else
#define WELLSTRAT_NOINLINE
#define WELLSTRAT_UNLIKELY(condition) (condition)
#endif
#if WELLSTRAT_DEVICE_CODE
#define WELLSTRAT_HOST_NOINLINE
#else
#define WELLSTRAT_HOST_NOINLINE WELLSTRAT_NOINLINE
#endif

/// Where four words can be held in one register by the vector types that g++ and clang share. A
/// 64-bit word is two of them, the lower half first.
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__) &&                            \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define WELLSTRAT_VECTOR_TYPES 1
#else
#define WELLSTRAT_VECTOR_TYPES 0
#endif

/// Where such a register multiplies, too.
#if WELLSTRAT_VECTOR_TYPES && defined(__SSE2__)
#define WELLSTRAT_VECTOR_PRODUCTS 1
#else
#define WELLSTRAT_VECTOR_PRODUCTS 0
#endif
