// SPDX-License-Identifier: Apache-2.0
//
// A kernel for each kind of draw, from the pixel to the sample: what scripts/bench --device counts
// the instructions of, and what must compile without a warning for every GPU. Each thread has a
// pixel of its own, and takes a sample of one domain of it.

#include "RixRNGInline.h"
#include "RixShadingUtils.h"
#include "examples/gpu/pixel.h"
#include "wellstrat/camera.h"
#include "wellstrat/device_tables.h"

using namespace wellstrat;

namespace {

constexpr Scramble kLight{0x91e4c05a};

struct Place {
    unsigned x, y;
};

__device__ Place place() { return {threadIdx.x, blockIdx.x}; }

template <typename T>
__device__ T& mine(T* out) {
    return out[blockIdx.x * 256u + threadIdx.x];
}

__device__ SampleCtx light(unsigned sampleid) {
    const Place p = place();
    return cameraContext(static_cast<int>(p.x), static_cast<int>(p.y), 0, sampleid)
        .NewDomain(kLight);
}

__device__ SampleCtx blueLight(unsigned sampleid) {
    const Place p = place();
    return newBlueDomainSplit(
        blueContext(static_cast<int>(p.x), static_cast<int>(p.y), 0, sampleid), kLight, 1);
}

} // namespace

extern "C" {

__global__ void context(unsigned sampleid, SampleCtx* out) { mine(out) = light(sampleid); }

__global__ void table_1d(const DeviceTables* tables, unsigned sampleid, float* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = sample1D(tables->words, sc.patternid, sc.sampleid);
}

__global__ void table_2d(const DeviceTables* tables, unsigned sampleid, Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = sample2D(tables->words, sc.patternid, sc.sampleid);
}

__global__ void table_3d(const DeviceTables* tables, unsigned sampleid, Float3* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = sample3D(tables->words, sc.patternid, sc.sampleid);
}

__global__ void table_2d_four(const DeviceTables* tables, unsigned sampleid, Float2* out) {
    SampleCtx sc = light(sampleid);
    Float2 sum{0.0f, 0.0f};
    for (unsigned bounce = 0; bounce < 4; ++bounce) {
        sum = sum + sample2D(tables->words, sc.patternid, sc.sampleid);
        sc = sc.NewDomain(kLight);
    }
    mine(out) = sum;
}

__global__ void joint_2d(const DeviceTables* tables, unsigned sampleid, unsigned slot,
                         Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) =
        jointSample2D(tables->words, tables->jointOrders, sc.patternid, sc.sampleid, slot, 1);
}

__global__ void joint_2d_split(const DeviceTables* tables, unsigned sampleid, Order order,
                               Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = jointSample2D(tables->words, tables->jointOrders, sc.patternid, sc.sampleid,
                              order.slot, order.splits);
}

__global__ void long_2d(unsigned sampleid, Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = sequenceSample2D(sc.patternid, sc.sampleid);
}

__global__ void long_3d(unsigned sampleid, Float3* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = sequenceSample3D(sc.patternid, sc.sampleid);
}

__global__ void long_slot_2d(const DeviceTables* tables, unsigned sampleid, unsigned slot,
                             Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = jointSequenceSample2D(tables->slotOrders, sc.patternid, sc.sampleid, slot, 1);
}

__global__ void long_slot_2d_split(const DeviceTables* tables, unsigned sampleid, Order order,
                                   Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = jointSequenceSample2D(tables->slotOrders, sc.patternid, sc.sampleid, order.slot,
                                      order.splits);
}

__global__ void blue_2d(const DeviceTables* tables, unsigned sampleid, Float2* out) {
    const SampleCtx sc = blueLight(sampleid);
    mine(out) = blueSample2D(tables->blueTables, sc.patternid, sc.sampleid);
}

__global__ void blue_slot_2d(const DeviceTables* tables, unsigned sampleid, unsigned slot,
                             Float2* out) {
    const SampleCtx sc = blueLight(sampleid);
    mine(out) = blueSlotSample2D(tables->blueTables, tables->slotOrders, sc.patternid, sc.sampleid,
                                 slot, 1);
}

__global__ void random_2d(unsigned sampleid, Float2* out) {
    const SampleCtx sc = light(sampleid);
    mine(out) = randomSample2D(sc.patternid, sc.sampleid);
}

__global__ void distribution(unsigned sampleid, SampleCtx* out, SampleCtx* blueOut) {
    mine(out) = light(sampleid).NewDomainDistrib(kLight, 0);
    mine(blueOut) = newBlueDomainDistrib(blueLight(sampleid), kLight, 0);
}

/// A small integrator.
__global__ void area_light_pixel(const DeviceTables* tables, unsigned samples, Float3* out) {
    const Place p = place();
    mine(out) = area_light::renderPixel(tables->words, 256, p.x, p.y, samples);
}

/// The rest of what a kernel may call.
__global__ void shading(const float* weights, unsigned n, unsigned sampleid, Float3* out) {
    const SampleCtx sc = light(sampleid);
    float xi = HashToRandom(sc.patternid, sc.sampleid);
    const float other = xi;
    const unsigned chosen = RixChooseAndRemap(xi, 0.25f) + RixChooseAndRemap(xi, weights, n);
    const Float2 square{xi, other};
    RtVector3 direction, axisX, axisY;
    RtFloat cosine;
    switch (chosen) {
    case 0: RixCosDirectionalDistribution(square, {0.0f, 0.0f, 1.0f}, direction, cosine); break;
    case 1: RixUniformDirectionalDistribution(square, {0.0f, 0.0f, 1.0f}, direction, cosine); break;
    case 2: direction = squareToGgxVisibleNormal(square, {0.0f, 0.0f, 1.0f}, 0.3f, 0.4f); break;
    case 3: direction = squareToPowerCosine(square, 7.0f); break;
    case 4: direction = squareToCone(square, 0.5f); break;
    case 5: direction = squareToCylinder(square); break;
    default: direction = squareToSphere(square);
    }
    direction.CreateOrthonormalBasis(axisX, axisY);
    const Float2 back = hemisphereCosineToSquare(axisX) + powerCosineToSquare(axisY, 7.0f);
    mine(out) =
        RixReflect(direction, axisX) * RixFresnelDielectric(back.x, 1.5f) +
        RixGetForwardFacingNormal(axisY, direction) * RixFresnelConductor(back.y, 0.2f, 3.0f);
}

} // extern "C"
