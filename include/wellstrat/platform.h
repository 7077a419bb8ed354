// SPDX-License-Identifier: Apache-2.0
//
// Marks that the other headers put on their functions.

#pragma once

/// On functions that a GPU kernel may call too.
#if defined(__CUDACC__) || defined(__HIPCC__)
#define WELLSTRAT_HOST_DEVICE __host__ __device__
#else
#define WELLSTRAT_HOST_DEVICE
#endif

/// On the compiled functions and data of the library, whose other symbols stay hidden.
#if defined(_WIN32)
#define WELLSTRAT_API
#else
#define WELLSTRAT_API __attribute__((visibility("default")))
#endif

/// On functions for rare cases, to keep their code out of their callers', and around the conditions
/// of these cases.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define WELLSTRAT_NOINLINE __attribute__((noinline))
#define WELLSTRAT_UNLIKELY(condition) __builtin_expect(condition, false)
#else
#define WELLSTRAT_NOINLINE
#define WELLSTRAT_UNLIKELY(condition) (condition)
#endif

/// Where four words can be held in one register by the vector types that g++ and clang share. A
/// 64-bit word is two of them, the lower half first.
#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIPCC__) &&                            \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define WELLSTRAT_VECTOR_TYPES 1
#else
#define WELLSTRAT_VECTOR_TYPES 0
#endif
