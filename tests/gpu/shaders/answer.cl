// SPDX-License-Identifier: Apache-2.0
//
// Answers many questions on OpenCL.

#include "wellstrat/shaders/wellstrat.cl"

#define uint(x) ((uint)(x))
#define int(x) ((int)(x))
#define uvec3(x, y, z) ((uint3)((x), (y), (z)))

#include "answer.glsl"

__kernel void answerAll(__global const uint *tables, __global const uint *questions,
                        __global uint *answers) {
    const size_t i = get_global_id(0), q = 6 * i;
    const uint3 words = answer(tables, questions[q], questions[q + 1], questions[q + 2],
                               questions[q + 3], questions[q + 4], questions[q + 5]);
    answers[3 * i] = words.x;
    answers[3 * i + 1] = words.y;
    answers[3 * i + 2] = words.z;
}
