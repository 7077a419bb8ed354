// SPDX-License-Identifier: Apache-2.0
//
// Answers many questions on WebGPU, as answer.glsl does.

@group(0) @binding(0) var<storage, read> wellstratWords: array<u32>;
@group(0) @binding(1) var<storage, read> questions: array<u32>;
@group(0) @binding(2) var<storage, read_write> answers: array<vec4u>;

#include "wellstrat/shaders/wellstrat.wgsl"

fn answerContext(context: vec2u) -> vec3u { return vec3u(context, 0u); }

fn drawn(z: f32, xy: vec2f, xyz: vec3f) -> vec3u {
    if (any(xyz != vec3f(xy, z))) { return vec3u(~0u); }
    return vec3u(xyz * 16777216.0);
}

fn answerSample(kind: u32, context: vec2u, order: vec2u) -> vec3u {
    switch (kind) {
        case 0u: {
            return drawn(wellstratSample1D(context), wellstratSample2D(context),
                         wellstratSample3D(context));
        }
        case 1u: {
            return drawn(wellstratRandomSample1D(context), wellstratRandomSample2D(context),
                         wellstratRandomSample3D(context));
        }
        case 2u: {
            return drawn(wellstratJointSample1D(context, order),
                         wellstratJointSample2D(context, order),
                         wellstratJointSample3D(context, order));
        }
        case 3u: {
            return drawn(wellstratSequenceSample1D(context), wellstratSequenceSample2D(context),
                         wellstratSequenceSample3D(context));
        }
        case 4u: {
            return drawn(wellstratLongSample1D(context, order),
                         wellstratLongSample2D(context, order),
                         wellstratLongSample3D(context, order));
        }
        default: {
            let blueOrder = select(wellstratRoot, order, kind == 6u);
            return drawn(wellstratBlueSample1D(context, blueOrder),
                         wellstratBlueSample2D(context, blueOrder),
                         wellstratBlueSample3D(context, blueOrder));
        }
    }
}

fn answerTablePoint(table: u32, index: u32) -> vec3u {
    let offset = ((index >> 8u) * 384u + table) * 256u + wellstratReverseByte(index);
    let xy = wellstratTableXY(wellstratWords[wellstratXY + offset]);
    return vec3u(xy, wellstratWords[wellstratZ + offset]) & vec3u(~0xffu);
}

fn answer(kind: u32, a0: u32, a1: u32, a2: u32, a3: u32, a4: u32) -> vec3u {
    let context = vec2u(a0, a1);
    let x = i32(a0);
    let y = i32(a1);
    switch (kind) {
        case 7u: { return wellstratSequenceBits(context); }
        case 8u: { return answerTablePoint(a0, a1); }
        case 9u: { return vec3u(wellstratHashToUnsigned(a0, a1), 0u, 0u); }
        case 10u: { return answerContext(wellstratNewDomain(context, a2)); }
        case 11u: { return answerContext(wellstratNewDomainDistrib(context, a2, a3)); }
        case 12u: { return answerContext(wellstratNewDomainSplit(context, a2, a3)); }
        case 13u: { return answerContext(wellstratCameraContext(x, y, a2, a3, 0u)); }
        case 14u: { return answerContext(wellstratCameraContext(x, y, a2, a3, a4)); }
        case 15u: { return answerContext(wellstratNewBlueDomainSplit(context, a2, a3)); }
        case 16u: { return answerContext(wellstratNewBlueDomainDistrib(context, a2, a3)); }
        case 17u: { return answerContext(wellstratBlueContext(x, y, a2, a3)); }
        case 18u: { return answerContext(wellstratDeriveOrder(context, a2, a3)); }
        case 19u: { return answerSample(4u, context, vec2u(a2, a3)); }
        default: { return answerSample(kind, context, vec2u(a2, a3)); }
    }
}

@compute @workgroup_size(64)
fn answerAll(@builtin(global_invocation_id) thread: vec3u) {
    let i = thread.x;
    if (i >= arrayLength(&answers)) { return; }
    let q = 8u * i;
    answers[i] = vec4u(answer(questions[q], questions[q + 1u], questions[q + 2u],
                              questions[q + 3u], questions[q + 4u], questions[q + 5u]), 0u);
}
