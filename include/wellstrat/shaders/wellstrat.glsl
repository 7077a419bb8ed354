// SPDX-License-Identifier: Apache-2.0
//
// The samples of wellstrat for shaders, with the bits of the C++ functions of the same names. It is
// GLSL, for OpenGL 4.0, Vulkan, OpenGL ES 3.00 and later versions; wellstrat.cl, wellstrat.hlsl and
// wellstrat.metal make it OpenCL C, HLSL and Metal.
//
// A context is a uvec2: patternid, sampleid. An order is a uvec2 too: the slot, and the product of
// all splits since the camera; WELLSTRAT_ROOT is a camera's. Slots from 16 on, and splits of 0 or
// above 256, are taken as no slot.
//
// Draws look words up: those of DeviceTables (device_tables.h). Before you include this file, say
// where they are; without it there are only the functions that need none.
//
//     layout(std430, binding = 0) readonly buffer Tables { uint tables[]; };
//     #define WELLSTRAT_WORD(i) tables[i]
//
// Nothing is stored, nothing fails, and each function is a pure one of its arguments.

#ifndef WELLSTRAT_GLSL
#define WELLSTRAT_GLSL

#ifndef WELLSTRAT_LANGUAGE // GLSL
#ifdef GL_ES
precision highp int;
precision highp float;
#endif
#if (defined(GL_ES) && __VERSION__ >= 310) || (!defined(GL_ES) && __VERSION__ >= 400)
#define WELLSTRAT_REVERSE_BITS(x) bitfieldReverse(x)
#define WELLSTRAT_LOWEST_BIT(x) uint(findLSB(x))
#endif
// Languages without global buffers hand them from function to function.
#define WELLSTRAT_PARAMETER
#define WELLSTRAT_ARGUMENT
#endif

#define WELLSTRAT_SLOTS 16u
#define WELLSTRAT_MAX_SPLIT 256u
#define WELLSTRAT_ROOT uvec2(WELLSTRAT_SLOTS, 1u)
#define WELLSTRAT_GOLDEN 0x9e3779b9u

// The parts of DeviceTables in words.
#define WELLSTRAT_SLOT_ORDERS 0u
#define WELLSTRAT_RANKS 1024u
#define WELLSTRAT_SLOT_RANKS 5120u
#define WELLSTRAT_RANK_XY 7172u
#define WELLSTRAT_RANK_Z 11268u
#define WELLSTRAT_JOINT_LOW 13316u
#define WELLSTRAT_JOINT_HIGH 17412u
#define WELLSTRAT_XY 17668u
#define WELLSTRAT_Z (WELLSTRAT_XY + 1572864u)

// Bits (bits.h).

uint wellstratReverseBits(uint x) {
#ifdef WELLSTRAT_REVERSE_BITS
    return WELLSTRAT_REVERSE_BITS(x);
#else
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
#endif
}

uint wellstratReverseByte(uint x) { return wellstratReverseBits(x) >> 24; }

/// The upper half of a product.
uint wellstratUpperProduct(uint a, uint b) {
#ifdef WELLSTRAT_UPPER_PRODUCT
    return WELLSTRAT_UPPER_PRODUCT(a, b);
#else
    uint a0 = a & 0xffffu, a1 = a >> 16, b0 = b & 0xffffu, b1 = b >> 16;
    uint middle = a1 * b0 + (a0 * b0 >> 16);
    uint other = a0 * b1 + (middle & 0xffffu);
    return a1 * b1 + (middle >> 16) + (other >> 16);
#endif
}

/// How often 2 divides x, which is not 0.
uint wellstratTrailingZeros(uint x) {
#ifdef WELLSTRAT_LOWEST_BIT
    return WELLSTRAT_LOWEST_BIT(x);
#else
    uint count = 0u;
    for (; (x & 1u) == 0u; x >>= 1) ++count;
    return count;
#endif
}

/// The bits below the highest one in which two words differ.
uint wellstratBitsBelowDifference(uint a, uint b) {
    uint differing = a ^ b;
    differing |= differing >> 1;
    differing |= differing >> 2;
    differing |= differing >> 4;
    differing |= differing >> 8;
    differing |= differing >> 16;
    return differing >> 1;
}

/// A fraction of 2^32, rounded down to a multiple of 2^-24.
float wellstratToUnitFloat(uint v) { return float(v >> 8) * (1.0f / 16777216.0f); }
vec2 wellstratToUnitFloats(uint x, uint y) {
    return vec2(wellstratToUnitFloat(x), wellstratToUnitFloat(y));
}
vec3 wellstratToUnitPoint(uvec3 v) {
    return vec3(wellstratToUnitFloat(v.x), wellstratToUnitFloat(v.y), wellstratToUnitFloat(v.z));
}

// Hashes (hash.h).

uint wellstratMix(uint x, uint secondMultiplier) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= secondMultiplier;
    return x ^ (x >> 15);
}
uint wellstratMixBits(uint x) { return wellstratMix(x, 0x735a2d97u); }

uint wellstratPermuteBits(uint x, uint key) {
    uint mask = wellstratMixBits(key + WELLSTRAT_GOLDEN);
    uint keyed = wellstratMixBits(mask + WELLSTRAT_GOLDEN) & 0x3c3c3c3cu;
    return wellstratMix(x ^ mask, keyed ^ 0x735a2d97u);
}

uint wellstratHashToUnsigned(uint a, uint b) {
    return wellstratMixBits(wellstratPermuteBits(b, a) + b);
}
float wellstratHashToRandom(uint a, uint b) {
    return wellstratToUnitFloat(wellstratHashToUnsigned(a, b));
}

// Domains (domain.h), orders (order.h) and cameras (camera.h).

uvec2 wellstratDerivationKey(uint scramble) {
    uint mask = wellstratMixBits(scramble + WELLSTRAT_GOLDEN);
    return uvec2(mask, (wellstratMixBits(mask + WELLSTRAT_GOLDEN) & ~7u) | 5u);
}
uint wellstratDerivePattern(uint patternid, uint scramble) {
    uvec2 key = wellstratDerivationKey(scramble);
    return (patternid ^ key.x) * key.y;
}

uvec2 wellstratNewDomainSplit(uvec2 context, uint scramble, uint newnumsamples) {
    return uvec2(wellstratDerivePattern(context.x, scramble), context.y * newnumsamples);
}
uvec2 wellstratNewDomain(uvec2 context, uint scramble) {
    return wellstratNewDomainSplit(context, scramble, 1u);
}
uvec2 wellstratNewDomainDistrib(uvec2 context, uint scramble, uint newsampleid) {
    uint domain = wellstratDerivePattern(context.x, scramble);
    return uvec2(wellstratPermuteBits(domain, context.y ^ 0x64697374u), newsampleid);
}

/// The scramble of a slot, below 16.
uint wellstratJointScramble(uint slot) { return 0x6a6f696eu + slot; }

/// The order of a domain: `split` is 1 for a plain new one, n for a split by n, and 0 for
/// distribution, after which there are no slots.
uvec2 wellstratDeriveOrder(uvec2 order, uint scramble, uint split) {
    bool kept = order.y - 1u < WELLSTRAT_MAX_SPLIT && split - 1u < WELLSTRAT_MAX_SPLIT &&
                order.y * split <= WELLSTRAT_MAX_SPLIT;
    uint slot = scramble - 0x6a6f696eu;
    return uvec2(kept && slot < WELLSTRAT_SLOTS ? slot : WELLSTRAT_SLOTS,
                 kept ? order.y * split : 0u);
}

bool wellstratHasSlot(uvec2 order) {
    return order.x < WELLSTRAT_SLOTS && order.y - 1u < WELLSTRAT_MAX_SPLIT;
}

/// The context of a sample of pixel (x, y), which count modulo 2^16; `seed` is 0 if there is none.
uvec2 wellstratCameraContext(int x, int y, uint frame, uint sampleid, uint seed) {
    uint pixel = (uint(x) & 0xffffu) | (uint(y) << 16);
    if (seed != 0u) pixel = wellstratPermuteBits(pixel, seed ^ 0x73656564u);
    return uvec2(wellstratPermuteBits(pixel, frame ^ 0x63616d65u), sampleid);
}

// The same for blue noise (blue_domain.h).

uint wellstratPermuteState(uint patternid, uint scramble) {
    uvec2 key = wellstratDerivationKey(scramble);
    uint state = ((patternid ^ key.x) & 0xfffff000u) * WELLSTRAT_GOLDEN;
    state ^= (state >> 10) & 0xfffff000u;
    state *= key.y;
    return state ^ ((state >> 10) & 0xfffff000u);
}
uint wellstratDeriveBluePattern(uint patternid, uint scramble) {
    return wellstratPermuteState(patternid, scramble) | (patternid & 0xfffu);
}

uvec2 wellstratNewBlueDomainSplit(uvec2 context, uint scramble, uint newnumsamples) {
    return uvec2(wellstratDeriveBluePattern(context.x, scramble), context.y * newnumsamples);
}
uvec2 wellstratNewBlueDomain(uvec2 context, uint scramble) {
    return wellstratNewBlueDomainSplit(context, scramble, 1u);
}
uvec2 wellstratNewBlueDomainDistrib(uvec2 context, uint scramble, uint newsampleid) {
    uint visit = (context.y ^ (context.y >> 20) * WELLSTRAT_GOLDEN) << 12;
    uint domain = wellstratDeriveBluePattern(context.x, scramble) ^ visit;
    return uvec2(wellstratDeriveBluePattern(domain, 0x64697374u), newsampleid);
}

/// A place of a tile that is shifted, flipped and transposed by the upper 15 bits of a hash.
uint wellstratMovedPlace(uint place, uint hash) {
    uint offset = hash >> 20;
    uint moved = ((place + offset) & 63u) | (((place & 4032u) + offset) & 4032u);
    if (((hash >> 19) & 1u) != 0u) moved ^= 63u;
    if (((hash >> 18) & 1u) != 0u) moved ^= 4032u;
    return ((hash >> 17) & 1u) != 0u ? ((moved & 63u) << 6) | (moved >> 6) : moved;
}

uvec2 wellstratBlueContext(int x, int y, uint seed, uint sampleid) {
    uint column = uint(x), row = uint(y);
    uint tile = ((column >> 6) & 1023u) | (((row >> 6) & 1023u) << 10);
    uint state = wellstratPermuteState(tile << 12, seed ^ 0x626c7565u);
    uint place = (column & 63u) | ((row & 63u) << 6);
    return uvec2(state | wellstratMovedPlace(place, wellstratMixBits(state ^ 0x626c7565u)),
                 sampleid);
}

// Independent random numbers (random.h). Functions named ...Bits give x, y and z of a sample as
// fractions of 2^32.

uvec3 wellstratRandomBits(uvec2 context) {
    return uvec3(wellstratHashToUnsigned(wellstratPermuteBits(context.x, 0x72616e64u), context.y),
                 wellstratHashToUnsigned(wellstratPermuteBits(context.x, 0x72616e65u), context.y),
                 wellstratHashToUnsigned(context.x, context.y));
}

// The computed sequence (sequence.h), and its points as digits, the first in bit 0.

uint wellstratOwenHash(uint digits, uint key) {
    digits += (key >> 16) | (key << 16);
    digits *= (key >> 7) | 1u;
    return digits ^ (2u * digits * digits);
}
uint wellstratNestedShuffle(uint index, uint key) {
    return wellstratReverseBits(wellstratOwenHash(wellstratReverseBits(index), key));
}
uint wellstratSequenceSeed(uint patternid) {
    uint x = patternid ^ 0x73657175u;
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    return x ^ (x >> 15);
}

uint wellstratPascalTimes(uint index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    return index ^ (index >> 16);
}
uint wellstratTrinomialTimes(uint index) {
    index ^= (index >> 8) & 0x00ffff00u;
    index ^= (index >> 16) & 0x000000ffu;
    index ^= (index >> 4) & 0x0ff00ff0u;
    index ^= (index >> 8) & 0x000f000fu;
    index ^= (index >> 2) & 0x3c3c3c3cu;
    index ^= (index >> 4) & 0x03030303u;
    index ^= (index >> 1) & 0x66666666u;
    index ^= (index >> 2) & 0x11111111u;
    return index ^ ((index >> 1) & 0x55555555u);
}

uvec3 wellstratSequenceDigits(uint index) {
    return uvec3(index, wellstratPascalTimes(index), wellstratTrinomialTimes(index));
}
uvec3 wellstratSequencePoint(uint seed, uint sampleid) {
    uint key = seed * 0x510e527fu;
    return wellstratSequenceDigits(wellstratNestedShuffle(sampleid, key) ^
                                   (wellstratNestedShuffle(0u, key) & 0xffff0000u));
}
uvec3 wellstratScrambledBits(uvec3 digits, uint seed) {
    return uvec3(wellstratReverseBits(wellstratOwenHash(digits.x, seed * 0xbb67ae85u)),
                 wellstratReverseBits(wellstratOwenHash(digits.y, seed * 0x3c6ef373u)),
                 wellstratReverseBits(wellstratOwenHash(digits.z, seed * 0xa54ff53bu)));
}

/// A sample of LongProgressive in a padded domain.
uvec3 wellstratSequenceBits(uvec2 context) {
    uint seed = wellstratSequenceSeed(context.x);
    return wellstratScrambledBits(wellstratSequencePoint(seed, context.y), seed);
}

#ifdef WELLSTRAT_WORD

// Shuffles of the tables (lookup.h) and of branches (joint_lookup.h).

uint wellstratShuffledPlace(uint seed, uint sampleid) {
    uint r = wellstratReverseBits(sampleid & 0xffu) | (sampleid & ~0xffu);
    r += seed;
    r *= 2u * seed + 1u;
    r ^= r * 0x3d20adeau;
    r ^= r * 0x05526c56u;
    return r >> 24;
}

uint wellstratJointBranch(uint seed, uint visit, uint branch, uint split) {
    uint evenLog2 = wellstratTrailingZeros(split);
    uint odd = split >> evenLog2, run = branch >> evenLog2;
    uint lowBits = (1u << evenLog2) - 1u;
    uint hash = wellstratMixBits(seed + visit * WELLSTRAT_GOLDEN);
    uint newRun = ((run << (hash & 7u)) + (((hash >> 9) * odd) >> 23)) % odd;
    uint shuffled = wellstratShuffledPlace(hash + run * WELLSTRAT_GOLDEN, branch & lowBits);
    return (newRun << evenLog2) + (wellstratReverseByte(shuffled) & lowBits);
}

// Slots of the computed sequence (sequence_slots.h).

uint wellstratSlotPlaces(WELLSTRAT_PARAMETER uint seed, uint slot, uint index) {
    uint first = WELLSTRAT_SLOT_ORDERS + slot * 64u;
    uint both = WELLSTRAT_WORD(first + (index & 15u)) ^
                WELLSTRAT_WORD(first + 16u + ((index >> 4) & 15u)) ^
                WELLSTRAT_WORD(first + 32u + ((index >> 8) & 15u)) ^
                WELLSTRAT_WORD(first + 48u + ((index >> 12) & 15u));
    return (seed >> 31) != 0u ? (both >> 16) | (both << 16) : both;
}

uint wellstratSlotBlock(uint seed, uint sampleid) {
    if (sampleid < 0x10000u) return 0u;
    uint key = seed * 0x510e527fu;
    return wellstratNestedShuffle(sampleid & 0xffff0000u, key) ^ wellstratNestedShuffle(0u, key);
}

uint wellstratSplitSlotIndex(WELLSTRAT_PARAMETER uint seed, uint sampleid, uvec2 order) {
    uint split = order.y, visit = sampleid / split;
    uint ordered = wellstratSlotBlock(seed, visit) ^
                   (wellstratSlotPlaces(WELLSTRAT_ARGUMENT seed, order.x, visit) & 0xffffu);
    uint visits = 0xffffffffu / split + (0xffffffffu % split + 1u == split ? 1u : 0u);
    uint mask = wellstratBitsBelowDifference(visit, visits);
    uint place = (visit & ~mask) | (ordered & mask);
    return place * split + wellstratJointBranch(seed, visit, sampleid % split, split);
}

uvec3 wellstratSlotDigits(WELLSTRAT_PARAMETER uint seed, uint sampleid, uvec2 order) {
    if (order.y != 1u) {
        return wellstratSequenceDigits(
            wellstratSplitSlotIndex(WELLSTRAT_ARGUMENT seed, sampleid, order));
    }
    uint places = wellstratSlotPlaces(WELLSTRAT_ARGUMENT seed, order.x, sampleid);
    uint block = wellstratSlotBlock(seed, sampleid);
    uint index = block ^ (places & 0xffffu);
    return uvec3(index, wellstratPascalTimes(block) ^ (places >> 16),
                 wellstratTrinomialTimes(index));
}

/// A sample of LongProgressive in a domain of this order.
uvec3 wellstratLongBits(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    if (!wellstratHasSlot(order)) return wellstratSequenceBits(context);
    uint seed = wellstratSequenceSeed(context.x);
    return wellstratScrambledBits(
        wellstratSlotDigits(WELLSTRAT_ARGUMENT seed, context.y, order), seed);
}

// Blue noise (blue_lookup.h).

/// The i-th of the numbers of 16 bits from a word on.
uint wellstratHalfWord(WELLSTRAT_PARAMETER uint word, uint i) {
    return (WELLSTRAT_WORD(word + (i >> 1)) >> ((i & 1u) * 16u)) & 0xffffu;
}

/// A point moved by what a rank adds to its digits in a slot.
uvec3 wellstratRankedDigits(WELLSTRAT_PARAMETER uvec3 digits, uint slot, uint rank) {
    uint low = slot * 128u + (rank & 63u), high = slot * 128u + 64u + (rank >> 6);
    uint xLow = WELLSTRAT_RANK_XY + 2u * low, xHigh = WELLSTRAT_RANK_XY + 2u * high;
    return uvec3(digits.x ^ WELLSTRAT_WORD(xLow) ^ WELLSTRAT_WORD(xHigh),
                 digits.y ^ WELLSTRAT_WORD(xLow + 1u) ^ WELLSTRAT_WORD(xHigh + 1u),
                 digits.z ^ WELLSTRAT_WORD(WELLSTRAT_RANK_Z + low) ^
                     WELLSTRAT_WORD(WELLSTRAT_RANK_Z + high));
}

uvec3 wellstratBlueDigits(WELLSTRAT_PARAMETER uvec2 context, uint seed) {
    uint place = wellstratMovedPlace(context.x & 0xfffu, seed * 0x1f83d9abu);
    return wellstratRankedDigits(WELLSTRAT_ARGUMENT wellstratSequencePoint(seed, context.y), 0u,
                                 wellstratHalfWord(WELLSTRAT_ARGUMENT WELLSTRAT_RANKS, place));
}
uvec3 wellstratBlueSlotDigits(WELLSTRAT_PARAMETER uvec2 context, uint seed, uvec2 order) {
    uint rank = wellstratHalfWord(WELLSTRAT_ARGUMENT WELLSTRAT_SLOT_RANKS, context.x & 0xfffu);
    uvec3 digits = wellstratSlotDigits(WELLSTRAT_ARGUMENT seed & 0x7fffffffu, context.y, order);
    return wellstratRankedDigits(WELLSTRAT_ARGUMENT digits, order.x, rank);
}

/// A sample of BlueProgressive in a domain of this order.
uvec3 wellstratBlueBits(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    uint seed = wellstratSequenceSeed(context.x >> 12);
    uvec3 digits = uvec3(0u, 0u, 0u);
    if (wellstratHasSlot(order)) {
        digits = wellstratBlueSlotDigits(WELLSTRAT_ARGUMENT context, seed, order);
    } else {
        digits = wellstratBlueDigits(WELLSTRAT_ARGUMENT context, seed);
    }
    if ((seed >> 31) != 0u) digits = uvec3(digits.y, digits.x, digits.z);
    return wellstratScrambledBits(digits, seed);
}

// The tables (lookup.h).

/// x and y of a word.
uvec2 wellstratTableXY(uint word) {
    return uvec2(word * 0xffff0f11u, wellstratUpperProduct(word, 0xffff0f11u));
}

/// The point at a place, below 256, of a group of a block's table. Its z is read if it is
/// asked for only: DeviceTables for 2D draws have none.
uvec3 wellstratTableBits(WELLSTRAT_PARAMETER uint seed, uint block, uint group, uint place,
                         bool withZ) {
    uint table = (((seed + block * 0x05555555u) >> 9) * 384u) >> 23;
    uint offset = (group * 384u + table) * 256u + place;
    uvec2 xy = wellstratTableXY(WELLSTRAT_WORD(WELLSTRAT_XY + offset));
    uint z = 0u;
    if (withZ) z = WELLSTRAT_WORD(WELLSTRAT_Z + offset) ^ (seed * 0x3c6ef373u);
    return uvec3(xy.x ^ (seed * 0x84caa73bu),
                 xy.y ^ (wellstratUpperProduct(seed, 0x84caa73bu) + seed * 0xbb67ae85u),
                 z);
}

/// A sample without a generator: from the tables, and from 196608 on unstratified.
uvec3 wellstratSampleBits(WELLSTRAT_PARAMETER uvec2 context, bool withZ) {
    uint sampleid = context.y;
    if (sampleid >= 196608u) return wellstratRandomBits(context);
    uint seed = wellstratMixBits(context.x + WELLSTRAT_GOLDEN);
    return wellstratTableBits(WELLSTRAT_ARGUMENT seed, sampleid >> 12, (sampleid >> 8) & 15u,
                              wellstratShuffledPlace(seed, sampleid), withZ);
}

// Slots of the tables (joint_lookup.h).

uint wellstratJointPlace(WELLSTRAT_PARAMETER uint seed, uint slot, uint index) {
    uint both = WELLSTRAT_WORD(WELLSTRAT_JOINT_LOW + slot * 256u + (index & 255u)) ^
                WELLSTRAT_WORD(WELLSTRAT_JOINT_HIGH + slot * 16u + (index >> 8));
    return (both >> (seed & 16u)) & 4095u;
}
uint wellstratWithReversedByte(uint place) {
    return (place & ~0xffu) | wellstratReverseByte(place);
}

uint wellstratJointIndex(WELLSTRAT_PARAMETER uint seed, uint sampleid, uvec2 order) {
    uint split = order.y, visit = sampleid / split;
    uint mask = wellstratBitsBelowDifference(visit, 196608u / split) & 4095u;
    uint place = wellstratJointPlace(WELLSTRAT_ARGUMENT seed, order.x, visit & mask);
    return ((visit & ~mask) | wellstratWithReversedByte(place)) * split +
           wellstratJointBranch(seed, visit, sampleid % split, split);
}

/// A sample of JointProgressive in a domain of this order.
uvec3 wellstratJointBits(WELLSTRAT_PARAMETER uvec2 context, uvec2 order, bool withZ) {
    if (!wellstratHasSlot(order)) return wellstratSampleBits(WELLSTRAT_ARGUMENT context, withZ);
    uint sampleid = context.y;
    if (sampleid >= 196608u - 196608u % order.y) return wellstratRandomBits(context);
    uint seed = wellstratMixBits(context.x + WELLSTRAT_GOLDEN);
    uint block = sampleid >> 12, place = 0u;
    if (order.y == 1u) {
        place = wellstratJointPlace(WELLSTRAT_ARGUMENT seed, order.x, sampleid & 4095u);
    } else {
        uint index = wellstratJointIndex(WELLSTRAT_ARGUMENT seed, sampleid, order);
        block = index >> 12;
        place = wellstratWithReversedByte(index & 4095u);
    }
    return wellstratTableBits(WELLSTRAT_ARGUMENT seed, block, place >> 8, (place ^ seed) & 255u,
                              withZ);
}

#endif // WELLSTRAT_WORD

// Samples in [0, 1): z of a point in 1D, (x, y) in 2D, all three in 3D.

float wellstratRandomSample1D(uvec2 context) {
    return wellstratToUnitFloat(wellstratRandomBits(context).z);
}
vec2 wellstratRandomSample2D(uvec2 context) {
    uvec3 bits = wellstratRandomBits(context);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratRandomSample3D(uvec2 context) {
    return wellstratToUnitPoint(wellstratRandomBits(context));
}

float wellstratSequenceSample1D(uvec2 context) {
    return wellstratToUnitFloat(wellstratSequenceBits(context).z);
}
vec2 wellstratSequenceSample2D(uvec2 context) {
    uvec3 bits = wellstratSequenceBits(context);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratSequenceSample3D(uvec2 context) {
    return wellstratToUnitPoint(wellstratSequenceBits(context));
}

#ifdef WELLSTRAT_WORD

float wellstratSample1D(WELLSTRAT_PARAMETER uvec2 context) {
    return wellstratToUnitFloat(wellstratSampleBits(WELLSTRAT_ARGUMENT context, true).z);
}
vec2 wellstratSample2D(WELLSTRAT_PARAMETER uvec2 context) {
    uvec3 bits = wellstratSampleBits(WELLSTRAT_ARGUMENT context, false);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratSample3D(WELLSTRAT_PARAMETER uvec2 context) {
    return wellstratToUnitPoint(wellstratSampleBits(WELLSTRAT_ARGUMENT context, true));
}

float wellstratJointSample1D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitFloat(wellstratJointBits(WELLSTRAT_ARGUMENT context, order, true).z);
}
vec2 wellstratJointSample2D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    uvec3 bits = wellstratJointBits(WELLSTRAT_ARGUMENT context, order, false);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratJointSample3D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitPoint(wellstratJointBits(WELLSTRAT_ARGUMENT context, order, true));
}

float wellstratLongSample1D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitFloat(wellstratLongBits(WELLSTRAT_ARGUMENT context, order).z);
}
vec2 wellstratLongSample2D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    uvec3 bits = wellstratLongBits(WELLSTRAT_ARGUMENT context, order);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratLongSample3D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitPoint(wellstratLongBits(WELLSTRAT_ARGUMENT context, order));
}

float wellstratBlueSample1D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitFloat(wellstratBlueBits(WELLSTRAT_ARGUMENT context, order).z);
}
vec2 wellstratBlueSample2D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    uvec3 bits = wellstratBlueBits(WELLSTRAT_ARGUMENT context, order);
    return wellstratToUnitFloats(bits.x, bits.y);
}
vec3 wellstratBlueSample3D(WELLSTRAT_PARAMETER uvec2 context, uvec2 order) {
    return wellstratToUnitPoint(wellstratBlueBits(WELLSTRAT_ARGUMENT context, order));
}

#endif // WELLSTRAT_WORD
#endif // WELLSTRAT_GLSL
