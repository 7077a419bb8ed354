// SPDX-License-Identifier: Apache-2.0
//
// Two and three floats: the types in which samples, points and directions are handed over.
// `RtFloat2`, `RtVector3` and their kin in RiTypesHelper.h are these types, which is why the
// members carry RenderMan's names.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>
#include <type_traits>

// <cmath> is 20,000 lines, most of what including RixRNG.h would cost, so it is left out where the
// compiler has the two functions built in.
#if defined(__GNUC__) && (defined(__clang__) || !defined(__CUDACC__))
#define WELLSTRAT_BUILTIN_MATH 1
#else
#define WELLSTRAT_BUILTIN_MATH 0
#include <cmath>
#endif

namespace wellstrat {
inline namespace stream1 {

namespace detail {

#if WELLSTRAT_BUILTIN_MATH
WELLSTRAT_HOST_DEVICE inline float squareRoot(float x) { return __builtin_sqrtf(x); }
WELLSTRAT_HOST_DEVICE inline float copySign(float magnitude, float sign) {
    return __builtin_copysignf(magnitude, sign);
}
#else
WELLSTRAT_HOST_DEVICE inline float squareRoot(float x) { return std::sqrt(x); }
WELLSTRAT_HOST_DEVICE inline float copySign(float magnitude, float sign) {
    return std::copysign(magnitude, sign);
}
#endif

} // namespace detail

#undef WELLSTRAT_BUILTIN_MATH

/// Two and three coordinates of a sample as fractions of 2^32: the upper 24 bits of each are its
/// float. Not initialized by default.
struct Bits2 {
    uint32_t x, y;
};
struct Bits3 {
    uint32_t x, y, z;
};

/// A 2D sample or point. Not initialized by default: arrays of it cost nothing.
struct Float2 {
    float x, y;

    Float2() = default;
    WELLSTRAT_HOST_DEVICE constexpr Float2(float x_, float y_) : x(x_), y(y_) {}

    /// x or y, for i of 0 or 1. Other indices are not checked.
    WELLSTRAT_HOST_DEVICE constexpr float operator[](int i) const { return i == 0 ? x : y; }
    WELLSTRAT_HOST_DEVICE constexpr float& operator[](int i) { return i == 0 ? x : y; }
};

/// A 3D sample, point, vector or normal. Not initialized by default.
struct Float3 {
    float x, y, z;

    Float3() = default;
    WELLSTRAT_HOST_DEVICE constexpr explicit Float3(float s) : x(s), y(s), z(s) {}
    WELLSTRAT_HOST_DEVICE constexpr Float3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}

    /// x, y or z, for i of 0, 1 or 2. Other indices are not checked.
    WELLSTRAT_HOST_DEVICE constexpr float operator[](int i) const {
        return i == 0 ? x : i == 1 ? y : z;
    }
    WELLSTRAT_HOST_DEVICE constexpr float& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }

    WELLSTRAT_HOST_DEVICE constexpr float Dot(const Float3& b) const {
        return x * b.x + y * b.y + z * b.z;
    }
    /// The absolute value of Dot(b): of unit vectors, the cosine on either side of a surface.
    WELLSTRAT_HOST_DEVICE float AbsDot(const Float3& b) const {
        return detail::copySign(Dot(b), 1.0f);
    }
    WELLSTRAT_HOST_DEVICE constexpr Float3 Cross(const Float3& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    WELLSTRAT_HOST_DEVICE constexpr float LengthSq() const { return Dot(*this); }
    WELLSTRAT_HOST_DEVICE float Length() const { return detail::squareRoot(LengthSq()); }
    /// Scales to length 1 and returns the length it had. A zero vector stays as it is.
    WELLSTRAT_HOST_DEVICE float Normalize();
    /// Two unit vectors that form a right-handed frame (u, v, this). This vector has length 1.
    /// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
    WELLSTRAT_HOST_DEVICE void CreateOrthonormalBasis(Float3& u, Float3& v) const;
};

static_assert(std::is_trivially_copyable<Float2>::value && sizeof(Float2) == 8, "two floats");
static_assert(std::is_trivially_copyable<Float3>::value && sizeof(Float3) == 12, "three floats");

WELLSTRAT_HOST_DEVICE constexpr Float2 operator+(Float2 a, Float2 b) {
    return {a.x + b.x, a.y + b.y};
}
WELLSTRAT_HOST_DEVICE constexpr Float2 operator-(Float2 a, Float2 b) {
    return {a.x - b.x, a.y - b.y};
}
/// Component by component, as are all products of vectors; see Dot and Cross.
WELLSTRAT_HOST_DEVICE constexpr Float2 operator*(Float2 a, Float2 b) {
    return {a.x * b.x, a.y * b.y};
}
WELLSTRAT_HOST_DEVICE constexpr Float2 operator*(Float2 a, float s) { return {a.x * s, a.y * s}; }
WELLSTRAT_HOST_DEVICE constexpr Float2 operator*(float s, Float2 a) { return a * s; }
WELLSTRAT_HOST_DEVICE constexpr bool operator==(Float2 a, Float2 b) {
    return a.x == b.x && a.y == b.y;
}
WELLSTRAT_HOST_DEVICE constexpr bool operator!=(Float2 a, Float2 b) { return !(a == b); }

WELLSTRAT_HOST_DEVICE constexpr Float3 operator+(Float3 a, Float3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
WELLSTRAT_HOST_DEVICE constexpr Float3 operator-(Float3 a, Float3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
WELLSTRAT_HOST_DEVICE constexpr Float3 operator-(Float3 a) { return {-a.x, -a.y, -a.z}; }
WELLSTRAT_HOST_DEVICE constexpr Float3 operator*(Float3 a, Float3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
WELLSTRAT_HOST_DEVICE constexpr Float3 operator*(Float3 a, float s) {
    return {a.x * s, a.y * s, a.z * s};
}
WELLSTRAT_HOST_DEVICE constexpr Float3 operator*(float s, Float3 a) { return a * s; }
WELLSTRAT_HOST_DEVICE constexpr Float3 operator/(Float3 a, float s) {
    return {a.x / s, a.y / s, a.z / s};
}
WELLSTRAT_HOST_DEVICE constexpr Float3& operator+=(Float3& a, Float3 b) { return a = a + b; }
WELLSTRAT_HOST_DEVICE constexpr Float3& operator-=(Float3& a, Float3 b) { return a = a - b; }
WELLSTRAT_HOST_DEVICE constexpr Float3& operator*=(Float3& a, Float3 b) { return a = a * b; }
WELLSTRAT_HOST_DEVICE constexpr Float3& operator*=(Float3& a, float s) { return a = a * s; }
WELLSTRAT_HOST_DEVICE constexpr Float3& operator/=(Float3& a, float s) { return a = a / s; }
WELLSTRAT_HOST_DEVICE constexpr bool operator==(Float3 a, Float3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}
WELLSTRAT_HOST_DEVICE constexpr bool operator!=(Float3 a, Float3 b) { return !(a == b); }

/// The members as free functions, which published plug-ins use too.
WELLSTRAT_HOST_DEVICE constexpr float Dot(const Float3& a, const Float3& b) { return a.Dot(b); }
WELLSTRAT_HOST_DEVICE inline float AbsDot(const Float3& a, const Float3& b) { return a.AbsDot(b); }
WELLSTRAT_HOST_DEVICE constexpr Float3 Cross(const Float3& a, const Float3& b) {
    return a.Cross(b);
}

WELLSTRAT_HOST_DEVICE inline float Float3::Normalize() {
    const float length = Length();
    if (length > 0.0f) *this /= length;
    return length;
}

WELLSTRAT_HOST_DEVICE inline void Float3::CreateOrthonormalBasis(Float3& u, Float3& v) const {
    const float sign = detail::copySign(1.0f, z);
    const float a = -1.0f / (sign + z);
    const float b = x * y * a;
    u = {1.0f + sign * x * x * a, sign * b, -sign * x};
    v = {b, sign + y * y * a, -y};
}

} // namespace stream1
} // namespace wellstrat
