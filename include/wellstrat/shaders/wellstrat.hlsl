// SPDX-License-Identifier: Apache-2.0
//
// wellstrat.glsl as HLSL, shader model 5.0 or later. Contexts and orders are uint2. Before you
// include it, say where the words of DeviceTables (device_tables.h) are:
//
//     StructuredBuffer<uint> tables : register(t0);
//     #define WELLSTRAT_WORD(i) tables[i]

#ifndef WELLSTRAT_HLSL
#define WELLSTRAT_HLSL

#define WELLSTRAT_LANGUAGE
#define WELLSTRAT_PARAMETER
#define WELLSTRAT_ARGUMENT
#define WELLSTRAT_REVERSE_BITS(x) reversebits(x)
#define WELLSTRAT_LOWEST_BIT(x) uint(firstbitlow(x))

#define uvec2 uint2
#define uvec3 uint3
#define vec2 float2
#define vec3 float3

#include "wellstrat.glsl"

#undef uvec3
#undef vec2
#undef vec3
// uvec2 stays for WELLSTRAT_ROOT.

#endif
