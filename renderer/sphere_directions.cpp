// SPDX-License-Identifier: Apache-2.0
#include "sphere_directions.h"

#include <algorithm>
#include <cmath>

namespace wellstrat::render {

namespace {

/// Below this, 1 - cosine loses too many digits; directions are then chosen by their point in the
/// plane across the axis, where the sphere is a disk. Their density varies by 1.5 times this.
constexpr float kNarrow = 0x1p-8f;

/// The density of a direction with this cosine to the axis, whose points in the plane at distance 1
/// are uniform on a disk.
float diskDirectionPdf(float sinSquared, float cosine) {
    const float tanSquared = sinSquared / (1.0f - sinSquared);
    return detail::kInvPi / (tanSquared * cosine * cosine * cosine);
}

} // namespace

SphereDirections::SphereDirections(Float3 toCenter, float radius)
    : toCenter_(toCenter), axis_(toCenter), radius_(radius) {
    const float distance = axis_.Normalize();
    inside_ = !(distance > radius);
    if (inside_) return;
    const float sine = radius / distance;
    sinSquared_ = sine * sine;
    cosine_ = std::sqrt((1.0f - sine) * (1.0f + sine));
}

Float3 SphereDirections::sample(Float2 xi) const {
    if (inside_) return squareToSphere(xi);
    Float3 local;
    if (sinSquared_ < kNarrow) {
        const float tangent = std::sqrt(sinSquared_) / cosine_;
        const Float2 disk = squareToDiskConcentric(xi) * tangent;
        local = {disk.x, disk.y, 1.0f};
        local.Normalize();
    } else {
        local = squareToCone(xi, cosine_);
    }
    Float3 u, v;
    axis_.CreateOrthonormalBasis(u, v);
    return u * local.x + v * local.y + axis_ * local.z;
}

float SphereDirections::pdf(Float3 direction) const {
    if (inside_) return spherePdf();
    if (sinSquared_ < kNarrow) return diskDirectionPdf(sinSquared_, Dot(direction, axis_));
    return conePdf(cosine_);
}

float SphereDirections::distance(Float3 direction) const {
    const float middle = Dot(toCenter_, direction);
    const float asideSq = (toCenter_ - direction * middle).LengthSq();
    const float half = std::sqrt(std::max(0.0f, radius_ * radius_ - asideSq));
    return inside_ ? middle + half : middle - half;
}

} // namespace wellstrat::render
