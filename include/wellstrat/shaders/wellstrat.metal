// SPDX-License-Identifier: Apache-2.0
//
// wellstrat.glsl as Metal. What looks words up takes the tables first:
//
//     float2 xi = wellstratLongSample2D(tables, context, order);
//
// `tables` is a `device const uint*` to the words of DeviceTables (device_tables.h), contexts and
// orders are uint2.

#ifndef WELLSTRAT_METAL
#define WELLSTRAT_METAL

#include <metal_stdlib>

#define WELLSTRAT_LANGUAGE
#define WELLSTRAT_PARAMETER device const uint *wellstratTables,
#define WELLSTRAT_ARGUMENT wellstratTables,
#define WELLSTRAT_WORD(i) wellstratTables[i]
#define WELLSTRAT_REVERSE_BITS(x) metal::reverse_bits(x)
#define WELLSTRAT_LOWEST_BIT(x) metal::ctz(x)
#define WELLSTRAT_UPPER_PRODUCT(a, b) metal::mulhi(a, b)

namespace {

using uvec2 = metal::uint2;
using uvec3 = metal::uint3;
using vec2 = metal::float2;
using vec3 = metal::float3;

#include "wellstrat.glsl"

} // namespace

#endif
