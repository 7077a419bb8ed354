// SPDX-License-Identifier: Apache-2.0
//
// `answer` of question.h for shaders, in the language of wellstrat.glsl. The kinds are those of
// Kind, in its order.

uvec3 answerContext(uvec2 context) { return uvec3(context.x, context.y, 0u); }

/// The answer of three draws from one context, or words that no sample has if they disagree.
uvec3 drawn(float z, vec2 xy, vec3 xyz) {
    if (xyz.x != xy.x || xyz.y != xy.y || xyz.z != z) return uvec3(~0u, ~0u, ~0u);
    return uvec3(uint(xyz.x * 16777216.0f), uint(xyz.y * 16777216.0f), uint(xyz.z * 16777216.0f));
}

uvec3 answerSample(WELLSTRAT_PARAMETER uint kind, uvec2 context, uvec2 order) {
    if (kind == 0u) {
        return drawn(wellstratSample1D(WELLSTRAT_ARGUMENT context),
                     wellstratSample2D(WELLSTRAT_ARGUMENT context),
                     wellstratSample3D(WELLSTRAT_ARGUMENT context));
    }
    if (kind == 1u) {
        return drawn(wellstratRandomSample1D(context), wellstratRandomSample2D(context),
                     wellstratRandomSample3D(context));
    }
    if (kind == 2u) {
        return drawn(wellstratJointSample1D(WELLSTRAT_ARGUMENT context, order),
                     wellstratJointSample2D(WELLSTRAT_ARGUMENT context, order),
                     wellstratJointSample3D(WELLSTRAT_ARGUMENT context, order));
    }
    if (kind == 3u) {
        return drawn(wellstratSequenceSample1D(context), wellstratSequenceSample2D(context),
                     wellstratSequenceSample3D(context));
    }
    if (kind == 4u) {
        return drawn(wellstratLongSample1D(WELLSTRAT_ARGUMENT context, order),
                     wellstratLongSample2D(WELLSTRAT_ARGUMENT context, order),
                     wellstratLongSample3D(WELLSTRAT_ARGUMENT context, order));
    }
    uvec2 blueOrder = WELLSTRAT_ROOT;
    if (kind == 6u) blueOrder = order;
    return drawn(wellstratBlueSample1D(WELLSTRAT_ARGUMENT context, blueOrder),
                 wellstratBlueSample2D(WELLSTRAT_ARGUMENT context, blueOrder),
                 wellstratBlueSample3D(WELLSTRAT_ARGUMENT context, blueOrder));
}

uvec3 answerTablePoint(WELLSTRAT_PARAMETER uint table, uint index) {
    uint offset = ((index >> 8) * 384u + table) * 256u + wellstratReverseByte(index);
    uvec2 xy = wellstratTableXY(WELLSTRAT_WORD(WELLSTRAT_XY + offset));
    return uvec3(xy.x & ~0xffu, xy.y & ~0xffu, WELLSTRAT_WORD(WELLSTRAT_Z + offset) & ~0xffu);
}

uvec3 answer(WELLSTRAT_PARAMETER uint kind, uint a0, uint a1, uint a2, uint a3, uint a4) {
    uvec2 context = uvec2(a0, a1);
    if (kind < 7u) return answerSample(WELLSTRAT_ARGUMENT kind, context, uvec2(a2, a3));
    if (kind == 7u) return wellstratSequenceBits(context);
    if (kind == 8u) return answerTablePoint(WELLSTRAT_ARGUMENT a0, a1);
    if (kind == 9u) return uvec3(wellstratHashToUnsigned(a0, a1), 0u, 0u);
    if (kind == 10u) return answerContext(wellstratNewDomain(context, a2));
    if (kind == 11u) return answerContext(wellstratNewDomainDistrib(context, a2, a3));
    if (kind == 12u) return answerContext(wellstratNewDomainSplit(context, a2, a3));
    if (kind == 13u) return answerContext(wellstratCameraContext(int(a0), int(a1), a2, a3, 0u));
    if (kind == 14u) return answerContext(wellstratCameraContext(int(a0), int(a1), a2, a3, a4));
    if (kind == 15u) return answerContext(wellstratNewBlueDomainSplit(context, a2, a3));
    if (kind == 16u) return answerContext(wellstratNewBlueDomainDistrib(context, a2, a3));
    if (kind == 17u) return answerContext(wellstratBlueContext(int(a0), int(a1), a2, a3));
    if (kind == 18u) return answerContext(wellstratDeriveOrder(context, a2, a3));
    return answerSample(WELLSTRAT_ARGUMENT 4u, context, uvec2(a2, a3));
}
