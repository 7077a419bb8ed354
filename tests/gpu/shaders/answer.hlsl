// SPDX-License-Identifier: Apache-2.0
//
// Answers many questions, in HLSL.

StructuredBuffer<uint> tables : register(t0);
StructuredBuffer<uint> questions : register(t1);
RWStructuredBuffer<uint> answers : register(u2);

#define WELLSTRAT_WORD(i) tables[i]
#include "wellstrat/shaders/wellstrat.hlsl"

#define uvec3 uint3
#define vec2 float2
#define vec3 float3
#include "answer.glsl"

[numthreads(64, 1, 1)] void main(uint3 thread : SV_DispatchThreadID) {
    uint count, stride;
    questions.GetDimensions(count, stride);
    uint i = thread.x, q = 6u * i;
    if (i >= count / 6u) return;
    uint3 words = answer(questions[q], questions[q + 1u], questions[q + 2u], questions[q + 3u],
                         questions[q + 4u], questions[q + 5u]);
    answers[3u * i] = words.x;
    answers[3u * i + 1u] = words.y;
    answers[3u * i + 2u] = words.z;
}
