// SPDX-License-Identifier: Apache-2.0
#include "camera.h"

#include "wellstrat/warp.h"

#include <cmath>

namespace wellstrat::render {

PictureCamera::PictureCamera(const Camera& camera, unsigned width, unsigned height)
    : position_(camera.position), isOrthographic_(camera.orthographicHeight > 0.0f),
      toFocus_(camera.forward * camera.focusDistance) {
    const Float3 right = Cross(camera.forward, camera.up);
    const float focus = camera.focusDistance;
    const float halfHeight = isOrthographic_ ? 0.5f * camera.orthographicHeight
                                             : focus * std::tan(0.5f * camera.verticalFov);
    const float pixel = 2.0f * halfHeight / static_cast<float>(height);
    stepX_ = right * pixel;
    stepY_ = camera.up * -pixel;
    corner_ = toFocus_ - stepX_ * (0.5f * static_cast<float>(width)) -
              stepY_ * (0.5f * static_cast<float>(height));
    lensX_ = right * camera.lensRadius;
    lensY_ = camera.up * camera.lensRadius;
}

Ray PictureCamera::ray(Float2 picture, Float2 lens, float time) const {
    const Float2 disk = squareToDiskConcentric(lens);
    const Float3 onLens = lensX_ * disk.x + lensY_ * disk.y;
    Ray ray;
    ray.origin = position_ + onLens;
    const Float3 inFocus = corner_ + stepX_ * picture.x + stepY_ * picture.y;
    if (isOrthographic_) {
        ray.origin += inFocus - toFocus_;
        ray.direction = toFocus_ - onLens;
    } else {
        ray.direction = inFocus - onLens;
    }
    ray.direction.Normalize();
    ray.time = time;
    return ray;
}

} // namespace wellstrat::render
