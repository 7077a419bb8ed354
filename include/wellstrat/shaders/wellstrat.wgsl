// SPDX-License-Identifier: Apache-2.0
//
// The samples of wellstrat in WGSL, with the bits of the C++ functions of the same names. It says
// what wellstrat.glsl says, which has the comments, line by line.
//
// A context is a vec2u: patternid, sampleid. An order is a vec2u too: the slot, and the product of
// all splits since the camera; wellstratRoot is a camera's. Slots from 16 on, and splits of 0 or
// above 256, are taken as no slot.
//
// WGSL includes nothing: put this text before your own, and with it where the words of DeviceTables
// (device_tables.h) are, under this name:
//
//     @group(0) @binding(0) var<storage, read> wellstratWords: array<u32>;

const wellstratSlots = 16u;
const wellstratMaxSplit = 256u;
const wellstratRoot = vec2u(wellstratSlots, 1u);
const wellstratGolden = 0x9e3779b9u;

// The parts of DeviceTables in words.
const wellstratSlotOrders = 0u;
const wellstratRanks = 1024u;
const wellstratSlotRanks = 5120u;
const wellstratRankXY = 7172u;
const wellstratRankZ = 11268u;
const wellstratJointLow = 13316u;
const wellstratJointHigh = 17412u;
const wellstratXY = 17668u;
const wellstratZ = wellstratXY + 1572864u;

// Bits (bits.h).

fn wellstratReverseByte(x: u32) -> u32 { return reverseBits(x) >> 24u; }

fn wellstratUpperProduct(a: u32, b: u32) -> u32 {
    let a0 = a & 0xffffu;
    let a1 = a >> 16u;
    let b0 = b & 0xffffu;
    let b1 = b >> 16u;
    let middle = a1 * b0 + ((a0 * b0) >> 16u);
    let other = a0 * b1 + (middle & 0xffffu);
    return a1 * b1 + (middle >> 16u) + (other >> 16u);
}

fn wellstratBitsBelowDifference(a: u32, b: u32) -> u32 {
    var differing = a ^ b;
    differing |= differing >> 1u;
    differing |= differing >> 2u;
    differing |= differing >> 4u;
    differing |= differing >> 8u;
    differing |= differing >> 16u;
    return differing >> 1u;
}

fn wellstratToUnitFloat(v: u32) -> f32 { return f32(v >> 8u) * (1.0 / 16777216.0); }
fn wellstratToUnitPoint(v: vec3u) -> vec3f { return vec3f(v >> vec3u(8u)) * (1.0 / 16777216.0); }

// Hashes (hash.h).

fn wellstratMix(word: u32, secondMultiplier: u32) -> u32 {
    var x = word ^ (word >> 16u);
    x *= 0x21f0aaadu;
    x ^= x >> 15u;
    x *= secondMultiplier;
    return x ^ (x >> 15u);
}
fn wellstratMixBits(x: u32) -> u32 { return wellstratMix(x, 0x735a2d97u); }

fn wellstratPermuteBits(x: u32, key: u32) -> u32 {
    let mask = wellstratMixBits(key + wellstratGolden);
    let keyed = wellstratMixBits(mask + wellstratGolden) & 0x3c3c3c3cu;
    return wellstratMix(x ^ mask, keyed ^ 0x735a2d97u);
}

fn wellstratHashToUnsigned(a: u32, b: u32) -> u32 {
    return wellstratMixBits(wellstratPermuteBits(b, a) + b);
}
fn wellstratHashToRandom(a: u32, b: u32) -> f32 {
    return wellstratToUnitFloat(wellstratHashToUnsigned(a, b));
}

// Domains (domain.h), orders (order.h) and cameras (camera.h).

fn wellstratDerivationKey(scramble: u32) -> vec2u {
    let mask = wellstratMixBits(scramble + wellstratGolden);
    return vec2u(mask, (wellstratMixBits(mask + wellstratGolden) & ~7u) | 5u);
}
fn wellstratDerivePattern(patternid: u32, scramble: u32) -> u32 {
    let key = wellstratDerivationKey(scramble);
    return (patternid ^ key.x) * key.y;
}

fn wellstratNewDomainSplit(context: vec2u, scramble: u32, newnumsamples: u32) -> vec2u {
    return vec2u(wellstratDerivePattern(context.x, scramble), context.y * newnumsamples);
}
fn wellstratNewDomain(context: vec2u, scramble: u32) -> vec2u {
    return wellstratNewDomainSplit(context, scramble, 1u);
}
fn wellstratNewDomainDistrib(context: vec2u, scramble: u32, newsampleid: u32) -> vec2u {
    let domain = wellstratDerivePattern(context.x, scramble);
    return vec2u(wellstratPermuteBits(domain, context.y ^ 0x64697374u), newsampleid);
}

fn wellstratJointScramble(slot: u32) -> u32 { return 0x6a6f696eu + slot; }

fn wellstratDeriveOrder(order: vec2u, scramble: u32, split: u32) -> vec2u {
    let kept = order.y - 1u < wellstratMaxSplit && split - 1u < wellstratMaxSplit &&
               order.y * split <= wellstratMaxSplit;
    let slot = scramble - 0x6a6f696eu;
    return vec2u(select(wellstratSlots, slot, kept && slot < wellstratSlots),
                 select(0u, order.y * split, kept));
}

fn wellstratHasSlot(order: vec2u) -> bool {
    return order.x < wellstratSlots && order.y - 1u < wellstratMaxSplit;
}

fn wellstratCameraContext(x: i32, y: i32, frame: u32, sampleid: u32, seed: u32) -> vec2u {
    var pixel = (u32(x) & 0xffffu) | (u32(y) << 16u);
    if (seed != 0u) { pixel = wellstratPermuteBits(pixel, seed ^ 0x73656564u); }
    return vec2u(wellstratPermuteBits(pixel, frame ^ 0x63616d65u), sampleid);
}

// The same for blue noise (blue_domain.h).

fn wellstratPermuteState(patternid: u32, scramble: u32) -> u32 {
    let key = wellstratDerivationKey(scramble);
    var state = ((patternid ^ key.x) & 0xfffff000u) * wellstratGolden;
    state ^= (state >> 10u) & 0xfffff000u;
    state *= key.y;
    return state ^ ((state >> 10u) & 0xfffff000u);
}
fn wellstratDeriveBluePattern(patternid: u32, scramble: u32) -> u32 {
    return wellstratPermuteState(patternid, scramble) | (patternid & 0xfffu);
}

fn wellstratNewBlueDomainSplit(context: vec2u, scramble: u32, newnumsamples: u32) -> vec2u {
    return vec2u(wellstratDeriveBluePattern(context.x, scramble), context.y * newnumsamples);
}
fn wellstratNewBlueDomain(context: vec2u, scramble: u32) -> vec2u {
    return wellstratNewBlueDomainSplit(context, scramble, 1u);
}
fn wellstratNewBlueDomainDistrib(context: vec2u, scramble: u32, newsampleid: u32) -> vec2u {
    let visit = (context.y ^ ((context.y >> 20u) * wellstratGolden)) << 12u;
    let domain = wellstratDeriveBluePattern(context.x, scramble) ^ visit;
    return vec2u(wellstratDeriveBluePattern(domain, 0x64697374u), newsampleid);
}

fn wellstratMovedPlace(place: u32, hash: u32) -> u32 {
    let offset = hash >> 20u;
    var moved = ((place + offset) & 63u) | (((place & 4032u) + offset) & 4032u);
    if (((hash >> 19u) & 1u) != 0u) { moved ^= 63u; }
    if (((hash >> 18u) & 1u) != 0u) { moved ^= 4032u; }
    return select(moved, ((moved & 63u) << 6u) | (moved >> 6u), ((hash >> 17u) & 1u) != 0u);
}

fn wellstratBlueContext(x: i32, y: i32, seed: u32, sampleid: u32) -> vec2u {
    let column = u32(x);
    let row = u32(y);
    let tile = ((column >> 6u) & 1023u) | (((row >> 6u) & 1023u) << 10u);
    let state = wellstratPermuteState(tile << 12u, seed ^ 0x626c7565u);
    let place = (column & 63u) | ((row & 63u) << 6u);
    return vec2u(state | wellstratMovedPlace(place, wellstratMixBits(state ^ 0x626c7565u)),
                 sampleid);
}

// Independent random numbers (random.h). Functions named ...Bits give x, y and z of a sample as
// fractions of 2^32.

fn wellstratRandomBits(context: vec2u) -> vec3u {
    return vec3u(wellstratHashToUnsigned(wellstratPermuteBits(context.x, 0x72616e64u), context.y),
                 wellstratHashToUnsigned(wellstratPermuteBits(context.x, 0x72616e65u), context.y),
                 wellstratHashToUnsigned(context.x, context.y));
}

// The computed sequence (sequence.h), and its points as digits, the first in bit 0.

fn wellstratOwenHash(word: u32, key: u32) -> u32 {
    var digits = word + ((key >> 16u) | (key << 16u));
    digits *= (key >> 7u) | 1u;
    return digits ^ (2u * digits * digits);
}
fn wellstratNestedShuffle(index: u32, key: u32) -> u32 {
    return reverseBits(wellstratOwenHash(reverseBits(index), key));
}
fn wellstratSequenceSeed(patternid: u32) -> u32 {
    var x = patternid ^ 0x73657175u;
    x ^= x >> 16u;
    x *= 0x21f0aaadu;
    return x ^ (x >> 15u);
}

fn wellstratPascalTimes(word: u32) -> u32 {
    var index = word ^ ((word >> 1u) & 0x55555555u);
    index ^= (index >> 2u) & 0x33333333u;
    index ^= (index >> 4u) & 0x0f0f0f0fu;
    index ^= (index >> 8u) & 0x00ff00ffu;
    return index ^ (index >> 16u);
}
fn wellstratTrinomialTimes(word: u32) -> u32 {
    var index = word ^ ((word >> 8u) & 0x00ffff00u);
    index ^= (index >> 16u) & 0x000000ffu;
    index ^= (index >> 4u) & 0x0ff00ff0u;
    index ^= (index >> 8u) & 0x000f000fu;
    index ^= (index >> 2u) & 0x3c3c3c3cu;
    index ^= (index >> 4u) & 0x03030303u;
    index ^= (index >> 1u) & 0x66666666u;
    index ^= (index >> 2u) & 0x11111111u;
    return index ^ ((index >> 1u) & 0x55555555u);
}

fn wellstratSequenceDigits(index: u32) -> vec3u {
    return vec3u(index, wellstratPascalTimes(index), wellstratTrinomialTimes(index));
}
fn wellstratSequencePoint(seed: u32, sampleid: u32) -> vec3u {
    let key = seed * 0x510e527fu;
    return wellstratSequenceDigits(wellstratNestedShuffle(sampleid, key) ^
                                   (wellstratNestedShuffle(0u, key) & 0xffff0000u));
}
fn wellstratScrambledBits(digits: vec3u, seed: u32) -> vec3u {
    return reverseBits(vec3u(wellstratOwenHash(digits.x, seed * 0xbb67ae85u),
                             wellstratOwenHash(digits.y, seed * 0x3c6ef373u),
                             wellstratOwenHash(digits.z, seed * 0xa54ff53bu)));
}

fn wellstratSequenceBits(context: vec2u) -> vec3u {
    let seed = wellstratSequenceSeed(context.x);
    return wellstratScrambledBits(wellstratSequencePoint(seed, context.y), seed);
}

// Shuffles of the tables (lookup.h) and of branches (joint_lookup.h).

fn wellstratShuffledPlace(seed: u32, sampleid: u32) -> u32 {
    var r = reverseBits(sampleid & 0xffu) | (sampleid & ~0xffu);
    r += seed;
    r *= 2u * seed + 1u;
    r ^= r * 0x3d20adeau;
    r ^= r * 0x05526c56u;
    return r >> 24u;
}

fn wellstratJointBranch(seed: u32, visit: u32, branch: u32, split: u32) -> u32 {
    let evenLog2 = countTrailingZeros(split);
    let odd = split >> evenLog2;
    let run = branch >> evenLog2;
    let lowBits = (1u << evenLog2) - 1u;
    let hash = wellstratMixBits(seed + visit * wellstratGolden);
    let newRun = ((run << (hash & 7u)) + (((hash >> 9u) * odd) >> 23u)) % odd;
    let shuffled = wellstratShuffledPlace(hash + run * wellstratGolden, branch & lowBits);
    return (newRun << evenLog2) + (wellstratReverseByte(shuffled) & lowBits);
}

// Slots of the computed sequence (sequence_slots.h).

fn wellstratSlotPlaces(seed: u32, slot: u32, index: u32) -> u32 {
    let first = wellstratSlotOrders + slot * 64u;
    let both = wellstratWords[first + (index & 15u)] ^
               wellstratWords[first + 16u + ((index >> 4u) & 15u)] ^
               wellstratWords[first + 32u + ((index >> 8u) & 15u)] ^
               wellstratWords[first + 48u + ((index >> 12u) & 15u)];
    return select(both, (both >> 16u) | (both << 16u), (seed >> 31u) != 0u);
}

fn wellstratSlotBlock(seed: u32, sampleid: u32) -> u32 {
    if (sampleid < 0x10000u) { return 0u; }
    let key = seed * 0x510e527fu;
    return wellstratNestedShuffle(sampleid & 0xffff0000u, key) ^ wellstratNestedShuffle(0u, key);
}

fn wellstratSplitSlotIndex(seed: u32, sampleid: u32, order: vec2u) -> u32 {
    let split = order.y;
    let visit = sampleid / split;
    let ordered = wellstratSlotBlock(seed, visit) ^
                  (wellstratSlotPlaces(seed, order.x, visit) & 0xffffu);
    let visits = 0xffffffffu / split + select(0u, 1u, 0xffffffffu % split + 1u == split);
    let mask = wellstratBitsBelowDifference(visit, visits);
    let place = (visit & ~mask) | (ordered & mask);
    return place * split + wellstratJointBranch(seed, visit, sampleid % split, split);
}

fn wellstratSlotDigits(seed: u32, sampleid: u32, order: vec2u) -> vec3u {
    if (order.y != 1u) {
        return wellstratSequenceDigits(wellstratSplitSlotIndex(seed, sampleid, order));
    }
    let places = wellstratSlotPlaces(seed, order.x, sampleid);
    let block = wellstratSlotBlock(seed, sampleid);
    let index = block ^ (places & 0xffffu);
    return vec3u(index, wellstratPascalTimes(block) ^ (places >> 16u),
                 wellstratTrinomialTimes(index));
}

fn wellstratLongBits(context: vec2u, order: vec2u) -> vec3u {
    if (!wellstratHasSlot(order)) { return wellstratSequenceBits(context); }
    let seed = wellstratSequenceSeed(context.x);
    return wellstratScrambledBits(wellstratSlotDigits(seed, context.y, order), seed);
}

// Blue noise (blue_lookup.h).

fn wellstratHalfWord(word: u32, i: u32) -> u32 {
    return (wellstratWords[word + (i >> 1u)] >> ((i & 1u) * 16u)) & 0xffffu;
}

fn wellstratRankedDigits(digits: vec3u, slot: u32, rank: u32) -> vec3u {
    let low = slot * 128u + (rank & 63u);
    let high = slot * 128u + 64u + (rank >> 6u);
    let xLow = wellstratRankXY + 2u * low;
    let xHigh = wellstratRankXY + 2u * high;
    return vec3u(digits.x ^ wellstratWords[xLow] ^ wellstratWords[xHigh],
                 digits.y ^ wellstratWords[xLow + 1u] ^ wellstratWords[xHigh + 1u],
                 digits.z ^ wellstratWords[wellstratRankZ + low] ^
                     wellstratWords[wellstratRankZ + high]);
}

fn wellstratBlueDigits(context: vec2u, seed: u32) -> vec3u {
    let place = wellstratMovedPlace(context.x & 0xfffu, seed * 0x1f83d9abu);
    return wellstratRankedDigits(wellstratSequencePoint(seed, context.y), 0u,
                                 wellstratHalfWord(wellstratRanks, place));
}
fn wellstratBlueSlotDigits(context: vec2u, seed: u32, order: vec2u) -> vec3u {
    let rank = wellstratHalfWord(wellstratSlotRanks, context.x & 0xfffu);
    let digits = wellstratSlotDigits(seed & 0x7fffffffu, context.y, order);
    return wellstratRankedDigits(digits, order.x, rank);
}

fn wellstratBlueBits(context: vec2u, order: vec2u) -> vec3u {
    let seed = wellstratSequenceSeed(context.x >> 12u);
    var digits: vec3u;
    if (wellstratHasSlot(order)) {
        digits = wellstratBlueSlotDigits(context, seed, order);
    } else {
        digits = wellstratBlueDigits(context, seed);
    }
    if ((seed >> 31u) != 0u) { digits = digits.yxz; }
    return wellstratScrambledBits(digits, seed);
}

// The tables (lookup.h).

fn wellstratTableXY(word: u32) -> vec2u {
    return vec2u(word * 0xffff0f11u, wellstratUpperProduct(word, 0xffff0f11u));
}

fn wellstratTableBits(seed: u32, block: u32, group: u32, place: u32, withZ: bool) -> vec3u {
    let table = (((seed + block * 0x05555555u) >> 9u) * 384u) >> 23u;
    let offset = (group * 384u + table) * 256u + place;
    let xy = wellstratTableXY(wellstratWords[wellstratXY + offset]);
    var z = 0u;
    if (withZ) { z = wellstratWords[wellstratZ + offset] ^ (seed * 0x3c6ef373u); }
    return vec3u(xy.x ^ (seed * 0x84caa73bu),
                 xy.y ^ (wellstratUpperProduct(seed, 0x84caa73bu) + seed * 0xbb67ae85u),
                 z);
}

fn wellstratSampleBits(context: vec2u, withZ: bool) -> vec3u {
    let sampleid = context.y;
    if (sampleid >= 196608u) { return wellstratRandomBits(context); }
    let seed = wellstratMixBits(context.x + wellstratGolden);
    return wellstratTableBits(seed, sampleid >> 12u, (sampleid >> 8u) & 15u,
                              wellstratShuffledPlace(seed, sampleid), withZ);
}

// Slots of the tables (joint_lookup.h).

fn wellstratJointPlace(seed: u32, slot: u32, index: u32) -> u32 {
    let both = wellstratWords[wellstratJointLow + slot * 256u + (index & 255u)] ^
               wellstratWords[wellstratJointHigh + slot * 16u + (index >> 8u)];
    return (both >> (seed & 16u)) & 4095u;
}
fn wellstratWithReversedByte(place: u32) -> u32 {
    return (place & ~0xffu) | wellstratReverseByte(place);
}

fn wellstratJointIndex(seed: u32, sampleid: u32, order: vec2u) -> u32 {
    let split = order.y;
    let visit = sampleid / split;
    let mask = wellstratBitsBelowDifference(visit, 196608u / split) & 4095u;
    let place = wellstratJointPlace(seed, order.x, visit & mask);
    return ((visit & ~mask) | wellstratWithReversedByte(place)) * split +
           wellstratJointBranch(seed, visit, sampleid % split, split);
}

fn wellstratJointBits(context: vec2u, order: vec2u, withZ: bool) -> vec3u {
    if (!wellstratHasSlot(order)) { return wellstratSampleBits(context, withZ); }
    let sampleid = context.y;
    if (sampleid >= 196608u - 196608u % order.y) { return wellstratRandomBits(context); }
    let seed = wellstratMixBits(context.x + wellstratGolden);
    var block = sampleid >> 12u;
    var place: u32;
    if (order.y == 1u) {
        place = wellstratJointPlace(seed, order.x, sampleid & 4095u);
    } else {
        let index = wellstratJointIndex(seed, sampleid, order);
        block = index >> 12u;
        place = wellstratWithReversedByte(index & 4095u);
    }
    return wellstratTableBits(seed, block, place >> 8u, (place ^ seed) & 255u, withZ);
}

// Samples in [0, 1): z of a point in 1D, (x, y) in 2D, all three in 3D.

fn wellstratRandomSample1D(context: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratRandomBits(context).z);
}
fn wellstratRandomSample2D(context: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratRandomBits(context)).xy;
}
fn wellstratRandomSample3D(context: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratRandomBits(context));
}

fn wellstratSequenceSample1D(context: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratSequenceBits(context).z);
}
fn wellstratSequenceSample2D(context: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratSequenceBits(context)).xy;
}
fn wellstratSequenceSample3D(context: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratSequenceBits(context));
}

fn wellstratSample1D(context: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratSampleBits(context, true).z);
}
fn wellstratSample2D(context: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratSampleBits(context, false)).xy;
}
fn wellstratSample3D(context: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratSampleBits(context, true));
}

fn wellstratJointSample1D(context: vec2u, order: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratJointBits(context, order, true).z);
}
fn wellstratJointSample2D(context: vec2u, order: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratJointBits(context, order, false)).xy;
}
fn wellstratJointSample3D(context: vec2u, order: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratJointBits(context, order, true));
}

fn wellstratLongSample1D(context: vec2u, order: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratLongBits(context, order).z);
}
fn wellstratLongSample2D(context: vec2u, order: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratLongBits(context, order)).xy;
}
fn wellstratLongSample3D(context: vec2u, order: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratLongBits(context, order));
}

fn wellstratBlueSample1D(context: vec2u, order: vec2u) -> f32 {
    return wellstratToUnitFloat(wellstratBlueBits(context, order).z);
}
fn wellstratBlueSample2D(context: vec2u, order: vec2u) -> vec2f {
    return wellstratToUnitPoint(wellstratBlueBits(context, order)).xy;
}
fn wellstratBlueSample3D(context: vec2u, order: vec2u) -> vec3f {
    return wellstratToUnitPoint(wellstratBlueBits(context, order));
}
