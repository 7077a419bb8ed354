// SPDX-License-Identifier: Apache-2.0
//
// wellstrat.glsl as OpenCL C 1.2 or later. What looks words up takes the tables first:
//
//     float2 xi = wellstratLongSample2D(tables, context, order);
//
// `tables` is a `__global const uint*` to the words of DeviceTables (device_tables.h), contexts and
// orders are uint2. A program may have it in one of its sources.

#ifndef WELLSTRAT_CL
#define WELLSTRAT_CL

#define WELLSTRAT_LANGUAGE
#define WELLSTRAT_PARAMETER __global const uint *wellstratTables,
#define WELLSTRAT_ARGUMENT wellstratTables,
#define WELLSTRAT_WORD(i) wellstratTables[i]
#define WELLSTRAT_LOWEST_BIT(x) (31u - clz((x) & (0u - (x))))
#define WELLSTRAT_UPPER_PRODUCT(a, b) mul_hi(a, b)

typedef uint2 uvec2;
typedef uint3 uvec3;
typedef float2 vec2;
typedef float3 vec3;

// GLSL's constructors. A name that no parenthesis follows stays a type.
#define uint(x) ((uint)(x))
#define float(x) ((float)(x))
#define uvec2(x, y) ((uint2)((x), (y)))
#define uvec3(x, y, z) ((uint3)((x), (y), (z)))
#define vec2(x, y) ((float2)((x), (y)))
#define vec3(x, y, z) ((float3)((x), (y), (z)))

#include "wellstrat.glsl"

#undef uint
#undef float
#undef uvec3
#undef vec2
#undef vec3
// uvec2 stays for WELLSTRAT_ROOT.

#endif
