#version 450
// SPDX-License-Identifier: Apache-2.0
//
// Answers many questions on Vulkan.

#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Tables { uint tables[]; };
layout(std430, binding = 1) readonly buffer Questions { uint questions[]; };
layout(std430, binding = 2) writeonly buffer Answers { uint answers[]; };

#define WELLSTRAT_WORD(i) tables[i]
#include "wellstrat/shaders/wellstrat.glsl"

#include "answer.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(questions.length()) / 6u) return;
    uint q = 6u * i;
    uvec3 words = answer(questions[q], questions[q + 1u], questions[q + 2u], questions[q + 3u],
                         questions[q + 4u], questions[q + 5u]);
    answers[3u * i] = words.x;
    answers[3u * i + 1u] = words.y;
    answers[3u * i + 2u] = words.z;
}
