#version 300 es
// SPDX-License-Identifier: Apache-2.0
//
// Answers a question a pixel on OpenGL ES 3.00, which has no buffers: words are in textures.

precision highp usampler2D;

uniform usampler2D tables, questions;
out uvec4 words;

#define WELLSTRAT_WORD(i) texelFetch(tables, ivec2(int((i) & 2047u), int((i) >> 11)), 0).x
#include "wellstrat/shaders/wellstrat.glsl"

#include "answer.glsl"

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 first = texelFetch(questions, ivec2(2 * at.x, at.y), 0);
    uvec4 second = texelFetch(questions, ivec2(2 * at.x + 1, at.y), 0);
    words = uvec4(answer(first.x, first.y, first.z, first.w, second.x, second.y), 0u);
}
